//! Error against run time: a study is chosen and measured, and what it finds is shown curve by curve and point by point.

use super::button::button;
use super::session::{Command, Outcome, PointAt, Session, StudyCommand, name_of_point};
use super::study_plot::StudyPlot;
use super::{prose, strings, study_words, style};
use crate::language::Message;
use crate::picture::Ink;
use crate::study::families;
use crate::study::fit::{Fit, Law};
use crate::study::form::Axes;
use crate::study::harness::{Line, Part};
use crate::study::report::strings as report;
use egui::{Button, ComboBox, Frame, Margin, ProgressBar, RichText, ScrollArea, TextStyle, Ui};
use std::time::Duration;

/// How long to wait before looking whether more has come.
const LOOK_AGAIN: Duration = Duration::from_millis(50);
/// Of the list of points.
const LIST: f32 = 330.0;
/// Of what is said of one point.
const WORDS: f32 = 118.0;

pub fn show(session: &Session, plot: &mut StudyPlot, commands: &mut Vec<Command>, ui: &mut Ui) {
    if session.studying().percent().is_some() {
        ui.ctx().request_repaint_after(LOOK_AGAIN);
    }
    let frame = Frame::new().inner_margin(Margin::same(14));
    egui::CentralPanel::no_frame().frame(frame).show(ui, |ui| {
        choose(session, commands, ui);
        state(session, ui);
        ui.add_space(4.0);
        let studying = session.studying();
        match studying.parts.get(studying.part) {
            Some(part) => found(session, part, plot, commands, ui),
            None if studying.percent().is_none() => {
                ui.label(session.localize(strings::NOTHING_MEASURED));
            }
            None => {}
        }
    });
}

/// Which study, and its buttons.
fn choose(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let studying = session.studying();
    let language = session.look.language;
    let chosen = families::ALL[studying.chosen];
    ui.horizontal_wrapped(|ui| {
        ui.label(style::strong(session.localize(strings::STUDIES), 17.0));
        ui.add_space(8.0);
        ComboBox::from_label(session.localize(strings::STUDY))
            .selected_text(chosen.title.text(language))
            .width(300.0)
            .show_ui(ui, |ui| {
                for (index, study) in families::ALL.iter().enumerate() {
                    let title = Button::new(study.title.text(language));
                    let button = title.selected(index == studying.chosen);
                    if ui.add(button).clicked() {
                        commands.push(Command::Study(StudyCommand::Choose(index)));
                    }
                }
            });
        let mut quick = studying.quick;
        if ui
            .checkbox(&mut quick, session.localize(strings::QUICK))
            .clicked()
        {
            commands.push(Command::Study(StudyCommand::Quick));
        }
        for (strings, command) in [
            (strings::MEASURE, StudyCommand::Measure),
            (strings::CALL_OFF, StudyCommand::Cancel),
            (strings::BACK_TO_THE_RUN, StudyCommand::View),
        ] {
            let name = session.localize(strings);
            let command = Command::Study(command);
            button(session, Button::new(name), name, command, commands, ui);
        }
    });
    ui.label(chosen.about.text(language));
    if cfg!(debug_assertions) {
        let warn = style::color(session.look.theme, Ink::Warn);
        ui.label(RichText::new(session.localize(strings::DEBUG_BUILD)).color(warn));
    }
}

/// How far the measuring is, and what became of it.
fn state(session: &Session, ui: &mut Ui) {
    let studying = session.studying();
    if let Some(percent) = studying.percent() {
        let recorded =
            strings::MEASURING.format(session.look.language, &[("percent", &percent.to_string())]);
        let bar = ProgressBar::new(percent as f32 / 100.0).desired_height(18.0);
        ui.add(bar.text(recorded));
    }
    match &studying.outcome {
        Outcome::Well => {}
        Outcome::Cancelled => drop(ui.label(session.localize(strings::CALLED_OFF))),
        Outcome::Because(why) => {
            let recorded =
                strings::NO_FINDINGS.format(session.look.language, &[("why", &why.to_string())]);
            ui.label(recorded);
        }
    }
}

/// The parts that have come, and of one its plot, its points, and one of them in words.
fn found(
    session: &Session,
    part: &Part,
    plot: &mut StudyPlot,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let studying = session.studying();
    let mut heading = String::new();
    if let Some((study, _)) = studying.of {
        heading = study.title.text(session.look.language).into();
    }
    ui.label(style::strong(heading, 15.0));
    if studying.parts.len() > 1 {
        ui.horizontal_wrapped(|ui| {
            for (index, part) in studying.parts.iter().enumerate() {
                let chip = Button::new(part.title.text(session.look.language))
                    .selected(index == studying.part);
                if ui.add(chip).clicked() {
                    commands.push(Command::Study(StudyCommand::Part(index)));
                }
            }
        });
    }
    let room = ui.available_size();
    let lit = ui.scope_id().with("lit");
    let lit_before: Option<PointAt> = ui.data(|data| data.get_temp(lit)).flatten();
    let shown = lit_before.or(studying.picked);
    let mut now_lit = None;
    let height = (room.y - WORDS).max(160.0);
    ui.horizontal_top(|ui| {
        let width = (room.x - LIST - 12.0).max(240.0);
        let down = egui::Layout::top_down(egui::Align::Min);
        ui.allocate_ui_with_layout(egui::vec2(width, height), down, |ui| {
            let pointed = plot.show(session, part, shown, ui);
            now_lit = pointed.at;
            if let Some(at) = pointed.at.filter(|_| pointed.clicked) {
                commands.push(Command::Study(StudyCommand::Pick(at)));
            }
        });
        ui.allocate_ui_with_layout(egui::vec2(LIST, height), down, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                now_lit = points(session, part, commands, ui).or(now_lit);
            });
        });
    });
    ui.data_mut(|data| data.insert_temp(lit, now_lit));
    if now_lit != lit_before {
        ui.ctx().request_repaint();
    }
    ScrollArea::vertical().id_salt("words").show(ui, |ui| {
        match shown.and_then(|at| studying.point(at)) {
            Some((_, line, point)) => {
                ui.label(study_words::recorded(session, line, point));
            }
            None => about(session, part, ui),
        }
    });
}

/// What the plot as a whole shows.
fn about(session: &Session, part: &Part, ui: &mut Ui) {
    if part.axes == Axes::ErrorOverTime {
        ui.label(session.localize(strings::PARETO));
    }
    if part.axes != Axes::TimeOverSize {
        let reference = &part.reference;
        let own = session.look.language.significant(reference.error, 2);
        let said = session.localize(strings::REFERENCE);
        let [what, known_by] =
            [&reference.what, &reference.known_by].map(|label| label.text(session.look.language));
        ui.label(format!("{said}: {what} (± {own}; {known_by})."));
    }
    for failed in &part.failed {
        let [curve, setting] =
            [&failed.curve, &failed.setting].map(|label| label.text(session.look.language));
        let no = strings::NO_FINDINGS.format(session.look.language, &[("why", &failed.why)]);
        ui.label(format!("{curve}, {setting}. {no}."));
    }
}

/// Every point as a button, curve by curve; returns the one that is pointed at or has the focus.
fn points(
    session: &Session,
    part: &Part,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<PointAt> {
    let mut lit = None;
    for (number, line) in part.lines.iter().enumerate() {
        let color = style::color(session.look.theme, part.series(number).ink);
        let language = session.look.language;
        ui.label(style::strong(line.name.text(language), 13.0).color(color));
        let small = TextStyle::Small.resolve(ui.style());
        ui.label(prose::set(
            session,
            &laws(session, part, line),
            small,
            Ink::Text,
        ));
        for (index, point) in line.points.iter().enumerate() {
            let at = PointAt {
                part: session.studying().part,
                line: number,
                point: index,
            };
            let ring = if point.on_front { "○ " } else { "" };
            let mut text = ring.to_owned() + &point.setting.text(language);
            if let Some(errors) = point.errors {
                text += &format!("   {}", session.look.language.significant(errors.rms, 2));
            }
            text += &format!(
                "   {}",
                report::seconds(point.seconds.median, session.look.language)
            );
            let picked = session.studying().picked == Some(at);
            let button = Button::new(RichText::new(text).small()).selected(picked);
            let response = ui.add(button);
            let name = name_of_point(line, point, language);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
            let description = study_words::recorded(session, line, point);
            ui.ctx()
                .accesskit_node_builder(response.id, |node| node.set_description(description));
            if response.clicked() {
                commands.push(Command::Study(StudyCommand::Pick(at)));
            }
            if response.hovered() || response.has_focus() {
                lit = Some(at);
            }
        }
        ui.add_space(6.0);
    }
    lit
}

/// How error falls and time grows along a curve, as far as they do by a law.
fn laws(session: &Session, part: &Part, line: &Line) -> String {
    let language = session.look.language;
    let size = part.size.text(language);
    let law = |message: Message, fit: Option<Fit>| {
        let fit = fit.filter(|fit| fit.is_clean() && !fit.is_level());
        let recorded = fit.map_or_else(
            || session.localize(strings::NO_LAW).to_owned(),
            |fit| match fit.law {
                Law::Power => format!("∝ n^{{{}}}", language.fixed(fit.rate, 2)),
                Law::Geometric => format!("∝ {}^n", language.fixed(fit.rate, 3)),
            },
        );
        message.format(language, &[("law", &recorded)])
    };
    let error = law(strings::ERROR_FALLS, line.convergence);
    let time = law(strings::TIME_GROWS, line.growth);
    match part.axes {
        Axes::TimeOverSize => format!("{time}, n: {size}"),
        _ => format!("{error}, {time}, n: {size}"),
    }
}
