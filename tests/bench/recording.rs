//! The cost of recording and of seeking: nanoseconds an event, and random seeks among ten million events.

mod race;

use lightwalk::color::Rgb;
use lightwalk::numeric::Random;
use lightwalk::record::{Event, Fields, Line, Listing, Recorder, Recording, RecordingLimit};
use lightwalk::replay::{Canvas, Fold, Query, Replay, Timeline, query};
use lightwalk::study::timing::Timing;
use lightwalk::vocabulary::{Declared, Kind};
use race::{race, ratio};
use std::hint::black_box;
use std::time::{Duration, Instant};

const EVENTS: usize = 1_000_000;
const ROUNDS: usize = 20;

/// An event of `8 * WORDS` bytes.
#[derive(Clone, Copy)]
struct Words<const WORDS: usize>([u64; WORDS]);

/// `EVENTS` events, in scopes of a hundred.
fn run<const WORDS: usize>(recorder: &mut impl Recorder<Words<WORDS>>) {
    let word = |i: usize| Words([i as u64; WORDS]);
    for scope in 0..EVENTS / 100 {
        recorder.enter(|| word(scope));
        for i in 0..98 {
            recorder.step(|| word(scope + i));
        }
        recorder.leave(|| word(scope));
    }
}

/// Keeps the events alone, in one vector.
struct Plain<E>(Vec<E>);

impl<E> Recorder<E> for Plain<E> {
    fn step(&mut self, event: impl FnOnce() -> E) {
        self.0.push(event());
    }
    fn enter(&mut self, event: impl FnOnce() -> E) {
        self.0.push(event());
    }
    fn leave(&mut self, event: impl FnOnce() -> E) {
        self.0.push(event());
    }
}

/// Nanoseconds an event, in the memory of the recording before, against a vector that keeps its memory too.
fn record<const WORDS: usize>() {
    let mut plain = Plain(Vec::with_capacity(EVENTS));
    let seconds = race(
        &mut [
            &mut || {
                let mut recording = Recording::new(RecordingLimit::default());
                run::<WORDS>(&mut recording);
                black_box(recording.len());
            },
            &mut || {
                plain.0.clear();
                run::<WORDS>(&mut plain);
                black_box(plain.0.len());
            },
        ],
        ROUNDS,
    );
    let ratio = ratio(&seconds[0], &seconds[1]);
    let [recorded, plain] = [0, 1].map(|i| {
        let Timing { median, .. } = Timing::of(seconds[i].clone());
        1e9 * median / EVENTS as f64
    });
    println!(
        "an event of {} bytes: {recorded:.2} ns, {plain:.2} ns in a plain vector, ratio {:.2} (quartiles {:.2} to {:.2})",
        size_of::<Words<WORDS>>(),
        ratio.median,
        ratio.lower,
        ratio.upper
    );
}

/// The events of a scan-line method, reduced to what they do to the picture.
#[derive(Clone, Copy)]
enum Drawn {
    Span {
        y: u16,
    },
    Interpolated {
        t: f64,
    },
    DepthTested {
        depth: f64,
    },
    Pixel {
        x: u16,
        y: u16,
        color: [f32; 3],
        depth: f64,
    },
}

const _: () = assert!(size_of::<Drawn>() <= 32);

impl Event for Drawn {
    fn kind(&self) -> &'static str {
        match self {
            Drawn::Span { .. } => "Span",
            Drawn::Interpolated { .. } => "Interpolated",
            Drawn::DepthTested { .. } => "DepthTested",
            Drawn::Pixel { .. } => "Pixel",
        }
    }
    fn line(&self) -> Line {
        static LISTING: Listing = Listing {
            name: "spans",
            lines: &[("draw", "draw")],
        };
        Line {
            listing: &LISTING,
            number: 0,
        }
    }
    fn fields(&self, fields: &mut Fields) {
        match *self {
            Drawn::Span { y } => fields.push("y", y),
            Drawn::Interpolated { t } => fields.push("t", t),
            Drawn::DepthTested { depth } => fields.push("depth", depth),
            Drawn::Pixel { x, y, depth, .. } => {
                fields.push("x", x).push("y", y).push("depth", depth)
            }
        };
    }
}

impl Declared for Drawn {
    fn declaration(&self, fields: Option<&mut Fields>) -> (&'static Kind, &'static str) {
        const fn kind(name: &'static str) -> Kind {
            Kind {
                name,
                quantities: &[],
                labels: &[],
                scope: None,
                numbers: &[],
                entries: &[],
            }
        }
        static KINDS: [Kind; 4] = [
            kind("Span"),
            kind("Interpolated"),
            kind("DepthTested"),
            kind("Pixel"),
        ];
        if let Some(fields) = fields {
            self.fields(fields);
        }
        let kind = match self {
            Drawn::Span { .. } => &KINDS[0],
            Drawn::Interpolated { .. } => &KINDS[1],
            Drawn::DepthTested { .. } => &KINDS[2],
            Drawn::Pixel { .. } => &KINDS[3],
        };
        (kind, "draw")
    }
}

#[derive(Clone, Copy)]
struct Pixel {
    color: Rgb,
    depth: f64,
    /// The step that wrote it.
    writer: u32,
}

/// What the state of a scan-line method keeps of the picture.
#[derive(Clone)]
struct Picture(Canvas<Pixel>);

impl Fold<Drawn> for Picture {
    fn apply(&mut self, step: usize, event: &Drawn) {
        if let Drawn::Pixel { x, y, color, depth } = *event {
            let pixel = Pixel {
                color: Rgb::from(color.map(f64::from)),
                depth,
                writer: step as u32,
            };
            self.0.set(x.into(), y.into(), pixel);
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        self.0.bytes_beyond(&before.0)
    }
}

/// Polygons of 24×16 pixels at random places, four events a pixel, until there are `count` events.
fn draw(recorder: &mut impl Recorder<Drawn>, count: usize, random: &mut Random) {
    const WIDTH: usize = 24;
    const HEIGHT: usize = 16;
    for _ in 0..count.div_ceil(HEIGHT * (2 + 4 * WIDTH)) {
        let left = below(640 - WIDTH, random);
        let top = below(480 - HEIGHT, random);
        for y in top..top + HEIGHT {
            let y = y as u16;
            recorder.enter(|| Drawn::Span { y });
            for x in left..left + WIDTH {
                let t = x as f64 / 640.0;
                let depth = t + 1.0;
                recorder.step(|| Drawn::Interpolated { t });
                recorder.step(|| Drawn::Interpolated { t: depth });
                recorder.step(|| Drawn::DepthTested { depth });
                recorder.step(|| Drawn::Pixel {
                    x: x as u16,
                    y,
                    color: [t as f32, 0.5, 0.25],
                    depth,
                });
            }
            recorder.leave(|| Drawn::Span { y });
        }
    }
}

fn below(bound: usize, random: &mut Random) -> usize {
    (random.bits() % bound as u64) as usize
}

fn seek() {
    let random = &mut Random(2024);
    let mut recording = Recording::new(RecordingLimit::default());
    draw(&mut recording, 10_000_000, random);
    let empty = Pixel {
        color: Rgb::BLACK,
        depth: f64::INFINITY,
        writer: u32::MAX,
    };
    let initial = Picture(Canvas::new(640, 480, empty));
    let start = Instant::now();
    let mut replay = Replay::new(Timeline::new(recording, initial));
    let folded = start.elapsed();
    let len = replay.timeline().len();
    let bytes = size_of::<Drawn>();
    println!("{len} events of {bytes} bytes: folded once in {folded:.0?}");

    let mut times: Vec<Duration> = (0..5000)
        .map(|_| {
            let step = below(len, random);
            let start = Instant::now();
            replay.seek(step);
            black_box(replay.state());
            start.elapsed()
        })
        .collect();
    times.sort();
    let within = times.partition_point(|&time| time < Duration::from_millis(1));
    println!(
        "random seek: median {:.0?}, 99th percentile {:.0?}, longest {:.0?}, {:.2} % under 1 ms (goal 99 %)",
        times[times.len() / 2],
        times[times.len() * 99 / 100],
        times[times.len() - 1],
        100.0 * within as f64 / times.len() as f64
    );

    for _ in 0..1000 {
        let place = below(640 * 480, random);
        let pixel = replay
            .state()
            .0
            .iter()
            .nth(place)
            .expect("it lies in the picture");
        if pixel.writer == u32::MAX {
            continue;
        }
        match *replay.timeline().event(pixel.writer as usize) {
            Drawn::Pixel { color, depth, .. } => {
                assert_eq!(pixel.color, Rgb::from(color.map(f64::from)));
                assert_eq!(pixel.depth, depth);
            }
            _ => panic!("only a pixel's step writes it"),
        }
    }

    for text in ["Vertex", "Pixel y=-1", "t=-1"] {
        let query: Query = text.parse().expect("a query");
        let start = Instant::now();
        assert_eq!(query::matches(&replay, &query, 0..len).count(), 0);
        let rate = len as f64 / start.elapsed().as_secs_f64() / 1e6;
        println!("search for `{text}`: {rate:.0} million events a second");
    }
}

fn main() {
    record::<4>();
    record::<8>();
    seek();
}
