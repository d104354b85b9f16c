//! Random runs for tests: any nesting, any limit of the recording.

use crate::record::{Event, Fields, Line, Listing, Mark, Recorder, Recording, RecordingLimit};
use crate::replay::Fold;
use crate::vocabulary::{Declared, Kind};
use proptest::prelude::*;

/// An event with a few values, some of them missing, so that inner and outer scopes have different values.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Note(pub u8);

impl Event for Note {
    fn kind(&self) -> &'static str {
        ["Red", "Green", "Blue"][self.0 as usize % 3]
    }
    fn line(&self) -> Line {
        static LISTING: Listing = Listing {
            name: "notes",
            lines: &[
                ("", "0"),
                ("", "1"),
                ("", "2"),
                ("", "3"),
                ("", "4"),
                ("", "5"),
                ("", "6"),
            ],
        };
        Line {
            listing: &LISTING,
            number: self.0 as usize % 7,
        }
    }
    fn fields(&self, fields: &mut Fields) {
        let number = i32::from(self.0);
        for (bit, name) in ["a", "b", "c"].into_iter().enumerate() {
            if number >> bit & 1 == 1 {
                fields.push(name, number / 8);
            }
        }
    }
}

impl Declared for Note {
    fn declaration(&self, fields: Option<&mut Fields>) -> (&'static Kind, &'static str) {
        const fn kind(name: &'static str) -> Kind {
            Kind {
                name,
                quantities: &[],
                labels: &[],
                scope: None,
                numbers: &[],
                entries: &[],
            }
        }
        static KINDS: [Kind; 3] = [kind("Red"), kind("Green"), kind("Blue")];
        if let Some(fields) = fields {
            self.fields(fields);
        }
        (&KINDS[self.0 as usize % 3], "")
    }
}

/// All events so far: a state that forgets nothing shows every wrong, missing or repeated event.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct History(pub Vec<(usize, Note)>);

impl Fold<Note> for History {
    fn apply(&mut self, step: usize, event: &Note) {
        self.0.push((step, *event));
    }

    fn bytes_beyond(&self, _: &Self) -> usize {
        self.0.len()
    }
}

/// The events of a run, and how many the recording may keep.
#[derive(Clone, Debug)]
pub struct Trace {
    steps: Vec<(Mark, u8)>,
    most: usize,
}

impl Trace {
    /// `(` enters, `)` leaves, anything else is a step.
    pub fn parse(text: &str) -> Self {
        let steps = text
            .chars()
            .zip((0..=255).cycle())
            .map(|(character, number)| {
                let mark = match character {
                    '(' => Mark::Enter,
                    ')' => Mark::Leave,
                    _ => Mark::Step,
                };
                (mark, number)
            });
        Trace {
            steps: steps.collect(),
            most: usize::MAX,
        }
    }

    pub fn recording(&self) -> Recording<Note> {
        let bytes_an_event = (1 << 20) / RecordingLimit(1 << 20).events::<Note>();
        let mut recording =
            Recording::new(RecordingLimit(self.most.saturating_mul(bytes_an_event)));
        for &(mark, number) in &self.steps {
            let note = || Note(number);
            match mark {
                Mark::Step => recording.step(note),
                Mark::Enter => recording.enter(note),
                Mark::Leave => recording.leave(note),
            }
        }
        recording
    }
}

/// Balanced: a leave too many is dropped, scopes left open are closed at the end.
pub fn trace() -> impl Strategy<Value = Trace> {
    let mark = prop_oneof![
        3 => Just(Mark::Step),
        2 => Just(Mark::Enter),
        2 => Just(Mark::Leave),
    ];
    let steps = prop::collection::vec((mark, any::<u8>()), 0..120);
    let most = prop_oneof![Just(usize::MAX), 0..100_usize];
    (steps, most).prop_map(|(steps, most)| {
        let mut open = 0;
        let mut balanced: Vec<_> = steps
            .into_iter()
            .filter(|(mark, _)| {
                match mark {
                    Mark::Step => {}
                    Mark::Enter => open += 1,
                    Mark::Leave if open == 0 => return false,
                    Mark::Leave => open -= 1,
                }
                true
            })
            .collect();
        balanced.extend(vec![(Mark::Leave, 255); open]);
        Trace {
            steps: balanced,
            most,
        }
    })
}
