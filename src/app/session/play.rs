//! Playing: steps in time, forward or backward, in a loop, up to a question or a breakpoint.

use super::Session;
use super::playing::{Direction, Play, SPEEDS};

impl Session {
    pub fn playing(&self) -> Option<Direction> {
        self.play.map(|play| play.direction)
    }

    /// Steps a second.
    pub fn speed(&self) -> f64 {
        SPEEDS[self.speed]
    }

    /// First and last step of the loop.
    pub fn loop_range(&self) -> Option<(usize, usize)> {
        self.around.range()
    }

    /// The ends of the loop that are set.
    pub fn loop_ends(&self) -> (Option<usize>, Option<usize>) {
        (self.around.from, self.around.to)
    }

    pub(super) fn change_speed(&mut self, by: isize) -> bool {
        let speed = self
            .speed
            .checked_add_signed(by)
            .filter(|&speed| speed < SPEEDS.len());
        self.speed = speed.unwrap_or(self.speed);
        speed.is_some()
    }

    /// Starts to play that way; pauses what plays that way already.
    pub(super) fn play(&mut self, direction: Direction) {
        self.play = match self.playing() {
            Some(playing) if playing == direction => None,
            _ => Some(Play {
                direction,
                due: 0.0,
            }),
        };
    }

    /// Whether playing that way could go on from here.
    pub(super) fn can_play(&self, direction: Direction) -> bool {
        self.loop_range().is_some()
            || match direction {
                Direction::Forward => self.step() < self.last_step(),
                Direction::Backward => self.step() > 0,
            }
    }

    /// Lets time pass. Playing stops at breakpoints, at questions and at both ends.
    pub fn advance(&mut self, seconds: f64) {
        let speed = self.speed();
        let Some(play) = &mut self.play else { return };
        play.due += seconds.clamp(0.0, 1.0) * speed;
        let steps = play.due.floor();
        play.due -= steps;
        let direction = play.direction;
        let mut left = steps as usize;
        while left > 0 && self.play.is_some() {
            left -= match direction {
                Direction::Forward => self.play_forward(left),
                Direction::Backward => self.play_backward(left),
            };
        }
    }

    /// Plays up to `most` steps on, to the next place where something happens; how many it took, at least 1.
    fn play_forward(&mut self, most: usize) -> usize {
        let here = self.step();
        let (from, end) = self.loop_range().unwrap_or((0, self.last_step()));
        if self.question_at(here) {
            self.play = None;
            return 1;
        }
        if here >= end {
            if self.loop_range().is_some() {
                self.seek(from);
            } else {
                self.play = None;
            }
            return 1;
        }
        let target = here.saturating_add(most).min(end);
        let stops = |step: &usize| {
            self.question_at(*step) || self.breakpoints().binary_search(step).is_ok()
        };
        let stop = (here + 1..=target).find(stops);
        self.seek(stop.unwrap_or(target));
        if stop.is_some() || self.loop_range().is_none() && target == self.last_step() {
            self.play = None;
        }
        self.step() - here
    }

    fn play_backward(&mut self, most: usize) -> usize {
        let here = self.step();
        let (start, to) = self.loop_range().unwrap_or((0, self.last_step()));
        if here <= start {
            match self.loop_range() {
                // A question on the way around would be jumped over.
                Some(_) if self.question_between(here, to).is_none() => self.seek(to),
                _ => self.play = None,
            }
            return 1;
        }
        let target = here.saturating_sub(most).max(start);
        let stop = (target..here)
            .rev()
            .find(|step| self.breakpoints().binary_search(step).is_ok());
        self.seek(stop.unwrap_or(target));
        if stop.is_some() || self.step() == 0 && self.loop_range().is_none() {
            self.play = None;
        }
        here - self.step()
    }
}
