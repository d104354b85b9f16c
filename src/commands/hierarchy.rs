//! The options of hierarchical radiosity.

use super::arguments::parse_number;
use super::failure::Failure;
use super::notes;
use crate::algorithms::hierarchical::Settings;
use crate::methods::Method;
use crate::scene::Note;

/// When links are refined.
#[derive(clap::Args, Clone, Copy)]
pub struct HierarchyArguments {
    /// Of hierarchical radiosity: how large an element may be, seen from the other, to be linked in the first pass [default: 0.2]
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_number)]
    link_size: Option<f64>,
    /// How much light a link may carry in the last pass, as a share of all that is emitted [default: 0.00001]
    #[arg(long, value_name = "BFA", allow_negative_numbers = true, value_parser = parse_number)]
    link_light: Option<f64>,
    /// What is no larger is not divided [default: 0]
    #[arg(long, value_name = "A", allow_negative_numbers = true, value_parser = parse_number)]
    smallest_area: Option<f64>,
}

impl HierarchyArguments {
    fn given(self) -> impl Iterator<Item = &'static str> {
        let all = [
            ("--link-size", self.link_size),
            ("--link-light", self.link_light),
            ("--smallest-area", self.smallest_area),
        ];
        all.into_iter()
            .filter_map(|(option, value)| value.map(|_| option))
    }

    pub fn is_given(self) -> bool {
        self.given().next().is_some()
    }

    /// Notes on the options given, where `method` has no use for them.
    pub fn notes(self, method: Method) -> Vec<Note> {
        let has_use = |method| method == Method::HierarchicalRadiosity;
        notes::without_effect(self.given(), method, has_use)
    }

    /// The options given, and for the rest those of `unless`.
    pub fn or(self, unless: Settings) -> Result<Settings, Failure> {
        let settings = Settings {
            link_size: self.link_size.unwrap_or(unless.link_size),
            link_light: self.link_light.unwrap_or(unless.link_light),
            smallest_area: self.smallest_area.unwrap_or(unless.smallest_area),
            ..unless
        };
        settings.check().map_err(|why| {
            Failure::Wrong(format!("--{}", why.to_string().replacen('_', "-", 1)))
        })?;
        Ok(settings)
    }
}
