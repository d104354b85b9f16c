//! How far values are off what is right.

/// Absolute errors in the unit of the values; `relative` is the rms error as a share of the rms of what is right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    pub rms: f64,
    pub largest: f64,
    pub relative: f64,
}

impl Errors {
    /// Where `truth` is NaN nothing is compared. None where that leaves nothing, or the lists differ in length.
    pub fn of(found: &[f64], truth: &[f64]) -> Option<Errors> {
        if found.len() != truth.len() {
            return None;
        }
        let (mut count, mut squares, mut true_squares, mut largest) = (0.0, 0.0, 0.0, 0.0_f64);
        for (&found, &truth) in found.iter().zip(truth) {
            if truth.is_nan() {
                continue;
            }
            let error = found - truth;
            count += 1.0;
            squares += error * error;
            true_squares += truth * truth;
            // A NaN that was found is an error without bounds.
            largest = if error.is_nan() {
                f64::INFINITY
            } else {
                largest.max(error.abs())
            };
        }
        if count == 0.0 {
            return None;
        }
        let unbounded = largest == f64::INFINITY;
        let rms = if unbounded {
            largest
        } else {
            f64::sqrt(squares / count)
        };
        let relative = match true_squares {
            0.0 if rms == 0.0 => 0.0,
            true_squares => rms / f64::sqrt(true_squares / count),
        };
        Some(Errors {
            rms,
            largest,
            relative,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_those_of_the_definition() {
        let errors = Errors::of(&[3.0, 0.0, 7.0], &[0.0, 4.0, f64::NAN]).unwrap();
        assert!((errors.rms - 12.5_f64.sqrt()).abs() < 1e-15);
        assert_eq!(errors.largest, 4.0);
        assert!((errors.relative - (25.0_f64 / 16.0).sqrt()).abs() < 1e-15);
        assert_eq!(
            Errors::of(&[1.0], &[1.0]).map(|errors| errors.relative),
            Some(0.0)
        );
    }

    #[test]
    fn what_cannot_be_compared_has_no_error_and_a_nan_is_no_small_one() {
        assert_eq!(Errors::of(&[1.0], &[f64::NAN]), None);
        assert_eq!(Errors::of(&[1.0], &[1.0, 2.0]), None);
        let lost = Errors::of(&[f64::NAN, 1.0], &[0.0, 1.0]).unwrap();
        assert_eq!((lost.rms, lost.largest), (f64::INFINITY, f64::INFINITY));
    }
}
