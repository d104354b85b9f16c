//! Plots of what a study found, as display lists: both axes logarithmic, every curve labelled where it runs, the Pareto front
//! marked, quartiles as bars, and the reference's own error as a line.

mod curve;

use super::form::Axes;
use super::harness::{Findings, Part, Point};
use super::report::strings;
use crate::figure::{Axis, Labels, Plot, Scale, Unit, View, legend};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, wrap};
use glam::Vec2;

/// Of the plot of one part in a file, in points.
pub const SIZE: Vec2 = Vec2::new(1000.0, 700.0);
/// Height of its heading.
const HEADING: f32 = 62.0;
const MARGIN: f32 = 20.0;

const TEXT: f32 = 12.0;
const SMALL: f32 = 11.0;

const TIME: Message = Message("study-time");
const RMS_ERROR: Message = Message("study-rms-error");
const OWN_ERROR: Message = Message("study-own-error");
const NO_RESULT: Message = Message("study-no-result");

/// The plots of all parts, two side by side where there are several.
pub fn plot(findings: &Findings, language: Language) -> Picture {
    let plots: Vec<Picture> = findings
        .parts
        .iter()
        .map(|part| {
            let title = findings.study.title.text(language);
            sheet(title, findings.parts.len() > 1, part, language)
        })
        .collect();
    let columns = plots.len().clamp(1, 2);
    let rows = plots.len().div_ceil(columns);
    let mut sheet = Picture::new(SIZE.x * columns as f32, SIZE.y * rows as f32);
    sheet.alt = findings.study.title.text(language).to_string();
    sheet.rect(sheet.bounds(), Ink::Surface);
    for (place, plot) in plots.into_iter().enumerate() {
        sheet.alt += &format!(". {}", plot.alt);
        let at = Vec2::new((place % columns) as f32, (place / columns) as f32);
        sheet.place(at * SIZE, plot);
    }
    sheet
}

/// A part as it stands in a file, under its title.
fn sheet(title: &str, several: bool, part: &Part, language: Language) -> Picture {
    let mut picture = Picture::new(SIZE.x, SIZE.y);
    let title = match several {
        true => {
            let arguments = [("name", title), ("what", &part.title.text(language))];
            Message("common-named").format(language, &arguments)
        }
        false => title.to_string(),
    };
    heading(&mut picture, &title, part, language);
    let size = SIZE - Vec2::new(2.0 * MARGIN, HEADING + 0.5 * MARGIN);
    let plot = plot_part(part, language, size, View::WHOLE);
    picture.place((MARGIN, HEADING), plot);
    picture.alt = in_words(&title, part, language);
    picture
}

/// The coordinates of a point, where the axes have some for it. Zero stands below all other values.
fn coordinates(axes: Axes, point: &Point) -> Option<[f64; 2]> {
    let error = point
        .errors
        .map(|errors| errors.rms)
        .filter(|error| error.is_finite());
    Some(match axes {
        Axes::ErrorOverTime => [point.seconds.median, error?],
        Axes::ErrorOverSize => [point.size, error?],
        Axes::TimeOverSize => [point.size, point.seconds.median],
    })
}

/// The plot of a part, or of it what is looked at. Points carry their tags.
pub fn plot_part(part: &Part, language: Language, size: Vec2, view: View) -> Picture {
    let mut picture = Picture::new(size.x, size.y);
    let Some(plot) = axes(part, language, picture.bounds(), view) else {
        let sorry = Style::Body.size(TEXT).ink(Ink::Muted).middle();
        picture.text_in(picture.bounds(), NO_RESULT.text(language), sorry);
        return picture;
    };
    plot.draw(&mut picture);
    let mut labels = Labels::new(plot.place.grown(-4.0));
    let own = Some(part.reference.error).filter(|_| part.axes != Axes::TimeOverSize);
    if let Some(own) = own.filter(|&own| own > 0.0 && plot.y.scale.holds(own)) {
        own_error(&mut picture, &mut labels, &plot, own, language);
    }
    let mut nameless = Vec::new();
    // Curves, and quartiles, may run beyond the axes.
    picture.clipped(plot.place, |picture| {
        let at = |point: &Point| {
            let [x, y] = coordinates(part.axes, point)?;
            Some(Vec2::new(plot.x.scale.at(x), plot.y.scale.at(y)))
        };
        if part.axes == Axes::ErrorOverTime {
            front(picture, part, &at);
        }
        for (number, line) in part.lines.iter().enumerate() {
            let places: Vec<Vec2> = line.points.iter().filter_map(at).collect();
            labels.avoid_path(&places);
            if places.len() > 1 {
                picture.polyline(places, part.series(number).stroke);
            }
        }
        for (number, line) in part.lines.iter().enumerate() {
            for (index, point) in line.points.iter().enumerate() {
                if let Some(at) = at(point).filter(|&at| plot.place.contains(at)) {
                    let bar = quartiles(&plot, part.axes, point, at);
                    let series = part.series(number);
                    curve::point(picture, &mut labels, ([number, index], series), at, bar);
                }
            }
        }
        let shown = |point: &Point| at(point).filter(|&at| plot.place.contains(at));
        nameless = curve::names(picture, &mut labels, part, language, &shown);
        if part.axes == Axes::ErrorOverTime {
            curve::settings(picture, &mut labels, part, language, &shown);
        }
    });
    let names = nameless.into_iter();
    let names: Vec<_> = names
        .map(|n| (part.series(n).stroke, part.lines[n].name.text(language)))
        .collect();
    let names = names.iter().map(|(stroke, name)| (*stroke, name.as_str()));
    legend(&mut picture, names, plot.beside_name(), plot.place.x);
    picture
}

/// Where the field between the axes stands in a plot of that size.
pub fn field(part: &Part, language: Language, size: Vec2, view: View) -> Option<Rect> {
    let whole = Rect::new(0.0, 0.0, size.x, size.y);
    Some(axes(part, language, whole, view)?.place)
}

/// None where nothing has coordinates.
fn axes(part: &Part, language: Language, whole: Rect, view: View) -> Option<Plot> {
    let places = part.points();
    let places: Vec<[f64; 2]> = places
        .filter_map(|(_, point)| coordinates(part.axes, point))
        .collect();
    let scale = |axis: usize| Scale::logarithmic(places.iter().map(move |place| place[axis]));
    let size = part.size.text(language);
    let quantity = part.quantity.text(language);
    let error = || RMS_ERROR.format(language, &[("quantity", quantity)]);
    let time = |scale| Axis::new(scale, TIME.text(language), language).unit(Unit::Seconds);
    let shown = view.part();
    let across = scale(0)?.part([shown.x.into(), shown.right().into()]);
    let up = scale(1)?.part([1.0 - f64::from(shown.bottom()), 1.0 - f64::from(shown.y)]);
    Some(match part.axes {
        Axes::ErrorOverTime => Plot::new(time(across), Axis::new(up, error(), language), whole),
        Axes::ErrorOverSize => Plot::new(
            Axis::new(across, size, language),
            Axis::new(up, error(), language),
            whole,
        ),
        Axes::TimeOverSize => Plot::new(Axis::new(across, size, language), time(up), whole),
    })
}

/// From quartile to quartile, where an axis shows times.
fn quartiles(plot: &Plot, axes: Axes, point: &Point, at: Vec2) -> Option<[Vec2; 2]> {
    let quartiles = [point.seconds.lower, point.seconds.upper];
    match axes {
        Axes::ErrorOverTime => Some(quartiles.map(|time| Vec2::new(plot.x.scale.at(time), at.y))),
        Axes::TimeOverSize => Some(quartiles.map(|time| Vec2::new(at.x, plot.y.scale.at(time)))),
        Axes::ErrorOverSize => None,
    }
}

fn heading(picture: &mut Picture, title: &str, part: &Part, language: Language) {
    picture.text((MARGIN, 28.0), title, Style::Bold.size(16.0));
    let reference = part.reference.what.text(language);
    let about = match part.axes {
        Axes::TimeOverSize => Message("study-heading-growth").text(language).to_string(),
        Axes::ErrorOverSize => {
            Message("study-heading-reference").format(language, &[("reference", &reference)])
        }
        Axes::ErrorOverTime => {
            Message("study-heading-front").format(language, &[("reference", &reference)])
        }
    };
    let lines = wrap(&about, Style::Body, SMALL, SIZE.x - 2.0 * MARGIN);
    for (row, line) in lines.into_iter().take(2).enumerate() {
        let y = 46.0 + 14.0 * row as f32;
        picture.text((MARGIN, y), line, Style::Body.size(SMALL).ink(Ink::Muted));
    }
}

/// Below this line an error is that of the reference.
fn own_error(
    picture: &mut Picture,
    labels: &mut Labels,
    plot: &Plot,
    own: f64,
    language: Language,
) {
    plot.level(picture, own, Ink::Muted.stroke(1.0).dashed());
    let y = plot.y.scale.at(own);
    let from = Vec2::new(plot.place.x, y);
    labels.avoid(from, Vec2::new(plot.place.right(), y));
    let set = Style::Body.size(SMALL).ink(Ink::Muted);
    let corner = from + Vec2::new(6.0, -16.0);
    labels.put_at(picture, corner, OWN_ERROR.text(language), set, true);
}

/// The steps between what is reached: to the right and then down.
fn front(picture: &mut Picture, part: &Part, at: &dyn Fn(&Point) -> Option<Vec2>) {
    let points = part.points().filter(|(_, point)| point.on_front);
    let mut places: Vec<Vec2> = points.filter_map(|(_, point)| at(point)).collect();
    places.sort_by(|a, b| a.x.total_cmp(&b.x));
    let steps = places.windows(2).flat_map(|pair| {
        let corner = Vec2::new(pair[1].x, pair[0].y);
        [pair[0], corner, pair[1]]
    });
    let steps: Vec<Vec2> = steps.collect();
    if steps.len() > 1 {
        picture.polyline(steps, Ink::Rule.stroke(6.0).opacity(0.6));
    }
    for place in places {
        picture.circle(place, 8.0, Ink::Muted.stroke(1.25));
    }
}

fn in_words(title: &str, part: &Part, language: Language) -> String {
    let lines = part.lines.iter().filter_map(|line| {
        let (first, last) = (line.points.first()?, line.points.last()?);
        let reached = |point: &Point| {
            let time = strings::seconds(point.seconds.median, language);
            let error = point
                .errors
                .map(|errors| language.significant(errors.rms, 2));
            let setting = point.setting.text(language);
            let (setting, time) = (("setting", &*setting), ("time", &*time));
            match error {
                Some(error) => Message("study-point-error")
                    .format(language, &[setting, ("error", &error), time]),
                None => Message("study-point-time").format(language, &[setting, time]),
            }
        };
        let arguments = [
            ("name", &*line.name.text(language)),
            ("what", &[reached(first), reached(last)].join(", ")),
        ];
        Some(Message("common-named").format(language, &arguments))
    });
    format!("{title}. {}", lines.collect::<Vec<_>>().join(". "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Shape, Theme, rasterize};
    use crate::study::tests::findings;

    /// The boxes of all texts of a picture.
    fn texts(picture: &Picture) -> Vec<(Rect, String)> {
        let items = picture.items.iter();
        items
            .filter_map(|item| match &item.shape {
                Shape::Text { text, .. } => Some((item.shape.bounds(), text.clone())),
                _ => None,
            })
            .collect()
    }

    #[test]
    fn no_text_covers_another_and_every_curve_has_its_name() {
        let picture = plot(&findings(), Language::English);
        let texts = texts(&picture);
        for (i, (place, text)) in texts.iter().enumerate() {
            assert!(picture.bounds().encloses(place), "{text}");
            for (other, recorded) in &texts[..i] {
                // Ascenders of one line may lie in the gap below another.
                let common = place.grown(-2.0).intersection(&other.grown(-2.0));
                assert!(common.is_empty(), "{text:?} covers {recorded:?}");
            }
        }
        for name in ["rough", "fine"] {
            assert!(
                texts.iter().any(|(_, text)| text.starts_with(name)),
                "{name}"
            );
        }
        assert!(rasterize(&picture, Theme::Light, 1.0).is_ok());
    }
}
