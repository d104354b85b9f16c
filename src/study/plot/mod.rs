//! Plots of what a study found, as display lists: both axes logarithmic, every curve labelled where it runs, the Pareto front
//! marked, quartiles as bars, and the reference's own error as a line.

pub mod axis;
pub mod curve;

use super::form::Axes;
use super::harness::{Findings, Part, Point};
use super::report::strings;
use crate::language::Language;
use crate::panels::labels::Labels;
use crate::picture::{Ink, Picture, Rect, Style};
use axis::{Axis, Named, Span};
use curve::Look;
use glam::Vec2;

/// Of the plot of one part, in points.
pub const SIZE: Vec2 = Vec2::new(1000.0, 700.0);

const TEXT: f32 = 12.0;
const SMALL: f32 = 10.5;

/// The plots of all parts, two side by side where there are several.
pub fn plot(findings: &Findings) -> Picture {
    let plots: Vec<Picture> = findings
        .parts
        .iter()
        .map(|part| {
            plot_part(
                findings.study.title.text(Language::English),
                findings.parts.len() > 1,
                part,
            )
        })
        .collect();
    let columns = plots.len().clamp(1, 2);
    let rows = plots.len().div_ceil(columns);
    let mut sheet = Picture::new(SIZE.x * columns as f32, SIZE.y * rows as f32);
    sheet.alt = findings.study.title.text(Language::English).to_string();
    sheet.rect(sheet.bounds(), Ink::Surface);
    for (place, plot) in plots.into_iter().enumerate() {
        sheet.alt += &format!(". {}", plot.alt);
        let at = Vec2::new((place % columns) as f32, (place / columns) as f32);
        sheet.place(at * SIZE, plot);
    }
    sheet
}

/// The coordinates of a point, where the axes have some for it. An error of zero has none on a logarithmic axis: it is told as 0.
pub fn coordinates(axes: Axes, point: &Point) -> Option<[f64; 2]> {
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

fn plot_part(title: &str, several: bool, part: &Part) -> Picture {
    let mut picture = Picture::new(SIZE.x, SIZE.y);
    picture.rect(picture.bounds(), Ink::Surface);
    let title = match several {
        true => format!("{title}: {}", part.title.text(Language::English)),
        false => title.to_string(),
    };
    heading(&mut picture, &title, part);
    let place = Rect::new(86.0, 74.0, SIZE.x - 86.0 - 24.0, SIZE.y - 74.0 - 58.0);
    let coordinates: Vec<[f64; 2]> = part
        .points()
        .filter_map(|(_, point)| coordinates(part.axes, point))
        .collect();
    let own = Some(part.reference.error).filter(|_| part.axes != Axes::TimeOverSize);
    let spans = [0, 1].map(|axis| Span::of(coordinates.iter().map(|point| point[axis])));
    let [Some(across), Some(up)] = spans else {
        let sorry = Style::Body.size(TEXT).ink(Ink::Muted).middle();
        picture.text_in(place, "No setting has a result.", sorry);
        return picture;
    };
    let named = |times: bool| if times { Named::Seconds } else { Named::Number };
    let across_named = named(part.axes == Axes::ErrorOverTime);
    let up_named = named(part.axes == Axes::TimeOverSize);
    let x = Axis::new(across, across_named, [place.x, place.right()]);
    let y = Axis::new(up, up_named, [place.bottom(), place.y]);
    x.draw_across(&mut picture, place, &across_name(part));
    y.draw_up(&mut picture, place, &up_name(part));

    let mut labels = Labels::new(place.grown(-4.0));
    if let Some(own) = own.filter(|&own| y.holds(own)) {
        own_error(&mut picture, &mut labels, place, y.at(own));
    }
    let at = |point: &Point| {
        let [across, up] = self::coordinates(part.axes, point)?;
        Some(Vec2::new(x.at(across), y.at(up)))
    };
    if part.axes == Axes::ErrorOverTime {
        front(&mut picture, part, &at);
    }
    let looks: Vec<Look> = (0..part.lines.len()).map(Look::of).collect();
    for (line, look) in part.lines.iter().zip(&looks) {
        let places: Vec<Vec2> = line.points.iter().filter_map(at).collect();
        look.curve(&mut picture, &mut labels, &places);
    }
    let bar = |point: &Point, at: Vec2| {
        let quartiles = [point.seconds.lower, point.seconds.upper];
        match part.axes {
            Axes::ErrorOverTime => Some(quartiles.map(|time| Vec2::new(x.at(time), at.y))),
            Axes::TimeOverSize => Some(quartiles.map(|time| Vec2::new(at.x, y.at(time)))),
            Axes::ErrorOverSize => None,
        }
    };
    // A quartile may lie beyond the axes.
    picture.clipped(place, |picture| {
        for (line, look) in part.lines.iter().zip(&looks) {
            for point in &line.points {
                if let Some(place) = at(point) {
                    look.point(picture, &mut labels, place, bar(point, place));
                }
            }
        }
    });
    curve::names(&mut picture, &mut labels, part, &at);
    picture.alt = in_words(&title, part);
    picture
}

fn heading(picture: &mut Picture, title: &str, part: &Part) {
    picture.text((20.0, 28.0), title, Style::Bold.size(16.0));
    let recorded = match part.axes {
        Axes::TimeOverSize => {
            "Bars: quartiles. Exponents are those of the larger half of the sizes.".to_string()
        }
        Axes::ErrorOverSize => format!("Reference: {}.", part.reference.what),
        Axes::ErrorOverTime => format!(
            "Reference: {}. Bars: quartiles. Ringed, on the grey line: the Pareto front; no other setting is as quick and as exact.",
            part.reference.what
        ),
    };
    let lines = crate::picture::wrap(&recorded, Style::Body, SMALL, SIZE.x - 40.0);
    for (row, line) in lines.into_iter().take(2).enumerate() {
        let y = 46.0 + 14.0 * row as f32;
        picture.text((20.0, y), line, Style::Body.size(SMALL).ink(Ink::Muted));
    }
}

fn across_name(part: &Part) -> String {
    match part.axes {
        Axes::ErrorOverTime => "time of a run (median)".into(),
        Axes::ErrorOverSize | Axes::TimeOverSize => part.size.text(Language::English).into(),
    }
}

fn up_name(part: &Part) -> String {
    match part.axes {
        Axes::ErrorOverTime | Axes::ErrorOverSize => {
            format!("rms error of {}", part.quantity.text(Language::English))
        }
        Axes::TimeOverSize => "time of a run (median)".into(),
    }
}

/// Below this line an error is that of the reference.
fn own_error(picture: &mut Picture, labels: &mut Labels, place: Rect, y: f32) {
    let ends = [Vec2::new(place.x, y), Vec2::new(place.right(), y)];
    picture.line(ends[0], ends[1], Ink::Muted.stroke(1.0).dashed());
    labels.avoid(ends[0], ends[1]);
    let set = Style::Body.size(SMALL).ink(Ink::Muted);
    let recorded = "the reference's own error";
    let corner = Vec2::new(place.x + 6.0, y - 16.0);
    labels.put_at(picture, corner, recorded, set, true);
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

fn in_words(title: &str, part: &Part) -> String {
    let lines = part.lines.iter().filter_map(|line| {
        let (first, last) = (line.points.first()?, line.points.last()?);
        let recorded = |point: &Point| {
            let time = strings::seconds(point.seconds.median, Language::English);
            let error = point.errors.map(|errors| strings::error(errors.rms));
            error.map_or(time.clone(), |error| format!("error {error} in {time}"))
        };
        Some(format!(
            "{}: {} {}, {} {}",
            line.name,
            first.setting,
            recorded(first),
            last.setting,
            recorded(last)
        ))
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
        let picture = plot(&findings());
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
