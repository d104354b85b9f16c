//! c^n by table look-up, as Fast Phong takes the highlight's power (Bishop & Weimer 1986).

/// Cells of a table.
const CELLS: usize = 1024;

/// Below this the power counts as 0.
const SMALLEST: f64 = 1e-8;

/// c^n for one n, over the cosines c for which it can be seen, linear between the entries.
///
/// The table is divided evenly from c = 10^(−8/n) to 1. There c^n is a function of n·ln c alone, nearly, so that the error
/// is the same for every n ≥ 1: at most 5·10⁻⁵ of a full highlight. (A table from 0 to 1 has its whole highlight in one cell when n is 1000.)
#[derive(Clone, Debug)]
pub struct PowerTable {
    /// The cosine of the first entry.
    start: f64,
    cells_a_unit: f64,
    entries: Box<[f64]>,
}

impl PowerTable {
    pub fn new(exponent: f64) -> Self {
        let start = if exponent > 0.0 {
            // For the largest exponents all cosines but 1 have no highlight, to the last digit.
            SMALLEST.powf(1.0 / exponent).min(1.0 - f64::EPSILON)
        } else {
            0.0
        };
        let width = 1.0 - start;
        let entry = |cell: usize| {
            let share = cell as f64 / CELLS as f64;
            match cell {
                0 if exponent > 0.0 => 0.0,
                CELLS => 1.0,
                _ => (start + share * width).powf(exponent),
            }
        };
        PowerTable {
            start,
            cells_a_unit: CELLS as f64 / width,
            entries: (0..=CELLS).map(entry).collect(),
        }
    }

    /// max(0, c)^n. A cosine is at most 1: beyond, an approximation of one counts as 1.
    #[inline]
    pub fn power(&self, cosine: f64) -> f64 {
        let place = ((cosine.min(1.0) - self.start) * self.cells_a_unit).max(0.0);
        let cell = (place as usize).min(CELLS - 1);
        let share = place - cell as f64;
        self.entries[cell] + share * (self.entries[cell + 1] - self.entries[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_is_the_same_for_every_exponent_from_one_up() {
        let mut largest = 0_f64;
        for exponent in [1.0, 2.0, 5.5, 20.0, 40.0, 1e3, 1e6] {
            let table = PowerTable::new(exponent);
            for i in 0..=100_000 {
                // Evenly over the highlight, whatever its width: u = −n·ln c
                let cosine = (-25.0 * f64::from(i) / 1e5 / exponent).exp();
                let error = (table.power(cosine) - cosine.powf(exponent)).abs();
                largest = largest.max(error);
            }
        }
        // A linear function between entries is off by at most (Δu)²/8, Δu = 8·ln 10/1024.
        assert!((3e-5..5e-5).contains(&largest), "{largest:e}");
    }

    #[test]
    fn what_is_no_cosine_has_the_power_of_the_nearest() {
        let table = PowerTable::new(20.0);
        assert_eq!(
            [-0.5, 0.0, 1.0, 1.7].map(|c| table.power(c)),
            [0.0, 0.0, 1.0, 1.0]
        );
        assert_eq!(table.power(f64::NAN), 1.0);
        // n = 0: the highlight is everywhere.
        let constant = PowerTable::new(0.0);
        assert_eq!([-0.5, 0.0, 0.3, 1.0].map(|c| constant.power(c)), [1.0; 4]);
        for exponent in [1e-300, 0.5, 1e17, 1e300, f64::MAX] {
            let table = PowerTable::new(exponent);
            assert_eq!(table.power(1.0), 1.0);
            assert!((0.0..=1.0).contains(&table.power(0.999)));
        }
    }
}
