use super::polygon::Polygon;
use super::*;
use crate::record::Unrecorded;
use glam::{DMat3, DVec3};

fn polygon(corners: &[DVec3]) -> Polygon<'_> {
    let normal = (corners[1] - corners[0])
        .cross(corners[2] - corners[0])
        .normalize();
    Polygon::new(corners.into(), normal).unwrap()
}

fn square(origin: DVec3, along: DVec3, across: DVec3) -> [DVec3; 4] {
    [
        origin,
        origin + along,
        origin + along + across,
        origin + across,
    ]
}

fn pair(i: &[DVec3], j: &[DVec3], tolerance: f64) -> f64 {
    let (i, j) = (polygon(i), polygon(j));
    let slack = 1e-13;
    let (Some(a), Some(b)) = (
        i.clone().in_front_of(&j, slack),
        j.clone().in_front_of(&i, slack),
    ) else {
        return 0.0;
    };
    auto::exchange(&a, &b, tolerance, &mut Unrecorded) / i.area
}

#[test]
fn known() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    for tol in [1e-3, 1e-6, 1e-9] {
        for (d, f) in [
            (1.0, 0.199824895698387383),
            (0.1, 0.826994522397256578),
            (100.0, 3.18288667328291964e-5),
            (1000.0, 3.18309673977380257e-7),
        ] {
            let got = pair(&square(DVec3::ZERO, x, y), &square(d * z, y, x), tol);
            eprintln!("tol {tol:e} parallel {d}: {got} rel {:e}", got / f - 1.0);
        }
        for (angle, f) in [
            (90.0_f64, 0.200043776075403154),
            (30.0, 0.619028323090803253),
            (150.0, 0.0213453254126893704),
        ] {
            let (s, c) = angle.to_radians().sin_cos();
            let got = pair(
                &square(DVec3::ZERO, x, y),
                &square(DVec3::ZERO, c * y + s * z, x),
                tol,
            );
            let m = DMat3::from_rotation_x(0.3) * DMat3::from_rotation_y(1.0);
            let a = square(DVec3::ZERO, x, y).map(|p| m * p + DVec3::new(0.3, 4.0, 1.0));
            let b =
                square(DVec3::ZERO, c * y + s * z, x).map(|p| m * p + DVec3::new(0.3, 4.0, 1.0));
            let turned = pair(&a, &b, tol);
            eprintln!(
                "tol {tol:e} fold {angle}: {got} rel {:e} {:e}",
                got / f - 1.0,
                turned / f - 1.0
            );
        }
    }
}

/// xorshift64* (Vigna 2016).
struct Random(u64);
impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1_u64 << 53) as f64
    }
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
    fn log(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }
    fn point(&mut self) -> DVec3 {
        DVec3::new(
            self.within(-1.0, 1.0),
            self.within(-1.0, 1.0),
            self.within(-1.0, 1.0),
        )
    }
    /// Corners on an ellipse.
    fn convex(&mut self) -> Vec<DVec3> {
        let n = 3 + (self.next() * 4.0) as usize;
        let mut angles: Vec<f64> = (0..n)
            .map(|k| (k as f64 + self.within(0.1, 0.9)) * std::f64::consts::TAU / n as f64)
            .collect();
        angles.sort_by(f64::total_cmp);
        let squeeze = if self.next() < 0.3 {
            self.log(1e-6, 1.0)
        } else {
            self.within(0.2, 1.0)
        };
        let (a, b) = self.point().normalize().any_orthonormal_pair();
        angles
            .iter()
            .map(|t| t.cos() * a + squeeze * t.sin() * b)
            .collect()
    }
    /// In the half plane y >= 0 of the frame (x, y) with an edge on the x axis from s to t.
    fn on_edge(&mut self, x: DVec3, y: DVec3, s: f64, t: f64) -> Vec<DVec3> {
        let h = self.log(1e-3, 3.0);
        let mut c = vec![s * x, t * x];
        if self.next() < 0.5 {
            c.push(self.within(s, t) * x + h * y);
        } else {
            c.push(self.within(0.5 * s + 0.5 * t, t + 1.0) * x + h * y);
            c.push(self.within(s - 1.0, 0.5 * s + 0.5 * t) * x + h * y);
        }
        c
    }
}

fn both(kind: usize, r: &mut Random) -> [Vec<DVec3>; 2] {
    let turn =
        DMat3::from_rotation_x(r.within(0.0, 6.0)) * DMat3::from_rotation_z(r.within(0.0, 6.0));
    let angle = match kind % 4 {
        0 => r.within(1.0, 179.0),
        1 => r.log(1.0, 10.0),
        2 => 180.0 - r.log(0.1, 10.0),
        _ => [90.0, 30.0, 45.0, 1.0][(r.next() * 4.0) as usize],
    }
    .to_radians();
    let fold = angle.cos() * DVec3::Y + angle.sin() * DVec3::Z;
    let (i, j) = match kind / 4 {
        // common edge
        0 => (r.on_edge(DVec3::X, DVec3::Y, 0.0, 1.0), {
            let mut j = r.on_edge(DVec3::X, fold, 0.0, 1.0);
            j.reverse();
            j
        }),
        // partial overlap
        1 => {
            let (s, t) = (r.within(-1.0, 0.9), r.within(1.0, 2.0));
            (r.on_edge(DVec3::X, DVec3::Y, 0.0, 1.0), {
                let mut j = r.on_edge(DVec3::X, fold, s, t);
                j.reverse();
                j
            })
        }
        // end to end on one line
        2 => (r.on_edge(DVec3::X, DVec3::Y, 0.0, 1.0), {
            let mut j = r.on_edge(DVec3::X, fold, 1.0, 2.0);
            j.reverse();
            j
        }),
        // parallel to within 1e-7
        3 => {
            let mut i = r.convex();
            let n = polygon(&i).normal;
            let d = r.log(1e-3, 10.0);
            let tilt = r.log(1e-9, 1e-6);
            let (a, b) = n.any_orthonormal_pair();
            let m = DMat3::from_axis_angle(a, tilt);
            let shift = r.within(-1.0, 1.0) * b;
            let mut j: Vec<DVec3> = i.iter().map(|&p| m * p + d * n + shift).collect();
            j.reverse();
            if r.next() < 0.5 {
                i.rotate_left(1)
            }
            (i, j)
        }
        // common vertex
        4 => {
            let i = r.convex();
            let j = r.convex();
            let d = i[0] - j[0];
            (i, j.iter().map(|&p| p + d).collect())
        }
        // vertex in the middle of an edge
        5 => {
            let i = r.convex();
            let j = r.convex();
            let d = 0.3 * i[0] + 0.7 * i[1] - j[0];
            (i, j.iter().map(|&p| p + d).collect())
        }
        // anywhere, pierced
        6 => {
            let i = r.convex();
            let j = r.convex();
            let d = r.point();
            (i, j.iter().map(|&p| p + d).collect())
        }
        // unequal
        7 => {
            let i = r.convex();
            let s = r.log(1e-4, 1.0);
            let j = r.convex();
            let d = r.point();
            (i, j.iter().map(|&p| s * p + d).collect())
        }
        // unequal, touching
        8 => {
            let i = r.convex();
            let s = r.log(1e-4, 1.0);
            let j = r.convex();
            let d = i[0] - s * j[0];
            (i, j.iter().map(|&p| s * p + d).collect())
        }
        // far
        _ => {
            let i = r.convex();
            let j = r.convex();
            let d = r.log(1.0, 1e6) * r.point();
            (i, j.iter().map(|&p| p + d).collect())
        }
    };
    [i, j].map(|c: Vec<DVec3>| c.iter().map(|&p| turn * p).collect())
}

#[test]
fn random_pairs() {
    let mut r = Random(77);
    for kind in [0, 1, 2, 3, 4, 5, 6, 7, 28, 36, 37] {
        let mut worst = [(0.0_f64, 0); 2];
        let mut count = 0;
        let mut time = [0.0; 2];
        for trial in 0..100 {
            let [i, j] = both(kind, &mut r);
            let Some([a, b]) = facing(polygon(&i), polygon(&j)) else {
                continue;
            };
            count += 1;
            let t = std::time::Instant::now();
            let (s, l) = if a.area < b.area { (&a, &b) } else { (&b, &a) };
            let reference = element_to_polygon::adaptive_exchange(s, l, 1e-8, &mut Unrecorded);
            time[0] += t.elapsed().as_secs_f64();
            let t = std::time::Instant::now();
            for (k, tol) in [(0, 1e-3), (1, 1e-6)] {
                let got = auto::exchange(&a, &b, tol, &mut Unrecorded);
                let error = (got / reference - 1.0).abs();
                if k == 1 && error > 2e-6 {
                    let other = element_to_polygon::adaptive_exchange(l, s, 1e-7, &mut Unrecorded);
                    let tight = contour::exchange(&a, &b, 1e-12 * reference, &mut Unrecorded);
                    let ea = a.edges().map(|[p, q]| p.distance(q)).fold(9e9, f64::min);
                    let eb = b.edges().map(|[p, q]| p.distance(q)).fold(9e9, f64::min);
                    eprintln!(
                        "   {kind}/{trial} got {got:e} ref {reference:e} other {other:e} contour {tight:e} areas {:e} {:e} radii {:e} {:e} d {:e} corners {} {} edges {ea:e} {eb:e}",
                        a.area,
                        b.area,
                        a.radius,
                        b.radius,
                        a.center.distance(b.center),
                        a.corners.len(),
                        b.corners.len()
                    );
                }
                if !(error <= worst[k].0) {
                    worst[k] = (error, trial);
                }
            }
            time[1] += t.elapsed().as_secs_f64();
        }
        eprintln!(
            "kind {kind}: {count} worst {worst:?} us {:.0} {:.1}",
            time[0] * 1e6 / count as f64,
            time[1] * 1e6 / count as f64
        );
    }
}
