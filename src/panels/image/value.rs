//! The pixel under the pointer, in numbers.

use super::super::horizon::UNKNOWN;
use super::super::message::labelled;
use super::super::strings::focus;
use super::layers;
use super::light::Light;
use super::so_far::shows_finished;
use crate::algorithms::focus::Focus;
use crate::color::Rgb;
use crate::language::Message;
use crate::panels::PanelInput;

const VALUE: Message = Message("image-value");
const NOT_DRAWN: Message = Message("image-not-drawn");

/// A pixel's place and its colour: linear, in 8 bits as it is shown, and these in hexadecimal.
pub fn value(input: &PanelInput, x: u32, y: u32) -> String {
    let language = input.language;
    let pixel = focus(Focus::Pixel { x, y }, language);
    let frame = &input.finished.picture;
    if x >= frame.width || !frame.rows.contains(&y) {
        return pixel;
    }
    let at = frame.index(x, y);
    if input.hidden_pixels(frame).is_some_and(|hidden| hidden[at]) {
        return format!("{pixel}: {UNKNOWN}");
    }
    if let Some(said) = layers::said(input, x, y) {
        return labelled(&pixel, &said, language);
    }
    let light = Light::of(input);
    let exposure = light.as_ref().map_or(1.0, |light| light.exposure);
    let color = match light {
        Some(light) => light.at(x, y),
        None => color(input, x, y),
    };
    let Some(color) = color else {
        return NOT_DRAWN.format(language, &[("pixel", &pixel)]);
    };
    let linear = color.channels().map(|channel| language.short(channel, 4));
    let bytes = (color * exposure).to_srgb8();
    let [r, g, b] = bytes;
    let arguments = [
        ("pixel", &*pixel),
        ("linear", &language.list(linear)),
        ("bytes", &language.list(bytes.map(|byte| byte.to_string()))),
        ("hex", &format!("#{r:02x}{g:02x}{b:02x}")),
    ];
    VALUE.format(language, &arguments)
}

/// Of a pixel of the finished picture, as far as it is drawn.
fn color(input: &PanelInput, x: u32, y: u32) -> Option<Rgb> {
    let picture = &input.finished.picture;
    let finished = picture.color[picture.index(x, y)];
    let Some(canvas) = input.run.canvas() else {
        return Some(finished);
    };
    let drawn = canvas.get(x as usize, y as usize);
    let drawn = drawn.filter(|dot| dot.step.is_some());
    drawn
        .map(|dot| dot.color)
        .or(shows_finished(input).then_some(finished))
}

#[cfg(test)]
mod tests {
    use super::super::super::fixture::Fixture;
    use super::*;
    use crate::language::Language;
    use crate::methods::Method;
    use crate::record::Value;

    #[test]
    fn a_drawn_pixel_has_the_colour_of_its_event_and_the_next_has_none_yet() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        fixture.go_to("PixelColored", 3);
        let walk = fixture.walk();
        let fields = walk.fields(walk.position());
        let whole = |name| match fields.get(name) {
            Some(Value::Integer(value)) => value as u32,
            other => panic!("{name} is {other:?}"),
        };
        let (x, y) = (whole("x"), whole("y"));
        let dot = fixture.finished.picture.pixel(x, y);
        let said = value(&fixture.input(), x, y);
        let [r, g, b] = dot.to_srgb8();
        assert!(said.contains(&Language::English.short(dot.r, 4)), "{said}");
        assert!(said.contains(&format!("{r}, {g}, {b}")), "{said}");
        assert!(said.ends_with(&format!("#{r:02x}{g:02x}{b:02x}")), "{said}");
        assert!(said.contains(&format!("({x}, {y})")), "{said}");
        let next = value(&fixture.input(), x + 1, y);
        assert!(!next.contains('#') && next.contains("not drawn"), "{next}");
    }
}
