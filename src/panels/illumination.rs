//! The illumination model at the current point: its terms as bars, the standard factor f_att·N·L of the current light beside
//! the slide's, and both against the distance of the light.

use super::message::{NO_STEPS, labelled, message};
use super::values::{short, step_as_sentence};
use super::{PanelInput, Properties};
use crate::color::Rgb;
use crate::figure::{Axis, Cell, Plot, Row, Scale};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, symbol};
use crate::record::Value;
use crate::render::falloff::{Falloff, Sample};
use crate::replay::shading::{CurrentLight, CurrentPoint};
use glam::Vec2;

const NOTHING: Message = Message("illumination-nothing");
const NO_LIGHT: Message = Message("illumination-no-light");
const STANDARD: Message = Message("illumination-standard");
const SLIDE: Message = Message("illumination-slide");
const RATIO: Message = Message("illumination-ratio");
const FACTOR: Message = Message("illumination-factor");
const DISTANCE: Message = Message("illumination-distance");

const TEXT: f32 = 12.0;
const ROW: f32 = 18.0;
/// With the current light.
const MOST_ROWS: f32 = 7.0;
/// Part of the height that the rows may take where they are larger than that.
const ROWS: f32 = 0.45;
/// Where their bars can be told apart.
const ROW_WIDTH: f32 = 340.0;
const LARGEST: f32 = 2.0;
const MARGIN: f32 = 8.0;
/// The least size at which the curves can be read.
const PLOT: Vec2 = Vec2::new(180.0, 110.0);
const OF_STANDARD: Ink = Ink::Series(0);
const OF_SLIDE: Ink = Ink::Series(1);

pub const PANEL: Properties = Properties::titled(Message("app-illumination"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let (Some(_), point) = input.run.lit() else {
        return message(NO_LIGHT, input.language, size);
    };
    let Some(point) = point else {
        return message(NOTHING, input.language, size);
    };
    let mut picture = Picture::new(size.x, size.y);
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-MARGIN);
    let rows = rows(point, input.language);
    let scale = (ROWS * whole.height / (MOST_ROWS * ROW)).min(whole.width / ROW_WIDTH);
    let scale = scale.clamp(1.0, LARGEST);
    let row_height = scale * ROW;
    let height = rows.len() as f32 * row_height;
    let beside = whole.width >= 2.0 * PLOT.x + 60.0 && whole.height < height + PLOT.y;
    let (list, plot) = if beside {
        let width = 0.5 * whole.width;
        let left = Rect { width, ..whole };
        (
            left,
            Rect::between(
                (left.right() + MARGIN, whole.y),
                (whole.right(), whole.bottom()),
            ),
        )
    } else {
        let top = Rect {
            height: height.min(whole.height),
            ..whole
        };
        (
            top,
            Rect::between(
                (whole.x, top.bottom() + MARGIN),
                (whole.right(), whole.bottom()),
            ),
        )
    };
    let walk = input.run.walk();
    let kind = walk.kind(walk.position());
    let fitting = (list.height / row_height) as usize;
    for (i, row) in rows.iter().take(fitting).enumerate() {
        let y = list.y + i as f32 * row_height;
        let place = Rect::new(list.x, y, list.width, row_height);
        row.draw(&mut picture, kind, place, scale);
    }
    if plot.width >= PLOT.x && plot.height >= PLOT.y {
        curves(
            &mut picture,
            &input.finished.falloff,
            point,
            input.language,
            plot,
        );
    }
    let recorded: Vec<String> = rows.iter().map(Listed::in_words).collect();
    picture.alt = format!("{} {}.", step_as_sentence(input), recorded.join("; "));
    picture
}

/// A name with its value; a term has a bar, a factor a line that stands for its curve.
struct Listed {
    name: String,
    value: String,
    tag: Tag,
    recorded_by: &'static str,
    ink: Ink,
    /// Share of the longest bar.
    bar: Option<f32>,
}

fn rows(point: &CurrentPoint, language: Language) -> Vec<Listed> {
    let light = point.lights.last();
    let terms = [
        ("I_a", point.ambient, "Ambient", Ink::Series(0)),
        (
            "I_d",
            light.and_then(|light| light.diffuse),
            "Diffuse",
            Ink::Series(1),
        ),
        (
            "I_s",
            light.and_then(|light| light.specular),
            "Specular",
            Ink::Series(2),
        ),
        ("I", point.intensity, "Illuminated", Ink::Muted),
    ];
    let recorded = terms.iter().filter_map(|(_, term, ..)| *term);
    let longest = recorded.map(Rgb::max_channel).fold(1.0, f64::max);
    let mut rows: Vec<Listed> = terms
        .into_iter()
        .map(|(name, term, recorded_by, ink)| Listed {
            name: symbol(name),
            value: term.map_or("–".into(), |term| short(Value::from(term), 3, language)),
            tag: Tag::Field(name),
            recorded_by,
            ink,
            bar: Some(term.map_or(0.0, |term| (term.max_channel() / longest) as f32)),
        })
        .collect();
    let Some((light, (_, n_dot_l))) = light.and_then(|light| Some((light, light.to_light?))) else {
        return rows;
    };
    let standard = standard(light, n_dot_l);
    let strings = |strings: Message| strings.text(language);
    let mut factor = |name: String, value: f64, tag, ink| {
        rows.push(Listed {
            name,
            value: language.short(value, 4),
            tag: Tag::Field(tag),
            recorded_by: "ToLight",
            ink,
            bar: None,
        });
    };
    let formula = format!("{} · N·L", symbol("f_att"));
    let name = labelled(strings(STANDARD), &formula, language);
    factor(name, standard, "f_att", OF_STANDARD);
    let name = labelled(strings(SLIDE), "d · cos φ / √d", language);
    factor(name, light.slide_factor, "slide_factor", OF_SLIDE);
    if standard > 0.0 && light.distance.is_finite() {
        let ratio = light.slide_factor / standard;
        factor(strings(RATIO).into(), ratio, "slide_factor", Ink::Text);
    }
    rows
}

fn standard(light: &CurrentLight, n_dot_l: f64) -> f64 {
    light.attenuation * n_dot_l.max(0.0)
}

impl Listed {
    fn draw(&self, picture: &mut Picture, kind: &str, place: Rect, scale: f32) {
        let here = self.recorded_by == kind;
        let value = Style::Mono
            .size(scale * TEXT)
            .ink(if here { Ink::This } else { Ink::Text });
        let name = Style::Label.size(scale * TEXT).ink(Ink::Muted);
        let gap = scale * 10.0;
        let mark = Some(self.ink).filter(|_| self.bar.is_some());
        let (before, start) = match mark {
            Some(_) => (0.0, scale * 44.0),
            None => {
                let before = scale * 18.0;
                let name = name.width(&self.name).min(place.width - before);
                (before, before + name + gap)
            }
        };
        let y = place.center().y;
        if mark.is_none() {
            let line = [(place.x, y), (place.x + scale * 12.0, y)];
            picture.tagged(self.tag, |picture| {
                picture.line(line[0], line[1], self.ink.stroke(2.5));
            });
        }
        let values = [self.value.as_str(), ""].map(|text| (text.to_string(), value));
        Row::new(self.tag)
            .cell(before, Cell::new(self.name.as_str(), name).swatch(mark))
            .cell(start, Cell::forms(values))
            .draw(picture, place);
        // Bars begin in one line, behind the longest number that there may be.
        let start = place.x + start + value.width("0.000, 0.000, 0.000") + gap;
        if let Some(share) = self.bar.filter(|_| start + 30.0 < place.right()) {
            let half = scale * 5.0;
            let all = Rect::between((start, y - half), (place.right(), y + half));
            picture.tagged(self.tag, |picture| {
                picture.rect(all, Ink::Faint);
                let width = share * all.width;
                picture.rect(Rect { width, ..all }, self.ink);
            });
        }
    }

    fn in_words(&self) -> String {
        format!("{} {}", self.name, self.value)
    }
}

/// Both factors against the distance, at the angle of the current light; none where it is behind the surface or directional.
fn curves(
    picture: &mut Picture,
    falloff: &[Falloff],
    point: &CurrentPoint,
    language: Language,
    place: Rect,
) {
    let Some(light) = point.lights.last() else {
        return;
    };
    let Some((_, n_dot_l)) = light.to_light.filter(|&(_, n_dot_l)| n_dot_l > 0.0) else {
        return;
    };
    let samples = falloff.get(light.light as usize);
    let Some(Falloff(samples)) = samples.filter(|falloff| !falloff.0.is_empty()) else {
        return;
    };
    let factors = |sample: &Sample| [sample.standard, sample.slide].map(|factor| factor * n_dot_l);
    let distances = samples.iter().map(|sample| sample.distance);
    let values = samples.iter().flat_map(factors);
    let plot = Plot::new(
        Axis::new(Scale::decades(distances), DISTANCE.text(language), language),
        Axis::new(Scale::decades(values), FACTOR.text(language), language),
        place,
    );
    plot.draw(picture);
    let cursor = Ink::This.stroke(1.5).dashed();
    plot.upright(picture, light.distance, cursor);
    let mut curve = |factor: usize, here: f64, ink: Ink, field| {
        let points = samples
            .iter()
            .map(|sample| plot.point(sample.distance, factors(sample)[factor]));
        picture.tagged(Tag::Field(field), |picture| {
            picture.polyline(points, ink.stroke(2.5));
            let at = plot.point(light.distance, here);
            picture.circle(at, 4.0, ink.fill().outlined(Ink::Surface.stroke(1.5)));
        });
    };
    curve(0, standard(light, n_dot_l), OF_STANDARD, "f_att");
    curve(1, light.slide_factor, OF_SLIDE, "slide_factor");
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures::{SIZES, fixtures, texts};
    use super::*;
    use crate::render::Method;

    #[test]
    fn nothing_overlaps_or_is_cut_at_any_step_and_size() {
        for mut fixture in [
            fixtures(Method::Flat),
            fixtures(Method::Phong),
            fixtures(Method::RayTracing),
        ] {
            for step in fixture.some_steps(2003) {
                for (size, language) in SIZES.into_iter().zip(Language::ALL.into_iter().cycle()) {
                    let picture = draw(&fixture.seek(step).show_in(language), size);
                    let texts = texts(&picture);
                    for (i, (text, place)) in texts.iter().enumerate() {
                        let inside = picture.bounds().encloses(place);
                        assert!(inside, "step {step}, {size}: “{text}” is cut");
                        for (other, other_place) in &texts[..i] {
                            let common = place.intersection(other_place);
                            let apart = common.width < 0.5 || common.height < 0.5;
                            assert!(apart, "step {step}, {size}: “{text}” covers “{other}”");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn both_factors_stand_side_by_side_with_their_ratio() {
        let mut fixture = Fixture::pyramid(Method::Gouraud);
        fixture.go_to("ToLight", 0);
        let walk = fixture.run.walk();
        let fields = walk.fields(walk.position());
        let recorded = |name| match fields.get(name) {
            Some(Value::Number(value)) => value,
            other => panic!("{name}: {other:?}"),
        };
        let standard = recorded("f_att") * recorded("N_dot_L");
        let slide = recorded("slide_factor");
        let picture = draw(&fixture.input(), Vec2::new(420.0, 400.0));
        for value in [standard, slide, slide / standard] {
            let shown = Language::English.short(value, 4);
            let found = texts(&picture).iter().any(|(text, _)| *text == shown);
            assert!(found, "{shown}");
        }
        let dots = picture.items.iter();
        let dots = dots.filter(|item| matches!(item.shape, crate::picture::Shape::Circle { .. }));
        assert_eq!(dots.count(), 2);
    }
}
