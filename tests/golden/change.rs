//! What has changed between two display lists, in words.

/// At most so many sentences about a panel.
const MOST: usize = 8;

#[derive(Clone, Copy, PartialEq)]
struct Line<'a> {
    kind: &'a str,
    place: &'a str,
    look: &'a str,
    content: &'a str,
}

impl<'a> Line<'a> {
    fn read(line: &'a str) -> Self {
        let mut columns = line.splitn(4, '\t');
        let mut column = || columns.next().unwrap_or_default();
        Line {
            kind: column(),
            place: column(),
            look: column(),
            content: column(),
        }
    }

    fn name(&self) -> String {
        let Line {
            kind,
            look,
            content,
            ..
        } = self;
        match *kind {
            "text" => format!("text {content}"),
            "picture" => "the picture".to_owned(),
            _ => format!("{kind} ({look})"),
        }
    }
}

/// Sentences about how `new` differs from `old`; none where they are equal.
pub fn changes(old: &[String], new: &[String]) -> Vec<String> {
    if old == new {
        return Vec::new();
    }
    let mut gone: Vec<Line> = old.iter().map(|line| Line::read(line)).collect();
    let mut come: Vec<Line> = new.iter().map(|line| Line::read(line)).collect();
    pair_off(&mut gone, &mut come, |a, b| a == b);
    if gone.is_empty() && come.is_empty() {
        return vec!["items lie over each other in another order".to_owned()];
    }

    let mut sentences = Vec::new();
    for (old, new) in pair_off(&mut gone, &mut come, |a, b| {
        (a.kind, a.look, a.content) == (b.kind, b.look, b.content)
    }) {
        let name = new.name();
        sentences.push(format!(
            "{name} moved from ({}) to ({})",
            old.place, new.place
        ));
    }
    for (old, new) in pair_off(&mut gone, &mut come, |a, b| {
        (a.kind, a.place, a.content) == (b.kind, b.place, b.content)
    }) {
        let item = [new.kind, new.content].join(" ");
        let item = item.trim_end();
        sentences.push(format!(
            "{item} at ({}) changed from {} to {}",
            new.place, old.look, new.look
        ));
    }
    for (old, new) in pair_off(&mut gone, &mut come, |a, b| {
        (a.kind, a.place, a.look) == (b.kind, b.place, b.look)
    }) {
        sentences.push(format!(
            "{} at ({}) reads {} instead of {}",
            new.kind, new.place, new.content, old.content
        ));
    }
    for (old, new) in pair_off(&mut gone, &mut come, |a, b| {
        a.kind == b.kind && a.content == b.content && !a.content.is_empty()
    }) {
        sentences.push(format!(
            "{} moved from ({}) to ({}) and changed from {} to {}",
            new.name(),
            old.place,
            new.place,
            old.look,
            new.look
        ));
    }
    sentences.extend(
        gone.iter()
            .map(|line| format!("{} removed at ({})", line.name(), line.place)),
    );
    sentences.extend(
        come.iter()
            .map(|line| format!("{} added at ({})", line.name(), line.place)),
    );
    if sentences.len() > MOST {
        let more = sentences.len() - MOST;
        sentences.truncate(MOST);
        sentences.push(format!("and {more} changes more"));
    }
    sentences
}

/// Takes pairs that are `alike` out of both lists, each item at most once.
fn pair_off<'a>(
    gone: &mut Vec<Line<'a>>,
    come: &mut Vec<Line<'a>>,
    alike: impl Fn(&Line, &Line) -> bool,
) -> Vec<(Line<'a>, Line<'a>)> {
    let mut pairs = Vec::new();
    gone.retain(|old| match come.iter().position(|new| alike(old, new)) {
        Some(at) => {
            pairs.push((*old, come.remove(at)));
            false
        }
        None => true,
    });
    pairs
}

#[cfg(test)]
mod tests {
    use super::changes;
    use crate::display_list::lines;
    use lightwalk::color::Rgb;
    use lightwalk::picture::{Image, Ink, Picture, Rect, Style, Tag};

    /// A picture with a label at `y`, and whatever else `draw` adds.
    fn picture(y: f32, draw: impl FnOnce(&mut Picture)) -> Vec<String> {
        let mut picture = Picture::new(100.0, 80.0);
        picture.rect(Rect::new(0.0, 0.0, 9.0, 9.0), Ink::Faint);
        picture.text((12.3, y), "I_4", Style::Label.size(12.0));
        draw(&mut picture);
        lines(&picture)
    }

    #[test]
    fn a_label_that_moves_is_named_with_both_places() {
        assert_eq!(
            changes(&picture(40.0, |_| {}), &picture(44.0, |_| {})),
            ["text \"I_4\" moved from (12.3,40) to (12.3,44)"]
        );
    }

    #[test]
    fn a_line_added_or_removed_is_named() {
        let with = picture(40.0, |picture| {
            picture.line((0.0, 0.0), (5.0, 5.0), Ink::This.stroke(1.5).dashed());
        });
        let without = picture(40.0, |_| {});
        let name = "line (This 1.5 dashed)";
        assert_eq!(
            changes(&without, &with),
            [format!("{name} added at (0,0 5,5)")]
        );
        assert_eq!(
            changes(&with, &without),
            [format!("{name} removed at (0,0 5,5)")]
        );
    }

    #[test]
    fn a_changed_colour_text_tag_or_pixel_is_named() {
        let circle = |red: f64| {
            picture(40.0, |picture| {
                let ink = Ink::Rgb(Rgb::from([red, 0.0, 0.0]));
                picture.circle((5.0, 5.0), 2.0, ink);
            })
        };
        assert_eq!(
            changes(&circle(0.0), &circle(1.0)),
            ["circle at (5,5 radius 2) changed from #000000 to #ff0000"]
        );

        let text = |text: &str, step: usize| {
            picture(40.0, |picture| {
                picture.tagged(Tag::Step(step), |picture| {
                    picture.text((1.0, 2.0), text, Style::Body.size(12.0));
                });
            })
        };
        assert_eq!(
            changes(&text("a", 1), &text("b", 1)),
            ["text at (1,2) reads \"b\" instead of \"a\""]
        );
        assert_eq!(
            changes(&text("a", 1), &text("a", 2)),
            ["text \"a\" at (1,2) changed from Body 12 Text #Step(1) to Body 12 Text #Step(2)"]
        );

        let pixel = |byte: u8| {
            picture(40.0, |picture| {
                picture.image(
                    Rect::new(0.0, 0.0, 1.0, 1.0),
                    Image::new(1, 1, [byte, 0, 0]),
                );
            })
        };
        assert_eq!(changes(&pixel(0), &pixel(1)).len(), 1);
    }

    #[test]
    fn one_point_of_a_long_curve_and_another_order_are_seen() {
        let curve = |middle: f32| {
            picture(40.0, |picture| {
                let points = (0..100).map(|i| (i as f32, if i == 50 { middle } else { 0.0 }));
                picture.polyline(points, Ink::Text.stroke(1.0));
                picture.line((0.0, 9.0), (9.0, 9.0), Ink::Text.stroke(2.0));
            })
        };
        assert_eq!(changes(&curve(0.0), &curve(0.01)).len(), 1);

        let mut turned = curve(0.0);
        turned.swap(1, 2);
        assert_eq!(
            changes(&curve(0.0), &turned),
            ["items lie over each other in another order"]
        );
    }

    #[test]
    fn less_than_a_pixel_shows_is_no_change() {
        assert!(changes(&picture(40.0, |_| {}), &picture(40.001, |_| {})).is_empty());
    }
}
