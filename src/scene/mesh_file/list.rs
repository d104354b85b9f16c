//! The lists of an OBJ file that corners of faces refer to: by numbers from 1, or backwards from −1.

/// A list that corners refer to, and whose lines may stand behind them.
pub(super) struct List {
    word: &'static str,
    /// Lines so far.
    pub count: u64,
    /// The largest index so far, and the line of the face that gives it.
    pub furthest: (u64, usize),
    /// References that lead nowhere, where those are dropped.
    pub missing: Found,
}

/// How often something was found, and in which line first.
#[derive(Clone, Copy, Default)]
pub(super) struct Found {
    pub count: u64,
    pub line: usize,
}

impl Found {
    pub fn add(&mut self, line: usize) {
        if self.count == 0 {
            self.line = line;
        }
        self.count += 1;
    }
}

impl List {
    pub fn new(word: &'static str) -> Self {
        List {
            word,
            count: 0,
            furthest: (0, 0),
            missing: Found::default(),
        }
    }

    /// The index, counted from 1, that a word means: from the start, or where negative, back from this line. One that is too large
    /// may still get its line, and is judged in the end. Of a list that a face can do without, an index that leads nowhere is none.
    pub fn resolve(
        &mut self,
        part: &str,
        line: usize,
        is_optional: bool,
    ) -> Result<Option<u32>, String> {
        let index: i64 = part
            .parse()
            .map_err(|_| self.wrong(part, "a whole number"))?;
        if index > 0 {
            let index = index.unsigned_abs();
            if index > self.furthest.0 {
                self.furthest = (index, line);
            }
            return Ok(Some(u32::try_from(index).unwrap_or(u32::MAX)));
        }
        match self.count.checked_sub(index.unsigned_abs()) {
            Some(before) if index != 0 => Ok(Some(before as u32 + 1)),
            _ if is_optional => {
                self.missing.add(line);
                Ok(None)
            }
            None => Err(self.wrong(
                part,
                &format!("at least -{}: so many stand before this line", self.count),
            )),
            Some(_) => Err(self.wrong(
                part,
                "1 for the first or −1 for the last before this line, never 0",
            )),
        }
    }

    fn wrong(&self, part: &str, allowed: &str) -> String {
        format!(
            "found {part:?} as an index of `{}`; allowed is {allowed}",
            self.word
        )
    }
}
