//! The illumination model as a student writes it, with one classic mistake or none.

use super::Mistake;
use crate::algorithms::illumination::SurfacePoint;
use crate::algorithms::incidence::Incidence;
use crate::algorithms::intensity::Intensity;
use crate::color::Rgb;
use crate::numeric::{Linear, power_of_cosine};
use crate::scene::{Highlight, Scene};
use glam::DVec3;

pub struct Model<'a> {
    pub scene: &'a Scene,
    pub mistake: Option<Mistake>,
}

impl Model<'_> {
    pub fn errs(&self, mistake: Mistake) -> bool {
        self.mistake == Some(mistake)
    }

    /// A normal on the side of the eye.
    pub fn turned(&self, normal: DVec3, to_eye: DVec3) -> DVec3 {
        let is_behind = normal.dot(to_eye) < 0.0;
        if is_behind && !self.errs(Mistake::NormalNotFlipped) {
            -normal
        } else {
            normal
        }
    }

    /// The light of a point whose normal is on the side of the eye, where that is no mistake.
    pub fn intensity(
        &self,
        point: &SurfacePoint,
        arrives: impl Fn(&Incidence) -> bool,
    ) -> Intensity {
        let mut intensity = Intensity {
            whole: point.material.ambient * self.scene.ambient,
            diffuse: Rgb::BLACK,
        };
        for (light, source) in self.scene.lights.iter().enumerate() {
            let incidence = Incidence::of(light, source, point.position);
            let to_light = self.to_light(&incidence);
            let n_dot_l = point.normal.dot(to_light);
            let is_lit = n_dot_l > 0.0;
            let with_diffuse = is_lit || self.errs(Mistake::CosNotClamped);
            let with_highlight = is_lit || self.errs(Mistake::SpecularWithoutNdotl);
            if !(with_diffuse || with_highlight) || !arrives(&incidence) {
                continue;
            }
            let arriving = incidence.color * incidence.attenuation;
            let mut added = Intensity::default();
            if with_diffuse {
                added.diffuse = point.diffuse * arriving * n_dot_l;
                added.whole = added.diffuse;
            }
            if with_highlight {
                let power = power_of_cosine(self.cosine(point, to_light), point.material.shininess);
                added.whole += point.material.specular * arriving * power;
            }
            intensity = intensity.plus(added);
        }
        intensity
    }

    fn to_light(&self, incidence: &Incidence) -> DVec3 {
        let is_near = incidence.distance.is_finite();
        match self.mistake {
            Some(Mistake::LightToPoint) => -incidence.to_light,
            Some(Mistake::LightNotNormalized) if is_near => incidence.distance * incidence.to_light,
            _ => incidence.to_light,
        }
    }

    /// R·V or N·H.
    fn cosine(&self, point: &SurfacePoint, to_light: DVec3) -> f64 {
        match point.material.highlight {
            Highlight::Phong => -self.mirrored(to_light, point.normal).dot(point.to_eye),
            Highlight::Blinn => {
                let halfway = (to_light + point.to_eye).normalize_or_zero();
                point.normal.dot(halfway)
            }
        }
    }

    /// u − 2(u·N)N
    pub fn mirrored(&self, u: DVec3, n: DVec3) -> DVec3 {
        let along = 2.0 * u.dot(n) * n;
        if self.errs(Mistake::ReflectSign) {
            u + along
        } else {
            u - along
        }
    }
}
