//! A command line in the making: words, options and files, drawn at random.

use crate::kit::{one_of, pick};
use crate::scenes;
use lightwalk::algorithms::form_factor;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::methods::Method;
use lightwalk::numeric::Random;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

#[derive(Deserialize, Serialize)]
pub struct Case {
    /// Without the name of the program.
    pub arguments: Vec<String>,
    /// By their names in the folder `case`.
    pub files: BTreeMap<String, String>,
}

pub struct Line<'a> {
    pub random: &'a mut Random,
    pub arguments: Vec<String>,
    pub files: BTreeMap<String, String>,
}

// Values of options, most of them right.
pub const SIZES: [&str; 9] = [
    "1x1", "2x1", "1x9", "9x7", "16x12", "33x5", "5x300", "40x30", "0x4",
];
pub const WHOLE: [&str; 9] = ["0", "1", "2", "3", "5", "9", "64", "-1", "4294967296"];
pub const REAL: [&str; 9] = [
    "0", "1e-6", "1e-3", "0.5", "0.999", "1", "-1", "1e-300", "nan",
];
pub const PAIRS: [&str; 7] = ["0,0", "1,0", "3,2", "8,6", "0,99", "-1,0", "1"];
pub const RANGES: [&str; 6] = ["0..1", "0..3", "2..5", "5..2", "0..4294967296", "x"];

impl Line<'_> {
    pub fn word(&mut self, word: &str) {
        self.arguments.push(word.to_owned());
    }

    pub fn file(&mut self, name: &str, text: String) -> String {
        self.files.insert(name.to_owned(), text);
        format!("case/{name}")
    }

    pub fn scene(&mut self) {
        let text = match pick(self.random, 4) {
            0 => scenes::original().to_string(),
            _ => scenes::hostile(self.random),
        };
        let path = self.file("scene.json", text);
        self.word(&path);
    }

    /// Half of the time; `--option one-of-these`.
    pub fn sometimes(&mut self, option: &str, values: &[&str]) {
        if pick(self.random, 2) == 0 {
            self.always(option, values);
        }
    }

    pub fn always(&mut self, option: &str, values: &[&str]) {
        let value = one_of(self.random, values);
        self.word(option);
        self.word(value);
    }

    pub fn rarely(&mut self, word: &str) {
        if pick(self.random, 4) == 0 {
            self.word(word);
        }
    }

    pub fn out(&mut self, endings: &[&str]) {
        let ending = match pick(self.random, 16) {
            0 => "txt",
            _ => one_of(self.random, endings),
        };
        self.word("--out");
        self.word(&format!("case/out.{ending}"));
    }

    pub fn method(&mut self) {
        self.always("--method", &Method::ALL.map(Method::name));
    }

    pub fn rays(&mut self) {
        self.sometimes("--depth", &WHOLE);
        self.sometimes("--samples", &["1", "2", "3", "0"]);
    }

    pub fn system(&mut self) {
        if pick(self.random, 3) == 0 {
            self.sometimes("--solver", &Solver::ALL.map(Solver::name));
            self.sometimes(
                "--form-factors",
                &form_factor::Method::ALL.map(form_factor::Method::name),
            );
            self.sometimes("--visibility", &["none", "auto"]);
            self.sometimes("--closure", &["off", "auto"]);
            self.sometimes("--max-iterations", &WHOLE);
        }
    }

    /// Of hostile scenes of many patches the time is not that of a small file.
    pub fn limits(&mut self) {
        self.word("--max-patches");
        self.word("60");
        self.rarely("--max-triangles=20000");
    }
}
