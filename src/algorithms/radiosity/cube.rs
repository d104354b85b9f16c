//! A closed unit cube of n×n patches a face, its form factors in closed form (Ehlert & Smith 1993, "View factors for perpendicular and
//! parallel rectangular plates"): sums over the corners of both rectangles.

use std::f64::consts::TAU;

/// A patch in the plane x_axis = side: its extent along each axis.
struct Cell {
    axis: usize,
    side: f64,
    extent: [[f64; 2]; 3],
}

/// Form factors of the cube row by row, and the area of each patch; face by face, axis by axis.
pub fn cube(n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut cells = Vec::new();
    for face in 0..6 {
        let (axis, side) = (face / 2, (face % 2) as f64);
        for cell in 0..n * n {
            let mut extent = [[side; 2]; 3];
            for (along, place) in [(1, cell % n), (2, cell / n)] {
                extent[(axis + along) % 3] = [place, place + 1].map(|i| i as f64 / n as f64);
            }
            cells.push(Cell { axis, side, extent });
        }
    }
    let area = 1.0 / (n * n) as f64;
    let pairs = cells.iter().flat_map(|a| cells.iter().map(move |b| (a, b)));
    let f = pairs
        .map(|(a, b)| exchange_area(a, b).max(0.0) / area)
        .collect();
    (f, vec![area; cells.len()])
}

fn exchange_area(a: &Cell, b: &Cell) -> f64 {
    if a.axis == b.axis {
        if a.side == b.side {
            return 0.0;
        }
        let (u, v) = ((a.axis + 1) % 3, (a.axis + 2) % 3);
        corner_sum(
            a.extent[u],
            b.extent[u],
            a.extent[v],
            b.extent[v],
            |x, xi, y, eta| parallel(x - xi, y - eta),
        )
    } else {
        let common = 3 - a.axis - b.axis;
        let from = |extent: [f64; 2], side: f64| {
            let [p, q] = extent.map(|x| (x - side).abs());
            [p.min(q), p.max(q)]
        };
        let (x, xi) = (
            from(a.extent[b.axis], b.side),
            from(b.extent[a.axis], a.side),
        );
        corner_sum(
            x,
            xi,
            a.extent[common],
            b.extent[common],
            |x, xi, y, eta| perpendicular(x * x + xi * xi, y - eta),
        )
    }
}

fn corner_sum(
    x: [f64; 2],
    xi: [f64; 2],
    y: [f64; 2],
    eta: [f64; 2],
    term: impl Fn(f64, f64, f64, f64) -> f64,
) -> f64 {
    let mut sum = 0.0;
    for corner in 0..16_usize {
        let [i, j, k, l] = [0, 1, 2, 3].map(|bit| corner >> bit & 1);
        let sign = if corner.count_ones() % 2 == 0 {
            1.0
        } else {
            -1.0
        };
        sum += sign * term(x[i], xi[j], y[k], eta[l]);
    }
    sum / TAU
}

/// At distance 1.
fn parallel(x: f64, y: f64) -> f64 {
    let (p, q) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
    y * p * (y / p).atan() + x * q * (x / q).atan() - 0.5 * (1.0 + x * x + y * y).ln()
}

fn perpendicular(square: f64, y: f64) -> f64 {
    let all = square + y * y;
    if all == 0.0 {
        return 0.0;
    }
    let root = square.sqrt();
    y * root * y.atan2(root) - 0.25 * (square - y * y) * all.ln()
}

/// The central 2×2 patches of the first face emit 1.
pub fn lamp(n: usize) -> Vec<f64> {
    let mut emission = vec![0.0; 6 * n * n];
    for row in [n / 2 - 1, n / 2] {
        for column in [n / 2 - 1, n / 2] {
            emission[row * n + column] = 1.0;
        }
    }
    emission
}
