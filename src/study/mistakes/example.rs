//! For each mistake a scene on which it is plain to see, and the method; and the mistakes by what they are about.

use super::Mistake;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::methods::{Method, Settings, Setup};
use crate::scene::{Limits, View, read};
use std::num::NonZeroU32;

/// A rod, a ball and a mirror over a floor, with two lamps.
const RAYS: &str = include_str!("scenes/rays.json");
/// Balls of several sizes and a triangle that is seen from behind, with a lamp before them and one behind.
const LIGHT: &str = include_str!("scenes/light.json");
/// Two cylinders.
const POLYGONS: &str = include_str!("scenes/polygons.json");
/// Walls of unequal patches.
const ROOM: &str = include_str!("scenes/room.json");

/// How deep rays go where a level more or less is the mistake.
const FEW_LEVELS: NonZeroU32 = NonZeroU32::new(3).unwrap();

impl Mistake {
    /// By what they are about; each stands in one group.
    pub const GROUPS: [(&str, &[Mistake]); 6] = [
        (
            "file",
            &[
                Mistake::FlipY,
                Mistake::MirrorX,
                Mistake::ColumnsFirst,
                Mistake::SidesSwapped,
                Mistake::NoSrgb,
                Mistake::SrgbTwice,
                Mistake::ChannelsSwapped,
            ],
        ),
        (
            "camera",
            &[
                Mistake::FovVertical,
                Mistake::FovHalfAngle,
                Mistake::HalfPixelOff,
            ],
        ),
        (
            "light",
            &[
                Mistake::NormalNotFlipped,
                Mistake::NormalNotNormalized,
                Mistake::LightNotNormalized,
                Mistake::LightToPoint,
                Mistake::CosNotClamped,
                Mistake::SpecularWithoutNdotl,
                Mistake::ReflectSign,
                Mistake::ExponentForgotten,
                Mistake::HighlightSwapped,
                Mistake::NoAttenuation,
                Mistake::AmbientForgotten,
                Mistake::AmbientPerLight,
            ],
        ),
        (
            "polygons",
            &[Mistake::VertexNormalsByArea, Mistake::InclusiveScanRule],
        ),
        (
            "rays",
            &[
                Mistake::NoShadows,
                Mistake::NoShadowOffset,
                Mistake::ShadowIgnoresLightDistance,
                Mistake::ReflectionForgotten,
                Mistake::EtaInverted,
                Mistake::EtaNotSwappedOnLeaving,
                Mistake::TirBlack,
                Mistake::DepthMinusOne,
                Mistake::DepthPlusOne,
            ],
        ),
        (
            "patches",
            &[
                Mistake::FormFactorTransposed,
                Mistake::ReflectanceForgotten,
                Mistake::PiTwice,
            ],
        ),
    ];

    /// A scene that shows it in a picture of that size, and the method. None only where the scene cannot be read.
    pub fn example(self, [width, height]: [u32; 2]) -> Option<(Setup, Method)> {
        let (scene, method) = match self {
            Mistake::FormFactorTransposed | Mistake::ReflectanceForgotten | Mistake::PiTwice => {
                (ROOM, Method::Radiosity)
            }
            Mistake::VertexNormalsByArea => (POLYGONS, Method::Gouraud),
            Mistake::InclusiveScanRule => (POLYGONS, Method::Flat),
            Mistake::NormalNotFlipped
            | Mistake::NormalNotNormalized
            | Mistake::LightNotNormalized
            | Mistake::LightToPoint
            | Mistake::CosNotClamped
            | Mistake::SpecularWithoutNdotl
            | Mistake::ReflectSign
            | Mistake::ExponentForgotten
            | Mistake::HighlightSwapped => (LIGHT, Method::RayCasting),
            Mistake::AmbientForgotten => (LIGHT, Method::RayTracing),
            _ => (RAYS, Method::RayTracing),
        };
        let no_mesh = &mut |_: &str| Err("the scene names no mesh".into());
        let scene = read(scene.as_bytes(), &Limits::default(), no_mesh).ok()?;
        let view = View::new(&scene.camera?, width, height);
        let mut rays = primary::Settings::default();
        if matches!(self, Mistake::DepthMinusOne | Mistake::DepthPlusOne) {
            rays.depth = FEW_LEVELS;
        }
        let settings = Settings::default().with(rays);
        Some((
            Setup::new(PreparedScene::new(scene, view), settings),
            method,
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::render;
    use crate::study::against::with_mistake;
    use crate::study::mistakes::Workers;
    use std::num::NonZeroUsize;

    #[test]
    fn each_mistake_stands_in_one_group() {
        for mistake in Mistake::ALL {
            let groups = Mistake::GROUPS.iter();
            let count: usize = groups
                .map(|(_, group)| group.iter().filter(|&&one| one == mistake).count())
                .sum();
            assert_eq!(count, 1, "{}", mistake.name());
        }
    }

    #[test]
    fn its_example_shows_it() {
        let one = NonZeroUsize::MIN;
        for mistake in Mistake::ALL {
            let (setup, method) = mistake.example([64, 48]).unwrap();
            assert!(mistake.concerns(method), "{}", mistake.name());
            assert!(setup.prepared.scene.notes.is_empty());
            setup.check_for(method).unwrap();
            let right = render(&setup, method, one, &|_, _| {});
            let made = with_mistake(mistake, (&setup, method), &right, 1.0 / 255.0, Workers::ONE);
            let off = made.map_or(0, |(_, found)| found.off);
            assert!(off >= 15, "{}: {off} pixels", mistake.name());
        }
    }
}
