//! The methods, and their names.

use super::hemicube::Hemicubes;

/// How a form factor is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// To a relative error of `tolerance`.
    Auto {
        tolerance: f64,
    },
    /// At `points`² Gauss points a patch.
    AreaToArea {
        points: usize,
    },
    /// At `points`² Gauss points of the smaller patch.
    ElementToPolygon {
        points: usize,
    },
    /// With an error of `tolerance`, a share of the smaller area.
    Contour {
        tolerance: f64,
    },
    MonteCarlo {
        rays: u32,
        seed: u64,
    },
    Hemicube(Hemicubes),
}

written_as_name!(Method);

impl Method {
    /// Every method, as it is used where nothing more is said.
    pub const ALL: [Method; 6] = [
        Method::Auto { tolerance: 1e-6 },
        Method::AreaToArea { points: 4 },
        Method::ElementToPolygon { points: 4 },
        Method::Contour { tolerance: 1e-9 },
        Method::MonteCarlo {
            rays: 1 << 12,
            seed: 0,
        },
        Method::Hemicube(Hemicubes {
            resolution: 256,
            points: 1,
        }),
    ];

    /// As on the command line and in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Auto { .. } => "auto",
            Method::AreaToArea { .. } => "area-to-area",
            Method::ElementToPolygon { .. } => "element-to-polygon",
            Method::Contour { .. } => "contour",
            Method::MonteCarlo { .. } => "monte-carlo",
            Method::Hemicube(_) => "hemicube",
        }
    }

    pub fn from_name(name: &str) -> Option<Method> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Whether F_ij and F_ji come from one computation.
    pub fn is_reciprocal(&self) -> bool {
        !matches!(self, Method::MonteCarlo { .. } | Method::Hemicube(_))
    }
}
