//! The events of ray tracing: the binary ray tree of a pixel, in which a node is a ray and its children are the reflected and the
//! transmitted ray (Whitted 1980, figure 3). Light comes back from the leaves up; a leaf says why it ended.

use crate::color::Rgb;
use crate::scene::primitives::{Hit, Ray};
use glam::DVec3;

/// The kinds of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayKind {
    Primary,
    Reflected,
    Transmitted,
    TotalInternalReflection,
}

impl RayKind {
    pub const ALL: [RayKind; 4] = [
        RayKind::Primary,
        RayKind::Reflected,
        RayKind::Transmitted,
        RayKind::TotalInternalReflection,
    ];

    /// As in the output of `render --stats`.
    pub fn name(self) -> &'static str {
        match self {
            RayKind::Primary => "primary",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
            RayKind::TotalInternalReflection => "total_internal_reflection",
        }
    }
}

/// A ray that a surface sends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    pub kind: RayKind,
    /// k_r or k_t, by which its light is multiplied.
    pub coefficient: Rgb,
    /// Unit.
    pub direction: DVec3,
}

/// Why a branch has no ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// It would lie below the last level; it contributes black.
    Depth,
    /// The surface does not reflect, or does not transmit.
    NoCoefficient,
}

impl End {
    pub fn name(self) -> &'static str {
        match self {
            End::Depth => "depth",
            End::NoCoefficient => "no coefficient",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens a ray, the primary one at level 1.
    Ray { kind: RayKind, level: u16, ray: Ray },
    /// Opens the ray from the surface to a light.
    ShadowRay {
        light: u32,
        origin: DVec3,
        direction: DVec3,
        distance: f64,
    },
    /// Closes `ShadowRay`; `by` is the object in between, where the search finds out.
    Shadow {
        light: u32,
        blocked: bool,
        by: Option<Hit>,
    },
    /// The light that arrives from the lights, ambient light and emission.
    Local { emission: Rgb, local: Rgb },
    /// `radicand` is cos²θ_r; where it is negative, reflection is total.
    Refraction {
        eta_i: f64,
        eta_r: f64,
        cos_theta_i: f64,
        radicand: f64,
    },
    /// The surface sends on a secondary ray.
    Branched { branch: Branch },
    /// A branch without a ray.
    Ended { kind: RayKind, end: End },
    /// The light of a secondary ray, attenuated by the distance.
    Attenuated {
        kind: RayKind,
        distance: f64,
        /// a0, a1, a2.
        attenuation: [f64; 3],
        carried: Rgb,
    },
    /// The light of a secondary ray is added, times its coefficient.
    Added {
        kind: RayKind,
        carried: Rgb,
        sum: Rgb,
    },
    /// Closes `Ray`, with the light that comes back along it.
    Returned { color: Rgb },
}

impl Event {
    pub fn too_deep(kind: RayKind) -> Self {
        Event::Ended {
            kind,
            end: End::Depth,
        }
    }

    pub fn no_coefficient(kind: RayKind) -> Self {
        Event::Ended {
            kind,
            end: End::NoCoefficient,
        }
    }

    /// The angle of refraction, unless reflection is total, and the critical angle, where there is one; in degrees.
    pub fn angles(eta_i: f64, eta_r: f64, radicand: f64) -> [Option<f64>; 2] {
        let refracted = (radicand >= 0.0).then(|| radicand.sqrt().min(1.0).acos());
        let critical = (eta_i > eta_r).then(|| (eta_r / eta_i).asin());
        [refracted, critical].map(|angle| angle.map(f64::to_degrees))
    }
}
