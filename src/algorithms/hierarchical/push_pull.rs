//! PushPullRad: what was gathered at any level goes down to the leaves, and the leaves make the means of the levels above.

use super::event::Event;
use super::hierarchy::Hierarchy;
use crate::color::Rgb;
use crate::record::Recorder;

impl Hierarchy<'_> {
    /// PushPullRad(p, B_down). Radiosity is light per area: it goes down as it is, and up as the mean by area.
    pub fn push_pull<R: Recorder<Event>>(&mut self, p: u32, b_down: Rgb, recorder: &mut R) -> Rgb {
        let b_g = self.b_g[p as usize];
        recorder.enter(|| Event::PushedDown { p, b_g, b_down });
        let b_p = if self.element(p).children.is_none() {
            let e_p = self.element(p).emission;
            let b_p = e_p + b_g + b_down;
            recorder.leave(|| Event::LeafLit { b_p, e_p });
            b_p
        } else {
            let mut sum = Rgb::BLACK;
            for child in self.element(p).children() {
                let b_q = self.push_pull(child, b_g + b_down, recorder);
                let share = self.element(child).area / self.element(p).area;
                sum += b_q * share;
                recorder.step(|| Event::ChildPulled {
                    child,
                    share,
                    b_q,
                    sum,
                });
            }
            recorder.leave(|| Event::PulledUp { b_p: sum });
            sum
        };
        self.b[p as usize] = b_p;
        b_p
    }
}
