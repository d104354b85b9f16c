//! The picture so far: what is drawn on the canvas, and the finished picture as a ghost where nothing is drawn yet.

use crate::algorithms::focus::Focus;
use crate::color::Rgb;
use crate::panels::PanelInput;
use crate::panels::horizon::hatch;
use crate::picture::Image;
use crate::replay::shading::Dot;
use crate::replay::{Canvas, Run};

/// How far what is not drawn yet stands out from the background, of 255.
const GHOST: i32 = 60;

/// As it was shown, with what it was made of: most of it is the same at the next step.
pub struct SoFar {
    canvas: Canvas<Dot>,
    around: bool,
    bytes: Vec<u8>,
    drawn: usize,
}

/// The image, hatched where it is hidden; and how many pixels are drawn.
pub(super) fn image(
    input: &PanelInput,
    canvas: &Canvas<Dot>,
    hidden: Option<&[bool]>,
) -> (Image, usize) {
    let under = Under::of(input, hidden);
    let (width, height) = (canvas.width() as u32, canvas.height() as u32);
    // What is hidden changes with the step.
    let Some(reused) = input.reused.filter(|_| hidden.is_none()) else {
        let shown = SoFar::whole(canvas, &under);
        return (Image::new(width, height, shown.bytes), shown.drawn);
    };
    let mut latest = reused.so_far.borrow_mut();
    let known = latest.take().filter(|known| {
        let before = &known.canvas;
        let sizes = [before, canvas].map(|canvas| (canvas.width(), canvas.height()));
        known.around == under.around && sizes[0] == sizes[1]
    });
    let shown = match known {
        Some(known) => known.brought_up_to(canvas, &under),
        None => SoFar::whole(canvas, &under),
    };
    let shown = latest.insert(shown);
    (Image::new(width, height, &*shown.bytes), shown.drawn)
}

impl SoFar {
    fn whole(canvas: &Canvas<Dot>, under: &Under) -> Self {
        let mut bytes = vec![0; 3 * canvas.width() * canvas.height()];
        let (pixels, _) = bytes.as_chunks_mut();
        let mut all = pixels.iter_mut().enumerate();
        let mut drawn = 0;
        // `for_each`, not `for`: the canvas hands out its tiles' rows much faster.
        canvas.iter().for_each(|dot| {
            if let Some((at, pixel)) = all.next() {
                drawn += usize::from(dot.step.is_some());
                *pixel = under.color(dot, at, canvas.width());
            }
        });
        SoFar {
            canvas: canvas.clone(),
            around: under.around,
            bytes,
            drawn,
        }
    }

    /// The same of a canvas of the same run at another step.
    fn brought_up_to(mut self, canvas: &Canvas<Dot>, under: &Under) -> Self {
        let (pixels, _) = self.bytes.as_chunks_mut();
        for [columns, rows] in canvas.parts_beyond(Some(&self.canvas)) {
            for y in rows {
                for x in columns.clone() {
                    let dots = [canvas.get(x, y), self.canvas.get(x, y)];
                    let [Some(dot), Some(before)] = dots else {
                        continue;
                    };
                    self.drawn += usize::from(dot.step.is_some());
                    self.drawn -= usize::from(before.step.is_some());
                    let at = y * canvas.width() + x;
                    pixels[at] = under.color(&dot, at, canvas.width());
                }
            }
        }
        self.canvas = canvas.clone();
        self
    }
}

/// What is seen where nothing is drawn.
struct Under<'a> {
    finished: &'a [Rgb],
    hidden: Option<&'a [bool]>,
    background: Rgb,
    ground: [u8; 3],
    /// Whether the finished picture is seen as it is, not as a ghost.
    around: bool,
}

impl<'a> Under<'a> {
    fn of(input: &PanelInput<'a>, hidden: Option<&'a [bool]>) -> Self {
        let background = input.run.prepared().scene.background;
        Under {
            finished: &input.finished.picture.color,
            hidden,
            background,
            ground: background.to_srgb8(),
            around: shows_finished(input),
        }
    }

    fn color(&self, dot: &Dot, at: usize, width: usize) -> [u8; 3] {
        // A finished picture that is smaller than the canvas leaves the rest black.
        let Some(&finished) = self.finished.get(at) else {
            return [0; 3];
        };
        if dot.step.is_some() {
            dot.color.to_srgb8()
        } else if self.hidden.is_some_and(|hidden| hidden[at]) {
            hatch(at % width, at / width)
        } else if self.around {
            finished.to_srgb8()
        } else if finished == self.background {
            self.ground
        } else {
            ghost(finished.to_srgb8(), self.ground)
        }
    }
}

/// Whether the finished picture is seen where the run has drawn nothing.
pub(super) fn shows_finished(input: &PanelInput) -> bool {
    let follows_rays = matches!(input.run, Run::Rays(..));
    follows_rays && matches!(input.focus, Focus::Pixel { .. }) || is_outermost(input)
}

/// Whether the step opens or closes the frame: a run begins and ends with the picture that it is about.
fn is_outermost(input: &PanelInput) -> bool {
    let walk = input.run.walk();
    !walk.is_empty() && walk.outline().depth(walk.position()) == 0
}

/// A colour of the finished picture, faint: nearer to the background than to itself.
fn ghost(finished: [u8; 3], background: [u8; 3]) -> [u8; 3] {
    std::array::from_fn(|channel| {
        let (to, from) = (i32::from(finished[channel]), i32::from(background[channel]));
        (from + (to - from) * GHOST / 255) as u8
    })
}
