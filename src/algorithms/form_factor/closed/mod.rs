//! Whether a scene is closed: from the front of every patch, as far as light comes to it, nothing is seen but fronts of patches. Then each
//! row of form factors sums to 1. It is decided by where the patches lie, and never by the sums themselves, from which a small opening
//! could not be told apart from an error.
//!
//! Where the patches have no rim, the winding number of the patches around a point is whole, and changes by 1 only across a patch (Jacobson,
//! Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", SIGGRAPH 2013, §3). A room is where
//! it is −1. A ray from there comes to infinity, where it is 0, only across a patch. If the winding number is −2 in front of no patch, the
//! first one that the ray meets has −1 on its near side, so its front.
//!
//! Patches are divided into cells, in front of which the winding number is the same everywhere:
//!
//! - −1: a part of the room.
//! - 0 or more: inside a solid, where no light comes. If the cell lies on one that looks the other way, as the bottom of a block on the
//!   floor, the two exchange all of their light, as they do at every distance that goes to 0. Otherwise it is dark, as what is inside
//!   the other of two blocks that pass through each other.
//!
//! A block may have no face where it stands on the floor: its rim there is closed by a cap, of the cells that the rim goes around.

mod cap;
mod cells;
mod rim;

use super::coincident::Exposed;
use super::polygon::{Polygon, polygons};
use super::sheet::Sheet;
use crate::scene::patches::Patches;
use cap::{cap, normals_at};
use cells::cells;
use glam::DVec3;
use rim::rim;
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::iter::zip;

/// How far apart corners are one place, as a share of the scene's extent.
const SLACK: f64 = 1e-9;

/// How far in front of a cell the winding number is taken, in units of how far rounding may have moved a corner.
const LIFT: f64 = 64.0;

/// The most pairs of a part of a patch and a surface that are looked at, and the most triangles whose solid angle is taken.
const MOST_PAIRS: usize = 1 << 26;
const MOST_SOLID_ANGLES: usize = 1 << 23;

/// The most pairs of an edge of the rim and a surface that are looked at.
const MOST_OF_RIM: usize = 1 << 22;

/// A closed scene.
#[derive(Clone, Debug)]
pub struct Closed {
    /// By patch, the share of its area that exchanges light.
    pub shares: Vec<f64>,
    /// By patch, the convex parts of it in the room; none where that is all that nothing lies on.
    lit: Exposed,
    /// A_i F_ij of patches that lie on each other face to face, by i and j, both ways.
    contacts: HashMap<[u32; 2], f64>,
}

impl Closed {
    /// A_i F_ij of patches that lie on each other face to face.
    pub fn contact(&self, i: usize, j: usize) -> Option<f64> {
        self.contacts.get(&[i as u32, j as u32]).copied()
    }

    /// The convex parts of a patch in the room; None where that is all that nothing lies on.
    pub fn lit(&self, patch: usize) -> Option<&Vec<Polygon<'static>>> {
        self.lit[patch].as_ref()
    }
}

/// A cell of a patch.
struct Cell {
    patch: usize,
    sheet: Sheet,
    is_whole: bool,
    is_capped: bool,
}

/// What can be said of the patches where they close a scene in; None where they do not, as far as can be told at a bounded cost: a scene
/// with too many patches counts as open. `sheets` are the surfaces that they make together; `slack` is how far rounding may have moved a
/// corner.
pub fn closed(
    patches: &Patches,
    exposed: &Exposed,
    sheets: &[Sheet],
    slack: f64,
) -> Option<Closed> {
    let low = sheets.iter().map(|sheet| sheet.low).reduce(DVec3::min)?;
    let high = sheets.iter().map(|sheet| sheet.high).reduce(DVec3::max)?;
    let rounding = 8.0 * f64::EPSILON * low.abs().max(high.abs()).max_element();
    let apart = SLACK * low.distance(high) + rounding;
    let edges = rim(sheets.iter().map(|sheet| &sheet.polygon), apart)?;
    let mut cells = cells_of(patches, exposed, sheets, [slack, apart])?;
    let mut surfaces: Vec<Polygon> = sheets.iter().map(|sheet| sheet.polygon.clone()).collect();
    if !edges.is_empty() {
        if edges.len().saturating_mul(sheets.len()) > MOST_OF_RIM {
            return None;
        }
        let standing = edges
            .iter()
            .map(|edge| (*edge, normals_at(edge, sheets, apart)));
        surfaces.extend(cap(&mut cells, &standing.collect::<Vec<_>>(), apart));
        if !rim(surfaces.iter(), apart)?.is_empty() {
            return None;
        }
    }
    let mut closed = sorted(patches, &cells, &surfaces, slack)?;
    for (patch, parts) in exposed.iter().enumerate() {
        if let Some(parts) = parts {
            let area: f64 = parts.iter().map(|part| part.area).sum();
            closed.shares[patch] *= area / patches[patch].area;
        }
    }
    Some(closed)
}

/// The cells of all patches, but for slivers thinner than `apart`.
fn cells_of(
    patches: &Patches,
    exposed: &Exposed,
    sheets: &[Sheet],
    [slack, apart]: [f64; 2],
) -> Option<Vec<Cell>> {
    if patches.len().saturating_mul(sheets.len()) > MOST_PAIRS {
        return None;
    }
    let mut all = Vec::new();
    for (patch, exposed) in exposed.iter().enumerate() {
        let whole = || polygons(patches, patch).map(Polygon::into_owned).collect();
        for part in exposed.clone().unwrap_or_else(whole) {
            let part = Sheet::new(part);
            let cells = cells(&part, sheets, slack);
            let is_whole = cells.len() == 1;
            let thick = |cell: &Polygon| {
                let perimeter: f64 = cell.edges().map(|[from, to]| from.distance(to)).sum();
                cell.area > apart * perimeter
            };
            all.extend(cells.into_iter().filter(thick).map(|cell| Cell {
                patch,
                sheet: Sheet::new(cell),
                is_whole,
                is_capped: false,
            }));
        }
    }
    Some(all)
}

/// Sorts the cells by the winding number of `surfaces` in front of them: of all, or in large scenes of as many as there is time for.
fn sorted(patches: &Patches, cells: &[Cell], surfaces: &[Polygon], slack: f64) -> Option<Closed> {
    let triangles: Vec<[DVec3; 3]> = surfaces
        .iter()
        .flat_map(|surface| {
            let fan = surface.corners[1..].windows(2);
            fan.map(|pair| [surface.corners[0], pair[0], pair[1]])
        })
        .collect();
    let affordable = (MOST_SOLID_ANGLES / triangles.len()).max(1);
    let stride = cells.len().div_ceil(affordable);
    // An object of its own may be turned the wrong way by itself.
    let mut is_first = vec![false; patches.len()];
    for surface in &patches.surfaces {
        if let Some(first) = is_first.get_mut(surface.first) {
            *first = true;
        }
    }
    let [mut all, mut exchanging] = [(); 2].map(|()| vec![0.0; patches.len()]);
    let [mut hidden, mut lit]: [Vec<&Cell>; 2] = Default::default();
    let mut tested = 0;
    for (number, cell) in cells.iter().enumerate() {
        let polygon = &cell.sheet.polygon;
        all[cell.patch] += polygon.area;
        if number % stride == 0 || !cell.is_whole || is_first[cell.patch] {
            tested += 1;
            if tested > 4 * affordable {
                return None;
            }
            let point = polygon.center + LIFT * slack * polygon.normal;
            let sum: f64 = triangles.iter().map(|&t| solid_angle(t, point)).sum();
            // Normals point away from where the winding number of closed surfaces is counted as 1.
            let winding = sum / (2.0 * TAU);
            let whole = winding.round();
            if (winding - whole).abs() > 0.1 || whole < -1.0 || (cell.is_capped && whole < 0.0) {
                return None;
            }
            if whole >= 0.0 {
                hidden.push(cell);
                continue;
            }
        }
        exchanging[cell.patch] += polygon.area;
        lit.push(cell);
    }
    if hidden.len() == cells.len() {
        return None;
    }
    let (contacts, touching) = contacts(&hidden, slack);
    let mut is_hidden = zip(&hidden, touching);
    // What looks at a front from outside the room exchanges light there.
    if is_hidden.any(|(cell, touching)| {
        let is_free = !cell.is_capped && touching < 0.5 * cell.sheet.polygon.area;
        is_free && looks_at_a_front(cell, surfaces, LIFT * slack)
    }) {
        return None;
    }
    for (&[patch, _], area) in &contacts {
        exchanging[patch as usize] += area;
    }
    let share = |(part, all): (f64, f64)| if all > 0.0 { part / all } else { 0.0 };
    let mut parts: Exposed = vec![None; patches.len()];
    hidden
        .iter()
        .for_each(|cell| parts[cell.patch] = Some(Vec::new()));
    for cell in lit {
        if let Some(parts) = &mut parts[cell.patch] {
            parts.push(cell.sheet.polygon.clone());
        }
    }
    Some(Closed {
        shares: zip(exchanging, all).map(share).collect(),
        lit: parts,
        contacts,
    })
}

/// By patches, the area of the cells that lie on each other and look at each other; and by cell, how much of it does.
fn contacts(cells: &[&Cell], slack: f64) -> (HashMap<[u32; 2], f64>, Vec<f64>) {
    let mut contacts: HashMap<[u32; 2], f64> = HashMap::new();
    let mut touching = vec![0.0; cells.len()];
    for (k, a) in cells.iter().enumerate() {
        for (l, b) in cells.iter().enumerate().skip(k + 1) {
            if !a.sheet.is_near(&b.sheet, slack) || !a.sheet.is_opposite(&b.sheet, slack) {
                continue;
            }
            let (inside, _) = a.sheet.polygon.clone().parted_by(&b.sheet.polygon, slack);
            let area = inside.map_or(0.0, |inside| inside.area);
            if area > 0.0 {
                let [i, j] = [a.patch as u32, b.patch as u32];
                *contacts.entry([i, j]).or_default() += area;
                *contacts.entry([j, i]).or_default() += area;
                touching[k] += area;
                touching[l] += area;
            }
        }
    }
    (contacts, touching)
}

/// Whether the first surface straight ahead of a cell shows it its front.
fn looks_at_a_front(cell: &Cell, surfaces: &[Polygon], lift: f64) -> bool {
    let Polygon { center, normal, .. } = cell.sheet.polygon;
    let ahead = surfaces.iter().filter_map(|surface| {
        let cosine = surface.normal.dot(normal);
        let distance = surface.normal.dot(surface.corners[0] - center) / cosine;
        let point = center + distance * normal;
        let mut edges = surface.edges();
        let is_met = distance > lift
            && edges.all(|[a, b]| (b - a).cross(point - a).dot(surface.normal) >= 0.0);
        is_met.then_some((distance, cosine))
    });
    let first = ahead.min_by(|a, b| a.0.total_cmp(&b.0));
    first.is_some_and(|(_, cosine)| cosine < 0.0)
}

/// The solid angle of a triangle seen from `point`, positive from behind: where normals point away
/// (Van Oosterom & Strackee, "The solid angle of a plane triangle", 1983, equation 8).
fn solid_angle(triangle: [DVec3; 3], point: DVec3) -> f64 {
    let [a, b, c] = triangle.map(|corner| corner - point);
    let [la, lb, lc] = [a, b, c].map(DVec3::length);
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * a.dot(b.cross(c)).atan2(below)
}

#[cfg(test)]
mod tests;
