//! The chapters of the list of lessons.

named! {
    /// A part of the list of lessons, in the order of the list.
    pub enum Chapter {
        Shading = "shading",
        RayTracing = "ray-tracing",
        Radiosity = "radiosity",
        Study = "study",
    }
}
