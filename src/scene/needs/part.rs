//! The parts of the work that a scene may not need.

named! {
    /// A part of the work that a scene may not need.
    pub enum Part {
        ReflectedRays = "reflected_rays",
        TransmittedRays = "transmitted_rays",
        TextureCoordinates = "texture_coordinates",
        Highlights = "highlights",
        LightBalls = "light_balls",
        PathAttenuation = "path_attenuation",
        ShadowRays = "shadow_rays",
        /// Of radiosity: a channel in which nothing emits.
        DarkChannels = "dark_channels",
        /// A channel that is as one before it.
        EqualChannels = "equal_channels",
        /// Equations of patches that reflect nothing: B = E.
        BlackRows = "black_rows",
        /// Integrals between patches that do not face each other: F = 0.
        FacingAway = "facing_away",
        /// Rays between patches that nothing can part.
        SightTests = "sight_tests",
    }
}

impl Part {
    pub fn why(self) -> &'static str {
        match self {
            Part::ReflectedRays => "no surface has a `reflection` other than 0",
            Part::TransmittedRays => "no surface has a `transmission` other than 0",
            Part::TextureCoordinates => "no surface has a `texture`",
            Part::Highlights => "no surface has a `specular` other than 0",
            Part::LightBalls => "no point light has a `radius` other than 0",
            Part::PathAttenuation => "secondary rays lose nothing on their way: [1, 0, 0]",
            Part::ShadowRays => "nothing that casts a shadow can stand before this light",
            Part::DarkChannels => "no surface has an `emission` in this channel: B = 0",
            Part::EqualChannels => "`emission` and `reflectance` are those of a channel before it",
            Part::BlackRows => "no `reflectance` in this channel: B = E",
            Part::FacingAway => "in one plane, or back to back: F = 0 without an integral",
            Part::SightTests => "nothing can stand between the two",
        }
    }

    /// What its share counts.
    pub fn counted(self) -> &'static str {
        match self {
            Part::BlackRows => "patches",
            Part::FacingAway | Part::SightTests => "pairs of patches",
            _ => "objects",
        }
    }
}

/// Some of the parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Parts(u16);

impl Parts {
    pub const NONE: Parts = Parts(0);
    pub const ALL: Parts = Parts((1 << Part::ALL.len()) - 1);

    pub fn has(self, part: Part) -> bool {
        self.0 & 1 << part as u16 != 0
    }

    pub fn is_empty(self) -> bool {
        self == Parts::NONE
    }

    /// With that part, where it was not among them, else without.
    pub fn toggled(self, part: Part) -> Parts {
        Parts(self.0 ^ 1 << part as u16)
    }
}

impl From<Part> for Parts {
    fn from(part: Part) -> Self {
        Parts::NONE.toggled(part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_what_was_put_into_it() {
        for part in Part::ALL {
            assert!(Parts::ALL.has(part) && !Parts::NONE.has(part));
            let only = Parts::from(part);
            let had: Vec<Part> = Part::ALL.into_iter().filter(|&p| only.has(p)).collect();
            assert_eq!(had, [part]);
            assert!(only.toggled(part).is_empty());
        }
    }
}
