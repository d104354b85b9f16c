//! The current polygon with its scan line, and the names that the slide gives to its points.

use super::super::values::{on_swatch, short, swatch};
use super::corners::{Corner, corners, discs, draw_normal};
use crate::figure::{Fit, Labels, disc};
use crate::language::Language;
use crate::picture::{Ink, Picture, Rect, Style, Tag, Text};
use crate::record::Value;
use crate::replay::shading::{ActiveEdge, CurrentRow, State};
use glam::{DVec2, Vec2};

/// Radius of a corner, with its number in it, and of a point on the scan line.
const CORNER: f32 = 8.5;
const POINT: f32 = 6.0;
/// Points a pixel from which on the centres of the pixels are shown.
const CENTRES: f64 = 6.0;

struct Drawing<'a> {
    state: &'a State,
    corners: Vec<Corner>,
    fit: Fit,
    area: Rect,
    labels: Labels,
    language: Language,
}

pub(super) fn draw(picture: &mut Picture, state: &State, language: Language, area: Rect) {
    let corners = corners(state);
    let Some(fit) = fit(&corners, area) else {
        return;
    };
    let mut drawing = Drawing {
        state,
        fit,
        corners,
        area,
        labels: Labels::new(area.grown(-2.0)),
        language,
    };
    picture.clipped(area, |picture| drawing.draw(picture));
}

/// How the polygon stands in `area`; none without corners.
pub(super) fn fit(corners: &[Corner], area: Rect) -> Option<Fit> {
    // Room for the labels of the outermost corners, and for y_1, y_2 at the left and y_4 at the right.
    let side = (0.15 * area.width).clamp(34.0, 76.0);
    let above = (0.09 * area.height).clamp(14.0, 34.0);
    let inner = Rect::new(
        area.x + side,
        area.y + above,
        area.width - 2.0 * side,
        area.height - 2.0 * above,
    );
    let places = corners.iter().map(|corner| corner.place);
    (!corners.is_empty()).then(|| Fit::around(places, inner))
}

impl Drawing<'_> {
    fn draw(&mut self, picture: &mut Picture) {
        let state = self.state;
        let edge = state.edge.and_then(|edge| state.edges.get(edge));
        self.draw_polygon(picture);
        if let Some(row) = state.scan_line {
            self.draw_scan_line(picture, row);
        }
        self.draw_corners(picture);
        // What matters most takes its place first.
        if let Some(row) = state.scan_line {
            self.draw_cuts(picture, row);
            self.label_scan_line(picture, row);
        }
        self.draw_middle(picture);
        if let Some(edge) = edge {
            self.draw_ticks(picture, edge);
        }
        self.label_corners(picture);
    }

    fn draw_polygon(&mut self, picture: &mut Picture) {
        let places: Vec<Vec2> = self
            .corners
            .iter()
            .map(|corner| self.fit.place(corner.place))
            .collect();
        let polygon = self.state.polygon.map_or(0, |polygon| polygon.polygon);
        picture.tagged(Tag::Polygon(polygon as usize), |picture| {
            picture.polygon(places.clone(), Ink::LinkedTint.fill().opacity(0.5));
        });
        for (number, &from) in places.iter().enumerate() {
            let to = places[(number + 1) % places.len()];
            self.labels.avoid(from, to);
            let entered = |edge: &ActiveEdge| edge.edge as usize == number;
            let current = self.state.edge.and_then(|edge| self.state.edges.get(edge));
            let stroke = if current.is_some_and(entered) {
                Ink::Linked.stroke(4.0)
            } else if self
                .state
                .edges
                .iter()
                .any(|edge| entered(edge) && edge.cut.is_some())
            {
                Ink::Text.stroke(2.0)
            } else {
                Ink::Muted.stroke(1.25)
            };
            picture.tagged(Tag::Edge(number), |picture| {
                picture.line(from, to, stroke);
            });
        }
    }

    /// The line y_4 across the panel, the centres of its pixels, and the span.
    fn draw_scan_line(&mut self, picture: &mut Picture, row: CurrentRow) {
        let y = self.fit.y(row.y_4);
        let (left, right) = (self.area.x + 4.0, self.area.right() - 4.0);
        self.labels.avoid(Vec2::new(left, y), Vec2::new(right, y));
        picture.tagged(Tag::ScanLine(row.y as i32), |picture| {
            picture.line((left, y), (right, y), Ink::This.stroke(1.5).dashed());
        });
        let span = self.state.span.as_ref();
        if let Some(span) = span {
            let (from, to) = (self.fit.x(span.x_4), self.fit.x(span.x_5));
            picture.line((from, y), (to, y), Ink::This.stroke(2.5));
        }
        if self.fit.scale >= CENTRES {
            let radius = (0.14 * self.fit.scale).clamp(1.5, 3.5) as f32;
            let places = || self.corners.iter().map(|corner| corner.place.x);
            let low = places().fold(f64::INFINITY, f64::min) - 1.0;
            let high = places().fold(f64::NEG_INFINITY, f64::max) + 1.0;
            let width = f64::from(self.state.prepared.view.width);
            for x in low.clamp(0.0, width) as u32..high.clamp(0.0, width) as u32 {
                let centre = Vec2::new(self.fit.x(f64::from(x) + 0.5), y);
                let inside = span.is_some_and(|span| (span.first..span.end).contains(&x));
                let fill = if inside { Ink::This } else { Ink::Surface };
                let paint = fill.fill().outlined(Ink::This.stroke(1.0));
                picture.tagged(Tag::Pixel { x, y: row.y }, |picture| {
                    picture.circle(centre, radius, paint);
                });
            }
        }
    }

    fn label_scan_line(&mut self, picture: &mut Picture, row: CurrentRow) {
        let at = Vec2::new(self.area.right() - 4.0, self.fit.y(row.y_4));
        let value = Some(row.y_4.into());
        self.label(
            picture,
            (at, 0.0),
            Vec2::new(-0.4, 1.0),
            "y_4",
            value,
            this(),
        );
    }

    /// y_1 and y_2, the heights between which the current edge runs.
    fn draw_ticks(&mut self, picture: &mut Picture, edge: &ActiveEdge) {
        for (name, corner) in [("y_1", edge.upper), ("y_2", edge.lower)] {
            let Some(corner) = self.corners.get(corner as usize) else {
                continue;
            };
            let place = self.fit.place(corner.place);
            let left = self.area.x + 4.0;
            let tick = Vec2::new(left + 12.0, place.y);
            picture.line((left, place.y), tick, Ink::Muted.stroke(1.5));
            let reach = place.x - CORNER;
            if reach > tick.x {
                picture.line(tick, (reach, place.y), Ink::Rule.stroke(1.0).dotted());
            }
            let at = Vec2::new(left, place.y);
            let value = Some(corner.place.y.into());
            self.label(
                picture,
                (at, 1.0),
                Vec2::new(0.5, -1.0),
                name,
                value,
                quiet(),
            );
        }
    }

    fn draw_corners(&mut self, picture: &mut Picture) {
        let places = discs(&self.corners, &self.fit, CORNER);
        for (number, (corner, place)) in self.corners.iter().zip(places).enumerate() {
            let true_place = self.fit.place(corner.place);
            if place != true_place {
                picture.line(true_place, place, Ink::Muted.stroke(1.0));
            }
            let ring = if corner.current {
                Ink::This.stroke(3.0)
            } else {
                Ink::Text.stroke(1.5)
            };
            draw_normal(
                picture,
                &mut self.labels,
                self.state,
                (place, CORNER),
                corner.value,
                ring,
            );
            picture.tagged(corner.tag, |picture| {
                let (at, fill) = ((place, CORNER), swatch(corner.value));
                disc(picture, &mut self.labels, at, fill, ring);
                let set = Style::Bold.size(11.0).ink(on_swatch(corner.value)).middle();
                let inside = Rect::between(place, place).grown(CORNER);
                picture.text_in(inside, (number + 1).to_string(), set);
            });
        }
    }

    /// Where the scan line cuts the edges, and the current pixel, with the values there.
    fn draw_cuts(&mut self, picture: &mut Picture, row: CurrentRow) {
        let state = self.state;
        let names = state.names;
        let mut points = Vec::new();
        if let Some(span) = &state.span {
            let [four, five] = span.ends.map_or([None; 2], |ends| ends.map(Some));
            let calm = state.pixel.is_some();
            points.push((span.x_4, "x_4", names.map(|names| names.left), four, calm));
            points.push((span.x_5, "x_5", names.map(|names| names.right), five, calm));
            if let Some(pixel) = &state.pixel {
                let value = pixel.values.map(|values| values.incremental);
                points.push((
                    pixel.x_p,
                    "x_P",
                    names.map(|names| names.pixel),
                    value,
                    false,
                ));
            }
        } else {
            for (number, edge) in state.edges.iter().enumerate() {
                let Some(cut) = &edge.cut else { continue };
                let value = cut.values.map(|values| values.incremental);
                if state.edge == Some(number) {
                    points.push((cut.x_4, "x_4", names.map(|names| names.left), value, false));
                } else {
                    points.push((cut.x_4, "x", names.map(|names| names.corner), value, true));
                }
            }
        }
        // What the step is about is labelled first, and drawn last.
        points.sort_by_key(|(.., calm)| *calm);
        for (x, _, _, value, calm) in points.iter().rev() {
            let place = self.fit.place(DVec2::new(*x, row.y_4));
            let ring = if *calm { Ink::Text } else { Ink::This };
            let ring = ring.stroke(2.5);
            draw_normal(
                picture,
                &mut self.labels,
                state,
                (place, POINT),
                *value,
                ring,
            );
            let at = (place, POINT);
            disc(picture, &mut self.labels, at, swatch(*value), ring);
        }
        let middle = self.fit.x(self.middle().x);
        for (x, x_name, name, value, calm) in points {
            let place = self.fit.place(DVec2::new(x, row.y_4));
            let aside = if x_name == "x_P" {
                0.2
            } else {
                (place.x - middle).signum()
            };
            let (main, other) = if calm {
                (plain(), quiet())
            } else {
                (this(), this_quiet())
            };
            if let (Some(name), Some(_)) = (name, value) {
                self.label(
                    picture,
                    (place, POINT),
                    Vec2::new(aside, -1.0),
                    name,
                    value,
                    main,
                );
            }
            let toward = Vec2::new(0.5 * aside, 1.0);
            self.label(
                picture,
                (place, POINT),
                toward,
                x_name,
                Some(x.into()),
                other,
            );
        }
    }

    /// Where flat shading lights its polygon: in the middle.
    fn draw_middle(&mut self, picture: &mut Picture) {
        let (Some(point), None, None) = (&self.state.point, &self.state.vertex, &self.state.pixel)
        else {
            return;
        };
        let view = &self.state.prepared.view;
        let camera = view.to_camera(point.position);
        if camera.z < view.near {
            return;
        }
        let place = self.fit.place(view.to_screen(camera));
        let value = point.intensity.map(Value::from);
        let (at, ring) = ((place, CORNER), Ink::This.stroke(3.0));
        disc(picture, &mut self.labels, at, swatch(value), ring);
        let name = if value.is_some() { "I" } else { "P" };
        self.label(
            picture,
            (place, CORNER),
            Vec2::new(1.0, -1.0),
            name,
            value,
            this(),
        );
    }

    /// I_1 and I_2 are the upper and the lower end of the current edge, as on the slide.
    fn label_corners(&mut self, picture: &mut Picture) {
        let Some(names) = self.state.names else {
            return;
        };
        let edge = self.state.edge.and_then(|edge| self.state.edges.get(edge));
        let is = |end: Option<u32>, number: usize| end.map(|end| end as usize) == Some(number);
        let middle = self.middle();
        let places = discs(&self.corners, &self.fit, CORNER);
        let corners = std::mem::take(&mut self.corners);
        for (number, (corner, place)) in corners.iter().zip(places).enumerate() {
            let name = if is(edge.map(|edge| edge.upper), number) {
                names.upper
            } else if is(edge.map(|edge| edge.lower), number) {
                names.lower
            } else {
                names.corner
            };
            let set = if corner.current { this() } else { plain() };
            let away = (corner.place - middle).as_vec2();
            match corner.value {
                Some(_) => self.label(picture, (place, CORNER), away, name, corner.value, set),
                None => {
                    let text = format!("{name} = ?");
                    self.labels.put(picture, (place, CORNER), away, &text, set);
                }
            }
        }
        self.corners = corners;
    }

    /// The mean of the corners.
    fn middle(&self) -> DVec2 {
        let sum: DVec2 = self.corners.iter().map(|corner| corner.place).sum();
        sum / self.corners.len().max(1) as f64
    }

    /// A named value beside a point, or the name alone.
    fn label(
        &mut self,
        picture: &mut Picture,
        point: (Vec2, f32),
        toward: Vec2,
        name: &'static str,
        value: Option<Value>,
        set: Text,
    ) {
        let text = match value {
            Some(Value::Number(_)) => format!(
                "{name} = {}",
                short(value.unwrap_or(0.0.into()), 2, self.language)
            ),
            Some(Value::Vector(_)) => name.to_string(),
            Some(value) => format!("{name} = {}", short(value, 3, self.language)),
            None => name.to_string(),
        };
        picture.tagged(Tag::Field(name), |picture| {
            self.labels.put(picture, point, toward, &text, set);
        });
    }
}

fn plain() -> Text {
    Style::Label.size(13.0)
}

fn quiet() -> Text {
    Style::Label.size(12.0).ink(Ink::Muted)
}

fn this() -> Text {
    Style::LabelBold.size(13.0).ink(Ink::This)
}

fn this_quiet() -> Text {
    Style::Label.size(12.0).ink(Ink::This)
}
