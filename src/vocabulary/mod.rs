//! What each kind of event means, declared once: its name, its values with their symbols and units, its line of pseudocode by
//! name, what its scope is called and numbered by, its sentence and its formulas. Everything that shows a step reads this.

#[macro_use]
mod declare;
mod entry;
pub mod expression;
mod fast_phong;
mod form_factor;
mod hierarchical;
mod illumination;
mod intersection;
mod kind;
mod prepared_scene;
mod primary;
mod quantity;
mod radiosity;
mod ray_casting;
mod ray_tracing;
mod ray_tree;
mod scan_line;
mod scene_value;
mod shading;
mod surface;
mod texture;
mod vertex_normal;
mod visible;
mod wireframe;

pub use declare::Declared;
pub use entry::{Entry, Formula, When};
pub use kind::Kind;
pub use quantity::{Quantity, Unit, counted, find, quantity};
pub use scene_value::{Given, SceneValue};

/// All declared kinds, a family after another.
pub const FAMILIES: [&[Kind]; 17] = [
    prepared_scene::KINDS,
    vertex_normal::KINDS,
    illumination::KINDS,
    scan_line::KINDS,
    shading::KINDS,
    texture::KINDS,
    fast_phong::KINDS,
    wireframe::KINDS,
    primary::KINDS,
    visible::KINDS,
    surface::KINDS,
    ray_casting::KINDS,
    ray_tracing::KINDS,
    ray_tree::KINDS,
    form_factor::KINDS,
    radiosity::KINDS,
    hierarchical::KINDS,
];

#[cfg(test)]
mod tests;
