//! What of the values is looked at.

/// A search among the values, and how many lines are scrolled past.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InspectorView {
    /// Only values whose name, meaning or number has this text; all where it is empty.
    pub search: String,
    pub first: usize,
}

impl InspectorView {
    /// All values from the first.
    pub const WHOLE: InspectorView = InspectorView {
        search: String::new(),
        first: 0,
    };

    /// All values, for who never chooses.
    pub fn whole() -> &'static InspectorView {
        static WHOLE: InspectorView = InspectorView::WHOLE;
        &WHOLE
    }
}
