//! Fast Phong in the state of the scan-line methods: of what it tells, all but its series goes where theirs does.

use super::Fold;
use super::shading::State;
use crate::algorithms::fast_phong::{Event, FastPhong};
use crate::algorithms::flat::Nothing;
use crate::algorithms::shading;

impl Fold<Event> for State<Nothing> {
    fn apply(&mut self, step: usize, event: &Event) {
        if let Event::Shading(event) = event {
            Fold::<shading::Event<FastPhong>>::apply(self, step, event);
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        Fold::<shading::Event<FastPhong>>::bytes_beyond(self, before)
    }
}
