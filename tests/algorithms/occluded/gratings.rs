//! A plate of bars half way between floor and lid, 5 % open: it passes the same light however finely floor and lid are divided.

use super::*;

const HEIGHT: f64 = 4.0;

/// Where the gaps between the bars begin, each of them [`GAP`] wide.
fn gaps() -> impl Iterator<Item = f64> {
    (-20..40).map(|k| 0.05 * f64::from(k))
}

const GAP: f64 = 0.0025;

/// F from a part of the floor to a part of the lid: from a point x through each gap one sees a strip that is twice as wide.
fn exact([x, z]: [[f64; 2]; 2], [of_lid, z_of_lid]: [[f64; 2]; 2]) -> f64 {
    exact::mean(&x, 40, |x| {
        exact::mean(&z, 2, |z| {
            let strips = gaps().map(|gap| [2.0 * gap - x, 2.0 * (gap + GAP) - x]);
            let seen = strips.map(|[low, high]| [low.max(of_lid[0]), high.min(of_lid[1])]);
            let seen = seen.filter(|[low, high]| low < high);
            let of = |strip| {
                exact::from_point([x, 0.0, z], [0.0, 1.0, 0.0], &lid(strip, HEIGHT, z_of_lid))
            };
            seen.map(of).sum()
        })
    })
}

#[test]
fn a_grating_passes_its_share_of_the_light_at_every_division() {
    for side in [1, 16, 64, 256] {
        let mut polygons = vec![
            (floor(UNIT, 0.0, UNIT), side),
            (lid(UNIT, HEIGHT, UNIT), side),
        ];
        let bar = |gap: f64| floor([gap + GAP, gap + 0.05], 0.5 * HEIGHT, [-2.0, 3.0]);
        polygons.extend(gaps().map(|gap| (bar(gap), 1)));
        let scene = scene(&polygons);
        let patches = Patches::of(&scene, 200_000).unwrap();
        let blockers = Blockers::of(&scene, &patches);
        let factors = FormFactors::new(&patches, METHOD, Some(&blockers));
        // From a patch of the floor to those of the lid that lie above its row.
        let width = 1.0 / f64::from(side);
        let span = |k: u32| [f64::from(k) * width, f64::from(k + 1) * width];
        let (x, z) = (span(side / 3), span(side / 2));
        let lies_in = |x: f64, [low, high]: [f64; 2]| low < x && x < high;
        let with_center = |height: f64, x: [f64; 2]| {
            let places = patches.iter().enumerate().filter(move |(_, patch)| {
                patch.center.y == height && lies_in(patch.center.x, x) && lies_in(patch.center.z, z)
            });
            places.map(|(number, _)| number)
        };
        let i = with_center(0.0, x).next().unwrap();
        let above: Vec<usize> = with_center(HEIGHT, UNIT).collect();
        assert_eq!(above.len(), side as usize);
        let pair = |j| factors.pair(i, j, &mut Unrecorded);
        let found: f64 = above.into_iter().map(pair).sum();
        let right = exact([x, z], [UNIT, z]);
        println!("{side}: {found:e} for {right:e}");
        assert!(
            (found / right - 1.0).abs() < 0.02,
            "{side}: {found} for {right}"
        );
    }
}
