//! When links are refined.

/// The tolerances of the paper, free of the scene's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// F_ε of the first pass.
    pub link_size: f64,
    /// BFA_ε of the last pass: how much light a link may carry, as a share of all that is emitted.
    pub link_light: f64,
    /// A_ε: what is no larger is not divided, whatever its links carry.
    pub smallest_area: f64,
    /// How many passes come after the first one. Each allows `COARSER` times as much as the next.
    pub passes: u32,
}

pub const COARSER: f64 = 4.0;

impl Default for Settings {
    fn default() -> Self {
        Settings {
            link_size: 0.2,
            link_light: 1e-5,
            smallest_area: 0.0,
            passes: 3,
        }
    }
}

/// A setting that has no meaning.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{what} {found}: allowed are {allowed}")]
pub struct NotAllowed {
    pub what: &'static str,
    pub found: f64,
    pub allowed: &'static str,
}

impl Settings {
    /// Errors: the first setting that has no meaning.
    pub fn check(&self) -> Result<(), NotAllowed> {
        let not_allowed = |what, found, allowed| {
            Err(NotAllowed {
                what,
                found,
                allowed,
            })
        };
        const SHARE: &str = "numbers from 0 to 1";
        match *self {
            Settings { link_size, .. } if !(0.0..=1.0).contains(&link_size) => {
                not_allowed("link_size", link_size, SHARE)
            }
            Settings { link_light, .. } if !(0.0..=1.0).contains(&link_light) => {
                not_allowed("link_light", link_light, SHARE)
            }
            Settings { smallest_area, .. }
                if !(smallest_area >= 0.0 && smallest_area.is_finite()) =>
            {
                not_allowed("smallest_area", smallest_area, "numbers of 0 or more")
            }
            Settings { passes, .. } if passes > 8 => {
                not_allowed("passes", passes.into(), "whole numbers up to 8")
            }
            _ => Ok(()),
        }
    }
}
