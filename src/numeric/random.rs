//! Numbers that look random and are the same in every run.

use glam::DVec3;

/// SplitMix64 (Steele, Lea & Flood 2014), started from any seed.
pub struct Random(pub u64);

impl Random {
    /// All 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [−1, 1).
    pub fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// In the cube [−1, 1)³.
    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    /// A unit vector.
    pub fn direction(&mut self) -> DVec3 {
        self.point().normalize_or(DVec3::X)
    }
}
