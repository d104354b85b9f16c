//! What is known of a patch, and of what passes between two: for the card at the pointer and for the labels in pictures.

use super::horizon::UNKNOWN;
use super::message::labelled;
use super::names;
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::replay::Run;
use crate::replay::radiosity::used_form_factors;

const PATCH: Message = Message("patches-patch");
const UNSHOT: Message = Message("radiosity-unshot");

/// The name and the number of a patch, its light so far, what it emits and reflects, what it has still to shoot, and its area; a
/// line each. None where the run has no such patch.
pub fn patch_values(input: &PanelInput, patch: usize) -> Option<String> {
    let room = input.run.enclosure()?;
    if patch >= room.patches.len() {
        return None;
    }
    let language = input.language;
    let name = names::patch(input.run.prepared(), room, patch, language);
    let arguments = [("name", &*name), ("number", &patch.to_string())];
    let mut lines = vec![PATCH.format(language, &arguments)];
    let colors = |symbol: &str, color: Rgb| format!("{symbol} = {}", in_channels(color, language));
    if let Run::Radiosity(_, replay) = input.run {
        let state = replay.state();
        lines.push(colors("B", state.radiosity(room)[patch]));
        if let Some(unshot) = state.unshot(room) {
            let channel = names::word(unshot.channel, language);
            let symbol = UNSHOT.format(language, &[("channel", &channel)]);
            let value = language.short(unshot.patches[patch], 4);
            lines.push(labelled(&symbol, &value, language));
        }
    }
    if let Run::Hierarchical(_, replay) = input.run {
        lines.push(colors("B", replay.state().light(room)[patch]));
    }
    lines.push(colors("E", room.emission[patch]));
    lines.push(colors("ρ", room.reflectance[patch]));
    lines.push(format!(
        "A = {}",
        language.short(room.patches[patch].area, 4)
    ));
    Some(lines.join("\n"))
}

/// One number where all channels are equal.
fn in_channels(color: Rgb, language: Language) -> String {
    let channels = color.channels();
    let written = channels.map(|channel| language.short(channel, 4));
    match channels.iter().all(|&channel| channel == channels[0]) {
        true => written[0].clone(),
        false => language.list(written),
    }
}

/// `F_{3, 5} = 0.0123`; a question mark where it is hidden. None where the run has no such form factor.
pub fn form_factor(input: &PanelInput, [i, j]: [usize; 2]) -> Option<String> {
    let f = match found(input, [i, j])? {
        Some(f) => input.language.significant(f, 4),
        None => UNKNOWN.to_string(),
    };
    Some(format!("F_{{{i}, {j}}} = {f}"))
}

/// The same with the names of the two patches, a line each.
pub fn form_factor_values(input: &PanelInput, [i, j]: [usize; 2]) -> Option<String> {
    let room = input.run.enclosure()?;
    let name = |patch| names::patch(input.run.prepared(), room, patch, input.language);
    let f = form_factor(input, [i, j])?;
    Some(format!("{f}\ni = {i}: {}\nj = {j}: {}", name(i), name(j)))
}

/// F_ij as the run has it; none while a question waits and no step has used it.
fn found(input: &PanelInput, [i, j]: [usize; 2]) -> Option<Option<f64>> {
    let n = input.run.enclosure()?.patches.len();
    if i.max(j) >= n {
        return None;
    }
    match input.run {
        Run::Radiosity(_, replay) => {
            let f = *input
                .run
                .enclosure()
                .and_then(Enclosure::matrix)?
                .get(i * n + j)?;
            let is_hidden = input.is_pending() && !used_form_factors(replay, n)[i * n + j];
            Some(Some(f).filter(|_| !is_hidden))
        }
        Run::FormFactor(_, replay) => {
            let (from, to, ..) = replay.state().pair?;
            let is_it = [from as usize, to as usize] == [i, j];
            replay.state().found.filter(|_| is_it).map(|(f, _)| Some(f))
        }
        _ => None,
    }
}
