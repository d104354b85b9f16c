//! Lamps that are turned the wrong way: surfaces that emit, but not toward what they could light.

use super::form_factor::sample;
use super::form_factor::sobol::Sobol;
use crate::color::Rgb;
use crate::scene::patch_primitives::PatchPrimitives;
use crate::scene::patches::Patches;
use crate::scene::primitives::Ray;
use crate::scene::{Note, Scene};
use glam::DVec3;
use std::f64::consts::TAU;

/// Rays for each side of a lamp.
const RAYS: u32 = 256;
/// The most lamps that are looked at.
const MOST_LAMPS: usize = 1024;
/// How far in front of a surface a ray starts, as a share of the patch's extent.
const OFFSET: f64 = 1e-6;
/// A lamp lies on a surface that takes this share of its light, at a distance of this share of its width.
const MOST_OF_IT: f64 = 0.9;
const CLOSE: f64 = 0.1;

/// What one side of a lamp sees.
struct Side {
    /// By object, the share of rays that meet the front of one of its patches.
    received: Vec<f64>,
    /// The mean distance of what the rays meet.
    distance: f64,
}

impl Side {
    fn all(&self) -> f64 {
        self.received.iter().sum()
    }
}

/// A note for each lamp whose light reaches nothing, or only a surface on which it lies, where its back would light others.
pub fn notes(scene: &Scene, patches: &Patches, primitives: &PatchPrimitives) -> Vec<Note> {
    let emits = |&(_, object): &(usize, &crate::scene::Object)| {
        scene.materials[object.material].emission != Rgb::BLACK
    };
    let lamps = scene.objects.iter().enumerate().filter(emits);
    let note = |(number, object): (usize, &crate::scene::Object)| {
        let front = side(patches, primitives, number, 1.0);
        let lit = front.received.iter().copied().enumerate();
        let (most, share) = lit.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let back = || side(patches, primitives, number, -1.0);
        let others = |side: Side| side.all() - side.received[number] - side.received[most];
        let what = format!("the lamp {:?}", object.name);
        let turn = "its vertices in the opposite order turn it around";
        let why = if front.all() == 0.0 {
            let hint = if back().all() > 0.0 {
                turn
            } else {
                "no surface faces it"
            };
            format!("its front lights nothing: {hint}")
        } else if most != number
            && share >= MOST_OF_IT
            && front.distance <= CLOSE * width(patches, number)
            && others(back()) > 0.1
        {
            let onto = &scene.objects[most].name;
            let (percent, distance) = (100.0 * share, front.distance);
            format!(
                "{percent:.0} % of its light goes to {onto:?}, {distance:.1e} in front of it; {turn}"
            )
        } else {
            return None;
        };
        Some(Note::new(format_args!("objects[{number}]"), what, why))
    };
    lamps.take(MOST_LAMPS).filter_map(note).collect()
}

/// What a lamp's front sees, with `sign` 1, or its back, with −1: by rays of a cosine distribution, spread over its patches.
fn side(patches: &Patches, primitives: &PatchPrimitives, object: usize, sign: f64) -> Side {
    let surface = &patches.surfaces[object];
    let count = patches_of(patches, object);
    let mut received = vec![0.0; patches.surfaces.len()];
    let (mut distance, mut met) = (0.0, 0.0);
    let sobol = Sobol::new(object as u64);
    for index in 0..RAYS {
        let patch = surface.first + index as usize * count / RAYS as usize;
        let [s, t, u, v] = sobol.point(index);
        let from = sample::at(patches, patch, [s, t]);
        let normal = sign * from.normal;
        let (across, along) = normal.any_orthonormal_pair();
        let (sin, cos) = (TAU * v).sin_cos();
        let aside: DVec3 = u.sqrt() * (cos * across + sin * along);
        let ray = Ray {
            origin: from.point + OFFSET * patches[patch].radius * normal,
            direction: (aside + (1.0 - u).sqrt() * normal).normalize(),
        };
        if let Some((patch, hit)) = primitives.nearest(&ray)
            && ray.direction.dot(patches[patch].normal) < 0.0
        {
            received[patches[patch].object as usize] += 1.0 / f64::from(RAYS);
            distance += hit.t * ray.direction.dot(normal);
            met += 1.0;
        }
    }
    Side {
        received,
        distance: distance / f64::max(met, 1.0),
    }
}

fn patches_of(patches: &Patches, object: usize) -> usize {
    let next = patches.surfaces.get(object + 1);
    next.map_or(patches.len(), |next| next.first) - patches.surfaces[object].first
}

/// The side of a square of the lamp's area.
fn width(patches: &Patches, object: usize) -> f64 {
    let first = patches.surfaces[object].first;
    let of_lamp = first..first + patches_of(patches, object);
    of_lamp.map(|patch| patches[patch].area).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::fixtures::{Cuboid, polygon, scene};

    /// The notes on a lamp in a room that does not emit itself.
    fn noted(corners: [[f64; 3]; 4], with_room: bool) -> Vec<String> {
        let lamp = polygon("lamp", &corners, 2);
        let room = Cuboid::UNIT.room("wall", [2; 6]);
        let objects = match with_room {
            true => [room, vec![lamp]].concat(),
            false => vec![lamp],
        };
        let mut scene = scene("", &objects);
        let mut glowing = scene.materials[0].clone();
        glowing.emission = Rgb::WHITE;
        scene.materials.push(glowing);
        scene.objects.last_mut().unwrap().material = 1;
        let patches = Patches::of(&scene, 1000).unwrap();
        let primitives = PatchPrimitives::of(&scene, &patches);
        let notes = notes(&scene, &patches, &primitives);
        notes.iter().map(Note::to_string).collect()
    }

    /// At height y, facing down, or turned up.
    fn at(y: f64, up: bool) -> [[f64; 3]; 4] {
        let mut corners = [[0.3, y, 0.3], [0.7, y, 0.3], [0.7, y, 0.7], [0.3, y, 0.7]];
        if up {
            corners.reverse();
        }
        corners
    }

    #[test]
    fn a_lamp_that_lights_the_room_is_not_noted() {
        for y in [0.5, 0.99, 1.0] {
            assert_eq!(noted(at(y, false), true), [""; 0], "{y}");
        }
        assert_eq!(noted(at(0.5, true), true), [""; 0]);
    }

    #[test]
    fn a_lamp_that_is_turned_to_its_ceiling_is_noted() {
        let notes = noted(at(0.99, true), true);
        assert_eq!(notes.len(), 1);
        assert!(
            notes[0].starts_with("objects[6]: the lamp \"lamp\": "),
            "{}",
            notes[0]
        );
        assert!(
            notes[0].contains("goes to \"wall5\", 1.0e-2 in front of it"),
            "{}",
            notes[0]
        );
    }

    #[test]
    fn a_lamp_that_lights_nothing_is_noted() {
        let outside = noted(at(1.0, true), true);
        assert!(
            outside[0].contains("lights nothing: its vertices"),
            "{outside:?}"
        );
        let alone = noted(at(0.5, true), false);
        assert!(
            alone[0].contains("lights nothing: no surface faces it"),
            "{alone:?}"
        );
    }
}
