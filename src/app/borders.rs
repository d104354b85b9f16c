//! Where the borders between the parts of the window are.

use serde::{Deserialize, Serialize};

/// How the user has divided the window; what was not chosen is as usual. It is kept from one start of the program to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub struct Borders {
    /// Width of the left column.
    pub column: Option<f32>,
    /// Height of the time line without its buttons.
    pub time_line: Option<f32>,
}
