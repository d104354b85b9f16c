//! The Pareto front: the settings that no other one beats both in time and in error.

/// Whether each (time, error) is on the front: none other is as quick and as exact, and better in one of the two.
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let beats = |(time, error): (f64, f64), other: (f64, f64)| {
        time <= other.0 && error <= other.1 && (time < other.0 || error < other.1)
    };
    let on_front = |&point: &(f64, f64)| {
        let is_point = !point.0.is_nan() && !point.1.is_nan();
        is_point && !points.iter().any(|&other| beats(other, point))
    };
    points.iter().map(on_front).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beaten_is_not_on_the_front() {
        let points = [
            (1.0, 1.0),
            (2.0, 0.5),
            (2.0, 0.6),
            (3.0, 0.5),
            (4.0, 0.1),
            (5.0, f64::NAN),
        ];
        assert_eq!(front(&points), [true, true, false, false, true, false]);
    }

    #[test]
    fn equals_stand_side_by_side() {
        assert_eq!(
            front(&[(1.0, 0.0), (1.0, 0.0), (2.0, 0.0)]),
            [true, true, false]
        );
    }

    proptest::proptest! {
        #[test]
        fn every_point_is_on_the_front_or_beaten_by_one_that_is(
            points in proptest::collection::vec((0.0..4.0_f64, 0.0..4.0_f64), 1..30)
        ) {
            let points: Vec<(f64, f64)> = points.iter().map(|p| (p.0.round(), p.1.round())).collect();
            let on_front = front(&points);
            for (point, on) in points.iter().zip(&on_front) {
                let beaten = points.iter().zip(&on_front).any(|(other, &on)| {
                    on && other.0 <= point.0 && other.1 <= point.1 && other != point
                });
                proptest::prop_assert_eq!(*on, !beaten);
            }
        }
    }
}
