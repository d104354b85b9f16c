//! A place in a lesson as the end of an address, which a page opens and the program too:
//! `#lesson=shadows&change=0:3,5,4&pixel=12,30&step=12&language=id&theme=projector&panel=vectors&present`; or of a walk through one's
//! own scene, whose text it holds: `#scene=…&method=ray-tracing&pixel=12,30&step=4`.

mod part;
mod scene_text;

pub(super) use scene_text::{pack, unpack};

use crate::algorithms::focus::Focus;
use crate::language::Language;
use crate::panels::Panel;
use crate::picture::Theme;
use crate::render::Method;
use std::fmt::{self, Display, Formatter};
use std::sync::Arc;

/// All keys, for who writes another one.
const KEYS: &str = "lesson, scene, mistakes, method, change, step, language, theme, panel, present, and one of frame, polygon, scan-line, \
    pixel, iterations, patch and form-factor";

/// What an address says; what it does not say stays as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// By its id; the page of all lessons unless given.
    pub lesson: Option<String>,
    /// The packed text of a scene to walk through, in place of a lesson.
    pub scene: Option<Arc<str>>,
    /// The page of classic mistakes, in place of a lesson.
    pub mistakes: bool,
    /// Of a walk through a scene.
    pub method: Option<Method>,
    /// Values of parameters, each by its place among those that may be changed; all others have the values of the lesson.
    pub changes: Vec<(usize, Vec<f64>)>,
    /// The part of the picture or of the exchange whose steps are meant; that of the lesson unless given.
    pub focus: Option<Focus>,
    pub step: Option<usize>,
    pub language: Option<Language>,
    pub theme: Option<Theme>,
    /// The one that was chosen as the large one.
    pub panel: Option<Panel>,
    pub presenting: bool,
}

impl Link {
    /// Reads what follows the `#` of an address. Errors: what is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut link = Link::default();
        for part in text.split('&').filter(|part| !part.is_empty()) {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            let wrong =
                |allowed: &str| format!("the address says {key}={value:?}; {key} takes {allowed}");
            match key {
                "lesson" if !value.is_empty() => link.lesson = Some(value.to_owned()),
                "lesson" => return Err(wrong("the id of a lesson")),
                "scene" if !value.is_empty() => link.scene = Some(value.into()),
                "scene" => return Err(wrong("the text of a scene, as Share gives it")),
                "method" => {
                    let method = Method::from_name(value);
                    let names = || Method::ALL.map(Method::name).join(", ");
                    link.method = Some(method.ok_or_else(|| wrong(&names()))?);
                }
                "change" => {
                    let change = part::change(value);
                    let right = "the place of a parameter and its value, as 0:0.5 or 1:3,5,4";
                    link.changes.push(change.ok_or_else(|| wrong(right))?);
                }
                "step" => {
                    let step = value.parse();
                    link.step = Some(step.map_err(|_| wrong("a whole number from 0"))?);
                }
                "language" => {
                    let known = Language::ALL.into_iter();
                    let named = known.into_iter().find(|known| known.code() == value);
                    link.language = Some(named.ok_or_else(|| wrong("en or id"))?);
                }
                "theme" => {
                    let theme = Theme::from_name(value);
                    let names = || Theme::ALL.map(Theme::name).join(", ");
                    link.theme = Some(theme.ok_or_else(|| wrong(&names()))?);
                }
                "panel" => {
                    let panel = Panel::called(value);
                    let names = || Panel::ALL.map(Panel::name).join(", ");
                    link.panel = Some(panel.ok_or_else(|| wrong(&names()))?);
                }
                "present" => link.presenting = true,
                "mistakes" => link.mistakes = true,
                _ if part::counts(key).is_some() => {
                    let focus = part::focus(key, value);
                    let right = match part::counts(key) {
                        Some(0) => "nothing",
                        Some(1) => "a whole number from 0",
                        _ => "two whole numbers from 0, as 12,30",
                    };
                    link.focus = Some(focus.ok_or_else(|| wrong(right))?);
                }
                _ => return Err(format!("the address says {key:?}; it takes {KEYS}")),
            }
        }
        link.checked()
    }

    fn checked(self) -> Result<Self, String> {
        let pages = [self.mistakes, self.lesson.is_some(), self.scene.is_some()];
        if pages.into_iter().filter(|&page| page).count() > 1 {
            return Err(
                "the address says more than one of a lesson, a scene and the page of classic mistakes"
                    .into(),
            );
        }
        let is_walk = self.lesson.is_some() || self.scene.is_some();
        let has_place = self.step.is_some() || self.panel.is_some() || self.focus.is_some();
        if !is_walk && (has_place || !self.changes.is_empty()) {
            return Err(
                "the address says a step, a panel, a part or a change, and no lesson".into(),
            );
        }
        if self.scene.is_none() && self.method.is_some() {
            return Err("the address says a method, and no scene; a lesson has its own".into());
        }
        Ok(self)
    }
}

/// As it follows the `#` of an address.
impl Display for Link {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        parts.extend(self.lesson.as_ref().map(|id| format!("lesson={id}")));
        parts.extend(self.scene.as_ref().map(|text| format!("scene={text}")));
        parts.extend(self.mistakes.then(|| "mistakes".to_owned()));
        let method = self.method.map(Method::name);
        parts.extend(method.map(|name| format!("method={name}")));
        parts.extend(self.changes.iter().map(part::of_change));
        parts.extend(self.focus.map(part::of_focus));
        parts.extend(self.step.map(|step| format!("step={step}")));
        let language = self.language.map(Language::code);
        parts.extend(language.map(|code| format!("language={code}")));
        let theme = self.theme.map(Theme::name);
        parts.extend(theme.map(|name| format!("theme={name}")));
        let panel = self.panel.map(Panel::name);
        parts.extend(panel.map(|name| format!("panel={name}")));
        parts.extend(self.presenting.then(|| "present".to_owned()));
        f.write_str(&parts.join("&"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_address_says_what_would_be_right() {
        for (text, part) in [
            ("lesson=", "the id of a lesson"),
            ("lesson=shadows&step=-1", "a whole number from 0"),
            ("language=fr", "en or id"),
            ("theme=pink", "light, dark, projector"),
            ("lesson=shadows&panel=rayz", "ray-tree"),
            ("lessson=shadows", "it takes lesson, scene"),
            ("lesson=shadows&change=0", "as 0:0.5"),
            ("lesson=shadows&change=0:NaN", "as 0:0.5"),
            ("lesson=shadows&change=-1:1", "as 0:0.5"),
            ("lesson=shadows&pixel=1", "as 12,30"),
            ("lesson=shadows&frame=1", "takes nothing"),
            ("lesson=shadows&patch=-1", "a whole number"),
            ("lesson=shadows&method=gouraud", "no scene"),
            ("scene=", "as Share gives it"),
            ("scene=abc&method=rays", "ray-tracing"),
            ("scene=abc&lesson=shadows", "more than one"),
            ("change=0:1", "no lesson"),
            ("step=3", "no lesson"),
            ("mistakes&step=3", "no lesson"),
            ("mistakes&lesson=shadows", "more than one"),
        ] {
            let error = Link::parse(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }

    #[test]
    fn what_is_written_is_what_is_read() {
        for text in [
            "",
            "mistakes&language=id",
            "lesson=shadows&change=0:3,5.5,-4&change=2:0.0001&pixel=12,30&step=7",
            "lesson=gathering&iterations=0,3&step=2&language=en&theme=dark&panel=matrix&present",
            "scene=aGk&method=gouraud&polygon=2",
            "scene=aGk&scan-line=2",
            "scene=aGk&frame",
            "scene=aGk&patch=4",
            "scene=aGk&form-factor=4,1",
        ] {
            let read = Link::parse(text).unwrap();
            assert_eq!(read.to_string(), text);
        }
    }
}
