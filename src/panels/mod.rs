//! The panels: what each draws of a run at its step. A picture depends on a [`PanelInput`] and its size alone.
//!
//! Every file of this folder is a panel, with its `PANEL` and `draw`: `build.rs` lists them. What panels share is in `shared`.

mod shared;

pub use list::comparison::{place as comparison_place, values as compared_values};
pub use list::difference::place as difference_place;
pub use list::formula::{
    Evaluated, Slip, evaluated, least_height as formula_height, said, said_with_names, slipped,
    whole_height as whole_formula_height, written as written_formulas,
};
pub use list::image::{
    ImageView, PixelLayer, middle as image_middle, place as image_place, value as pixel_value,
};
pub use list::inspector::{InspectorView, scrolled as inspector_scrolled};
pub use list::ray_tree::{HeldNode, TreeView, node_near};
pub use list::space::{Orbit, Pixels, Preset, RayChoice, SpaceView};
pub use list::time_line::{heights as time_line_heights, step_at};
pub use list::vectors::{PlaneGrip, degrees_toward, grip as vector_grip};
pub use shared::answered::{Answered, AskedArrow};
pub use shared::finding::found;
pub use shared::grip::{Grip, Handle, handles};
pub use shared::horizon::Hidden;
#[cfg(test)]
pub use shared::names::word as word_name;
pub use shared::names::{
    kind as kind_name, meaning, meaning_and_origin, method as method_name, object as object_name,
    of_field as named_by, patch as patch_name, quantity as quantity_name,
    ray_kind as ray_kind_name, scope_known_at as scope_names,
};
pub use shared::patches::{form_factor, form_factor_values, patch_values};
pub use shared::reused::Reused;
pub use shared::strings;

use crate::algorithms::focus::Focus;
use crate::language::Message;
use crate::picture::Picture;
use crate::render::{DrawPatches, Finished};
use crate::replay::rays::State;
use crate::replay::{FanRay, Run};
use glam::Vec2;
#[cfg(test)]
use shared::fixture;
#[cfg(test)]
pub(crate) use shared::fixtures;
use shared::{channels, grip, horizon, message, names, patches, values};
use strings::Language;

/// What is known of a panel without drawing it.
#[derive(Clone, Copy)]
struct Properties {
    title: Message,
    compares: bool,
}

impl Properties {
    const fn titled(title: Message) -> Self {
        Properties {
            title,
            compares: false,
        }
    }

    /// It shows the pictures of several methods.
    const fn comparing(self) -> Self {
        Properties {
            compares: true,
            ..self
        }
    }
}

macro_rules! panels {
    ($($panel:ident: $module:ident $name:literal,)*) => {
        named! {
            /// A panel, by what it shows.
            pub enum Panel {
                $($panel = $name,)*
            }
        }

        impl Panel {
            fn properties(self) -> Properties {
                match self {
                    $(Panel::$panel => list::$module::PANEL,)*
                }
            }
        }

        /// The picture of a panel, `size` points large, without title or frame.
        pub fn draw(panel: Panel, input: &PanelInput, size: Vec2) -> Picture {
            match panel {
                $(Panel::$panel => list::$module::draw(input, size),)*
            }
        }
    };
}

// The files of this folder as modules of `list`, and `panels!` of them.
include!(concat!(env!("OUT_DIR"), "/panels.rs"));

impl Panel {
    /// As lessons and commands call it. What shows the rays in space today was `rays` once.
    pub fn called(name: &str) -> Option<Self> {
        Panel::from_name(if name == "rays" { "space" } else { name })
    }

    pub fn title(self) -> Message {
        self.properties().title
    }

    /// Whether it shows the pictures of several methods.
    pub fn compares(self) -> bool {
        self.properties().compares
    }
}

/// All that a panel's picture depends on.
#[derive(Clone, Copy)]
pub struct PanelInput<'a> {
    /// The recorded run, at the step that is shown.
    pub run: &'a Run,
    /// What was found for the run beside its steps.
    pub finished: &'a Finished,
    /// The part of the frame that the run recorded.
    pub focus: Focus,
    pub language: Language,
    /// Narrated steps, ascending.
    pub narrated: &'a [usize],
    /// Steps at which playing stops, ascending.
    pub breakpoints: &'a [usize],
    /// Which part of the ray tree is shown.
    pub tree: &'a TreeView,
    /// The ray tree of another pixel, as far as it was traced, which is shown beside that of the run; none where none is pinned.
    pub pinned: Option<&'a State>,
    /// Which values the inspector shows.
    pub inspector: &'a InspectorView,
    /// In the presentation, the names of the values that the explanation shows: their formulas come first, and those that have no room are
    /// not announced, as nobody can enlarge the panel; none outside the presentation.
    pub presented: Option<&'a [String]>,
    /// The channel that formulas are worked out in; none where it is the largest of their results.
    pub channel: Option<usize>,
    /// Which part of the picture is shown, and what of its pixels.
    pub image: ImageView,
    /// What of the scene in space is shown.
    pub space: SpaceView,
    /// The rays of other pixels that are shown in it.
    pub fan: &'a [FanRay],
    /// How patches are drawn whose light is interpolated between their corners; none where each has one colour.
    pub smooth: Option<DrawPatches>,
    /// While a question waits at the step, what it hides beside all that is ahead of the step; none where no question waits.
    pub pending: Option<&'a [Hidden]>,
    /// The next step at which a question waits, this one or one ahead; none where none does.
    pub waiting: Option<usize>,
    /// What was answered to the question at the step, as far as pictures show it.
    pub answered: Answered,
    /// The step of what is selected, whose values the inspector shows in place of those of the step.
    pub selected: Option<usize>,
    /// Whether patches are shown with what they have still to shoot, in place of what they have.
    pub unshot: bool,
    /// The two patches that are selected, from the first to the second.
    pub pair: Option<[usize; 2]>,
    /// What the pictures of this run leave for the next ones, which are the same without; none where each is drawn anew.
    pub reused: Option<&'a Reused>,
}

impl<'a> PanelInput<'a> {
    /// What is seen where nobody has chosen, marked or answered anything.
    pub fn of(run: &'a Run, finished: &'a Finished, focus: Focus, language: Language) -> Self {
        PanelInput {
            run,
            finished,
            focus,
            language,
            narrated: &[],
            breakpoints: &[],
            tree: TreeView::whole(),
            pinned: None,
            inspector: InspectorView::whole(),
            presented: None,
            channel: None,
            image: ImageView::WHOLE,
            space: SpaceView::default(),
            fan: &[],
            smooth: None,
            pending: None,
            waiting: None,
            answered: Answered::default(),
            selected: None,
            unshot: false,
            pair: None,
            reused: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_title_is_a_message_without_arguments() {
        for panel in Panel::ALL {
            for language in Language::ALL {
                // A missing argument is a panic of the catalogue.
                let title = panel.title().text(language);
                assert_ne!(title, panel.title().0, "{}", panel.name());
            }
        }
    }
}
