//! The plot of a part of a study, to be pointed at and clicked. Its axes are logarithmic: what is plotted is log10.

use super::session::{PointAt, Session};
use super::{strings, study_words, style};
use crate::picture::Ink;
use crate::study::form::Axes;
use crate::study::harness::{Part, Point};
use crate::study::plot::axis::whole_seconds;
use crate::study::plot::coordinates;
use crate::study::plot::curve::{Look, Mark};
use egui::{Color32, Role, Ui, WidgetInfo};
use egui_plot::{GridInput, GridMark, Line, LineStyle, MarkerShape, Plot, PlotPoint, Points};
use std::ops::RangeInclusive;

/// How near the pointer must come to a point, in egui's points.
const NEAR: f32 = 14.0;
const RADIUS: f32 = 4.5;

/// What the pointer does to the points of a plot.
#[derive(Default)]
pub struct Pointed {
    pub at: Option<PointAt>,
    pub clicked: bool,
}

/// Shows the part, `lit` brought out.
pub fn show(session: &Session, part: &Part, lit: Option<PointAt>, ui: &mut Ui) -> Pointed {
    let theme = session.look.theme;
    let ink = |ink| style::color(theme, ink);
    let scales = Scales::of(part);
    let index = session.studying().part;
    let places: Vec<(PointAt, [f64; 2])> = scales.places(part, index).collect();
    let own = Some(part.reference.error).filter(|&error| {
        error > 0.0 && part.axes != Axes::TimeOverSize && error.log10() > scales.lowest(1)
    });
    let [across, up] = names(session, part);
    let [across_times, up_times] =
        [Axes::ErrorOverTime, Axes::TimeOverSize].map(|a| a == part.axes);
    let [zero_across, zero_up] = scales.zero;
    let plot = Plot::new((session.studying().of.map(|(study, _)| study.name), index))
        .x_axis_label(across)
        .y_axis_label(up)
        .x_grid_spacer(ticks)
        .y_grid_spacer(ticks)
        .x_axis_formatter(move |mark, range| tick(mark, range, across_times, zero_across))
        .y_axis_formatter(move |mark, range| tick(mark, range, up_times, zero_up))
        .show_crosshair(false)
        .label_formatter(|_| None)
        .grid_color(ink(Ink::Rule))
        .height(ui.available_height());
    let shown = plot.show(ui, |plot| {
        if let Some(own) = own {
            let line = egui_plot::HLine::new("own error", own.log10());
            let dashed = LineStyle::dashed_loose();
            plot.hline(line.color(ink(Ink::Muted)).style(dashed).allow_hover(false));
        }
        if part.axes == Axes::ErrorOverTime {
            let of = |at: &PointAt| &part.lines[at.line].points[at.point];
            let on_front = places.iter().filter(|(at, _)| of(at).on_front);
            front(
                on_front.map(|(_, place)| *place).collect(),
                ink(Ink::Muted),
                plot,
            );
        }
        for (number, line) in part.lines.iter().enumerate() {
            let look = Look::of(number);
            let color = ink(look.ink);
            let of_line = || places.iter().filter(|(at, _)| at.line == number);
            let curve: Vec<[f64; 2]> = of_line().map(|(_, place)| *place).collect();
            for (at, place) in of_line() {
                let bar = scales.bar(part.axes, &line.points[at.point], *place);
                let name = format!("bar {number} {}", at.point);
                plot.line(path(name, bar.to_vec(), color).width(1.0));
            }
            let drawn = path(line.name.clone(), curve.clone(), color);
            let style = match look.dashed {
                true => LineStyle::dashed_dense(),
                false => LineStyle::Solid,
            };
            plot.line(drawn.width(1.75).style(style));
            let marks = Points::new(format!("{} marks", line.name), curve).color(color);
            plot.points(
                marks
                    .shape(shape(look.mark))
                    .radius(RADIUS)
                    .allow_hover(false),
            );
        }
        let lit = places.iter().filter(|(at, _)| Some(*at) == lit);
        let lit: Vec<[f64; 2]> = lit.map(|(_, place)| *place).collect();
        let ring = Points::new("lit", lit)
            .color(ink(Ink::Linked))
            .filled(false);
        plot.points(
            ring.shape(MarkerShape::Circle)
                .radius(11.0)
                .allow_hover(false),
        );
    });
    let name = session.localize(strings::STUDY_PLOT);
    let response = shown.response;
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
    let at = response.hover_pos().and_then(|pointer| {
        let distance = |place: &[f64; 2]| {
            let place = PlotPoint::from(*place);
            shown
                .transform
                .position_from_point(&place)
                .distance(pointer)
        };
        let distances = places.iter().map(|(at, place)| (*at, distance(place)));
        let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.filter(|(_, distance)| *distance < NEAR)
    });
    let at = at.map(|(at, _)| at);
    let clicked = response.clicked();
    if let Some((_, line, point)) = at.and_then(|at| session.studying().point(at)) {
        ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        let recorded = study_words::recorded(session, line, point);
        response.on_hover_text_at_pointer(recorded);
    }
    Pointed { at, clicked }
}

/// The steps between what is reached: to the right and then down.
fn front(mut places: Vec<[f64; 2]>, color: Color32, plot: &mut egui_plot::PlotUi) {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    // No point twice in a row, or the line would have no direction there.
    let mut steps: Vec<[f64; 2]> = Vec::new();
    for pair in places.windows(2) {
        steps.extend([pair[0], [pair[1][0], pair[0][1]]]);
    }
    steps.extend(places.last());
    steps.dedup();
    let faint = color.gamma_multiply(0.3);
    plot.line(path("front".into(), steps, faint).width(6.0));
    let rings = Points::new("on front", places).color(color).filled(false);
    plot.points(
        rings
            .shape(MarkerShape::Circle)
            .radius(8.0)
            .allow_hover(false),
    );
}

/// A line through these places, also where it is upright: no band of values at one place.
fn path(name: String, places: Vec<[f64; 2]>, color: Color32) -> Line<'static> {
    Line::new(name, places)
        .color(color)
        .allow_band(false)
        .allow_hover(false)
}

/// From values to their logarithms.
struct Scales {
    /// Where zero stands, an axis each: below everything else. None where it does not occur.
    zero: [Option<f64>; 2],
    lowest: [f64; 2],
}

impl Scales {
    fn of(part: &Part) -> Scales {
        let places = part.points();
        let places: Vec<[f64; 2]> = places
            .filter_map(|(_, point)| coordinates(part.axes, point))
            .collect();
        let axis = |axis: usize| {
            let values = places.iter().map(|place| place[axis]);
            let positive = values.clone().filter(|&value| value > 0.0);
            let lowest = positive.reduce(f64::min).unwrap_or(1.0).log10();
            let zero = values.into_iter().any(|value| value == 0.0);
            (lowest, zero.then_some(lowest.floor() - 1.0))
        };
        let [(across, zero_across), (up, zero_up)] = [axis(0), axis(1)];
        Scales {
            zero: [zero_across, zero_up],
            lowest: [across, up],
        }
    }

    /// The least logarithm on an axis.
    fn lowest(&self, axis: usize) -> f64 {
        self.zero[axis].unwrap_or(self.lowest[axis])
    }

    fn at(&self, axis: usize, value: f64) -> f64 {
        match value > 0.0 {
            true => value.log10(),
            false => self.lowest(axis),
        }
    }

    /// The points that have coordinates.
    fn places<'a>(
        &'a self,
        part: &'a Part,
        index: usize,
    ) -> impl Iterator<Item = (PointAt, [f64; 2])> + 'a {
        let lines = part.lines.iter().enumerate();
        lines.flat_map(move |(line, of)| {
            let points = of.points.iter().enumerate();
            points.filter_map(move |(point, found)| {
                let [across, up] = coordinates(part.axes, found)?;
                let at = PointAt {
                    part: index,
                    line,
                    point,
                };
                Some((at, [self.at(0, across), self.at(1, up)]))
            })
        })
    }

    /// From quartile to quartile; a point where the axes show no time.
    fn bar(&self, axes: Axes, point: &Point, place: [f64; 2]) -> [[f64; 2]; 2] {
        let quartiles = [point.seconds.lower, point.seconds.upper];
        match axes {
            Axes::ErrorOverTime => quartiles.map(|time| [self.at(0, time), place[1]]),
            Axes::TimeOverSize => quartiles.map(|time| [place[0], self.at(1, time)]),
            Axes::ErrorOverSize => [place; 2],
        }
    }
}

/// What stands at the axes: across, and up.
fn names(session: &Session, part: &Part) -> [String; 2] {
    let language = session.look.language;
    let size = part.size.text(language).to_owned();
    let time = session.localize(strings::TIME_OF_A_RUN).to_owned();
    let quantity = part.quantity.text(language);
    let error = strings::RMS_ERROR_OF.format(language, &[("quantity", quantity)]);
    match part.axes {
        Axes::ErrorOverTime => [time, error],
        Axes::ErrorOverSize => [size, error],
        Axes::TimeOverSize => [size, time],
    }
}

fn shape(mark: Mark) -> MarkerShape {
    match mark {
        Mark::Disc => MarkerShape::Circle,
        Mark::Square => MarkerShape::Square,
        Mark::Triangle => MarkerShape::Up,
        Mark::Diamond => MarkerShape::Diamond,
        Mark::Funnel => MarkerShape::Down,
    }
}

/// Decades, and between them 2 to 9 times each, as far as they are not too many.
fn ticks(input: GridInput) -> Vec<GridMark> {
    const MOST_DECADES: f64 = 60.0;
    let (low, high) = input.bounds;
    if !(0.0..MOST_DECADES).contains(&(high - low)) {
        return Vec::new();
    }
    let decades = low.floor() as i32..=high.ceil() as i32;
    let ticks = decades.flat_map(|decade| {
        (1..10).map(move |times| GridMark {
            value: f64::from(decade) + f64::from(times).log10(),
            step_size: if times == 1 { 1.0 } else { 0.1 },
        })
    });
    ticks
        .filter(|tick| (low..=high).contains(&tick.value))
        .collect()
}

/// What is written at a tick: of every decade, and of what lies between where there is hardly one to be seen.
fn tick(mark: GridMark, range: &RangeInclusive<f64>, seconds: bool, zero: Option<f64>) -> String {
    let decade = mark.value.floor();
    let times = 10_f64.powf(mark.value - decade).round();
    let few = range.end() - range.start() < 1.5;
    let wanted = times == 1.0 || few && [2.0, 5.0].contains(&times);
    if !wanted || zero.is_some_and(|zero| mark.value < zero) {
        return String::new();
    }
    if zero.is_some_and(|zero| mark.value < zero + 1.0) {
        return if times == 1.0 { "0" } else { "" }.into();
    }
    let power = decade as i32;
    if seconds {
        return whole_seconds(times, power);
    }
    let value = times * 10_f64.powi(power);
    match power {
        0..5 => format!("{value}"),
        _ => format!("{value:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_written_as_the_values_whose_logarithms_they_are() {
        let mark = |value: f64| GridMark {
            value,
            step_size: 1.0,
        };
        let wide = -8.0..=0.0;
        for (value, seconds, zero, recorded) in [
            (-3.0, true, None, "1 ms"),
            (-3.0, false, None, "1e-3"),
            (2.0, false, None, "100"),
            (2_f64.log10(), false, None, ""),
            (-5.0, false, Some(-5.0), "0"),
            (-4.0, false, Some(-5.0), "1e-4"),
        ] {
            assert_eq!(tick(mark(value), &wide, seconds, zero), recorded, "{value}");
        }
        assert_eq!(tick(mark(2_f64.log10()), &(0.0..=1.0), false, None), "2");
    }

    #[test]
    fn no_bounds_make_too_many_ticks() {
        for bounds in [
            (0.0, 1e9),
            (f64::NEG_INFINITY, f64::INFINITY),
            (f64::NAN, 1.0),
        ] {
            let input = GridInput {
                bounds,
                base_step_size: 1.0,
            };
            assert!(ticks(input).is_empty());
        }
    }
}
