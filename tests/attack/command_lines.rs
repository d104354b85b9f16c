//! Command lines at random, with the files that they name.

use crate::kit::{one_of, pick};
use crate::lessons;
use crate::line::{Case, Line, PAIRS, RANGES, REAL, SIZES, WHOLE};
use lightwalk::algorithms::form_factor;
use lightwalk::numeric::Random;
use lightwalk::panels::Panel;
use lightwalk::study::stress::catalogue;
use std::collections::BTreeMap;

pub fn case(random: &mut Random) -> String {
    let mut line = Line {
        random,
        arguments: Vec::new(),
        files: BTreeMap::new(),
    };
    line.write();
    let Line {
        arguments, files, ..
    } = line;
    serde_json::to_string(&Case { arguments, files }).expect("texts")
}

impl Line<'_> {
    fn write(&mut self) {
        match pick(self.random, 20) {
            0..4 => self.render(),
            4..7 => self.steps(),
            7..9 => self.form_factors(),
            9..11 => self.radiosity(),
            11 | 12 => self.compare(),
            13 | 14 => self.follow(),
            15 | 16 => self.of_a_lesson(),
            17 | 18 => self.check(),
            _ => self.rare(),
        }
    }

    fn render(&mut self) {
        self.word("render");
        self.scene();
        self.method();
        self.always("--size", &SIZES);
        self.rays();
        self.system();
        self.limits();
        self.sometimes("--tolerance", &REAL);
        self.sometimes("--exposure", &REAL);
        self.sometimes("--threads", &["1", "2", "0"]);
        self.rarely("--stats");
        self.rarely("--smooth");
        self.out(&["png", "pfm"]);
    }

    fn recorded(&mut self) {
        self.scene();
        self.method();
        self.always("--size", &SIZES);
        match pick(self.random, 8) {
            0 => self.always("--pixel", &PAIRS),
            1 => self.always("--scan-line", &WHOLE),
            2 => self.always("--polygon", &WHOLE),
            3 => self.always("--iterations", &RANGES),
            4 => self.always("--patch", &WHOLE),
            5 => self.always("--form-factor", &PAIRS),
            _ => {}
        }
        self.rays();
        self.system();
        self.limits();
    }

    fn steps(&mut self) {
        self.word("steps");
        self.recorded();
        self.sometimes("--tolerance", &REAL);
        self.out(&["jsonl", "csv"]);
    }

    fn follow(&mut self) {
        self.word("follow");
        self.recorded();
        let lines = (0..pick(self.random, 6)).map(|_| {
            let kind = one_of(
                self.random,
                &[
                    "Frame",
                    "Ray",
                    "Pixel",
                    "Span",
                    "Vertex",
                    "Iteration",
                    "Shot",
                    "x",
                    "ShadowRay",
                ],
            );
            let field = one_of(
                self.random,
                &["x", "y", "color", "t", "level", "N_dot_L", "residual", "I"],
            );
            let value = one_of(
                self.random,
                &[
                    "0",
                    "1",
                    "0.5",
                    "[0,0,1]",
                    "[1,null,2]",
                    "true",
                    "\"a\"",
                    "1e308",
                ],
            );
            format!("{{\"kind\":\"{kind}\",\"{field}\":{value}}}\n")
        });
        let trace = lines.collect();
        let path = self.file("trace.jsonl", trace);
        self.word("--with");
        self.word(&path);
        self.rarely("--json");
    }

    fn form_factors(&mut self) {
        self.word("form-factors");
        self.scene();
        self.sometimes(
            "--method",
            &form_factor::Method::ALL.map(form_factor::Method::name),
        );
        self.sometimes("--visibility", &["none", "auto"]);
        self.rarely("--max-memory=0");
        self.limits();
        self.out(&["json", "csv", "npy"]);
        if pick(self.random, 6) == 0 {
            let rows = self.rows();
            let path = self.file("mine.csv", rows);
            self.word("--with");
            self.word(&path);
        }
    }

    fn radiosity(&mut self) {
        self.word("radiosity");
        self.scene();
        self.system();
        self.sometimes("--tolerance", &REAL);
        self.rarely("--max-memory=0");
        self.limits();
        self.out(&["json", "csv", "npy"]);
    }

    fn rows(&mut self) -> String {
        let numbers: &[&str] = match pick(self.random, 3) {
            0 => &["0", "0.25", "1", "-1", "nan", "1e308", "x"],
            _ => &["0", "0.25", "1"],
        };
        let columns = 1 + pick(self.random, 20);
        let row = |random: &mut Random| {
            (0..columns)
                .map(|_| one_of(random, numbers))
                .collect::<Vec<_>>()
                .join(",")
                + "\n"
        };
        (0..columns).map(|_| row(self.random)).collect()
    }

    fn compare(&mut self) {
        self.word("compare");
        self.scene();
        match pick(self.random, 4) {
            0 => {
                let rows = self.rows();
                let path = self.file("mine.csv", rows);
                self.always("--matrix", &[&path]);
            }
            1 => {
                let rows = self.rows();
                let path = self.file("mine.csv", rows);
                self.always("--radiosity", &[&path]);
            }
            _ => {
                self.method();
                let (width, height) = (1 + pick(self.random, 9), 1 + pick(self.random, 7));
                let pixels: String = (0..3 * width * height)
                    .map(|_| char::from(pick(self.random, 128) as u8))
                    .collect();
                let path = self.file("mine.ppm", format!("P6 {width} {height} 255\n{pixels}"));
                self.always("--with", &[&path]);
                self.sometimes("--out", &["case/out"]);
                self.rays();
            }
        }
        self.system();
        self.limits();
        self.sometimes("--tolerance", &REAL);
        self.rarely("--json");
    }

    /// `frames`, `handout`, `deck` and `animate`, and `steps` of a lesson.
    fn of_a_lesson(&mut self) {
        let command = one_of(
            self.random,
            &["frames", "frames", "handout", "deck", "animate", "steps"],
        );
        self.word(command);
        let lesson = lessons::make(self.random);
        let path = self.file("lesson.json", lesson);
        self.word(&path);
        if command == "steps" {
            return self.out(&["jsonl", "csv"]);
        }
        self.sometimes("--language", &["en", "id", "de"]);
        match pick(self.random, 3) {
            0 => self.always("--step", &WHOLE),
            1 => self.always("--steps", &RANGES[..4]),
            _ => self.word("--narrated"),
        }
        match command {
            "frames" => {
                self.sometimes("--panel", &Panel::ALL.map(Panel::name));
                self.always("--size", &SIZES);
                self.sometimes("--theme", &["light", "dark", "projector"]);
                self.rarely("--svg");
                self.sometimes("--scale", &["1", "2", "0.5"]);
                self.always("--out", &["case/out"]);
            }
            "animate" => {
                self.sometimes("--panel", &Panel::ALL.map(Panel::name));
                self.always("--size", &["1x1", "40x30", "320x240", "500x400", "0x1"]);
                self.sometimes("--fps", &REAL);
                self.out(&["png", "gif"]);
            }
            "handout" => {
                self.rarely("--answers");
                self.out(&["html"]);
            }
            _ => self.out(&["html"]),
        }
    }

    fn check(&mut self) {
        self.word("check");
        match pick(self.random, 3) {
            0 => {
                let lesson = lessons::make(self.random);
                let path = self.file("lesson.json", lesson);
                self.word(&path);
            }
            _ => self.scene(),
        }
        self.rarely("--json");
    }

    /// What takes longer, or has nothing to go wrong in.
    fn rare(&mut self) {
        match pick(self.random, 4) {
            0 => {
                self.word("needs");
                self.scene();
                self.method();
                self.system();
                self.limits();
                self.rarely("--json");
            }
            1 => {
                self.word("schema");
                let of = one_of(self.random, &["scene", "lesson", "steps", "x"]);
                self.word(of);
            }
            2 => {
                self.word("stress");
                let cases = catalogue();
                let case = &cases[pick(self.random, cases.len())];
                self.word(case.name);
                self.rarely("--json");
            }
            _ => {
                let words = [
                    "render",
                    "--out",
                    "case/x.png",
                    "-1",
                    "--help",
                    "",
                    "--size",
                    "é",
                    "--json",
                    "--version",
                ];
                for _ in 0..=pick(self.random, 4) {
                    let word = one_of(self.random, &words);
                    self.word(word);
                }
            }
        }
    }
}
