//! How the scan-line methods map textures to polygons.

named! {
    /// Where (u, v) come from.
    #[derive(Default)]
    pub enum Mapping {
        /// From the point that the pixel shows.
        #[default]
        Perspective = "perspective",
        /// From the corners, linearly on the screen: a mistake worth looking at.
        Linear = "linear",
    }
}
