//! The rays of pixels beside the one that is followed, for the scene in space.

use super::Session;
use crate::algorithms::focus::Focus;
use crate::panels::Pixels;
use crate::replay::{FanRay, fan};

/// What rays were found for: the recording, the choice, and the pixel around which it was made.
type Key = (u64, Pixels, (u32, u32));

#[derive(Default)]
pub struct Fan {
    key: Option<Key>,
    rays: Vec<FanRay>,
    version: u64,
}

impl Fan {
    pub fn rays(&self) -> &[FanRay] {
        &self.rays
    }

    /// Changes with the rays.
    pub fn version(&self) -> u64 {
        self.version
    }
}

impl Session {
    /// Finds the rays of the pixels that are chosen, where they are others than before.
    pub fn follow_pixels(&mut self) {
        let key = self.fan_key();
        if key == self.fan.key {
            return;
        }
        let rays = key.map(|(_, pixels, around)| {
            let view = &self.open.run.prepared().view;
            let pixels = pixels.around(around, [view.width, view.height]);
            fan(&self.open.setup, self.open.run.method(), &pixels)
        });
        self.fan = Fan {
            key,
            rays: rays.unwrap_or_default(),
            version: self.fan.version + 1,
        };
    }

    fn fan_key(&self) -> Option<Key> {
        let pixels = self.space.rays.pixels;
        let state = self.open.run.rays().filter(|_| pixels != Pixels::Current)?;
        let around = match (state.pixel, self.focus) {
            (Some(pixel), _) => pixel,
            (None, Focus::Pixel { x, y }) => (x, y),
            (None, _) => return None,
        };
        // A grid and a row are the same around other pixels of them.
        let around = match pixels {
            Pixels::Grid => (0, 0),
            Pixels::Row => (0, around.1),
            Pixels::Block | Pixels::Current => around,
        };
        Some((self.recording, pixels, around))
    }
}
