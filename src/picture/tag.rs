//! What an item of a picture shows.

/// The thing that an item shows. Items of the same tag, in whichever panel, light up together, and a click on one goes there.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Tag {
    /// An event, by its place in the recording.
    Step(usize),
    /// A pixel of the rendered image, from its upper left corner.
    Pixel { x: u32, y: u32 },
    /// A row of pixels of the rendered image, counted from the top.
    ScanLine(i32),
    /// A polygon of the scene.
    Polygon(usize),
    /// A corner of the polygon at hand.
    Corner(usize),
    /// A vertex of a mesh, shared by polygons.
    Vertex(u32),
    /// An edge of the edge table.
    Edge(usize),
    /// A line of the pseudocode, counted from 0.
    Line(usize),
    /// A named value of the event at hand.
    Field(&'static str),
    /// A patch of the room.
    Patch(usize),
    /// The form factor from patch i to patch j.
    FormFactor { i: usize, j: usize },
    /// A light of the scene.
    Light(usize),
    /// A scope of the time line, by the step that opens it.
    Scope(usize),
    /// A point of a plot: its curve, and its number on that.
    Point { curve: usize, point: usize },
    /// Red, green or blue, counted from 0, of a formula.
    Channel(usize),
    /// The sign that collapses a ray of the ray tree, by the step that opened it.
    Fold(usize),
}
