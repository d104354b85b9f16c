//! Where in the text of a document a path is: a scan that reads no values and keeps only the places that are asked for.

use super::document::Problem;
use std::collections::HashMap;
use std::ops::Range;

/// Gives line and column to every problem that has only a path in a text that is JSON: those of its value, or where that is missing, of
/// what should hold it.
pub fn locate(text: &[u8], problems: &mut [Problem]) {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let unplaced = || problems.iter().filter(|problem| problem.line.is_none());
    let places = unplaced().map(|problem| problem.place.as_str());
    let spans = spans(text, places);
    let breaks: Vec<usize> = (0..text.len()).filter(|&at| text[at] == b'\n').collect();
    for problem in problems {
        if problem.line.is_none()
            && let Some(entry) = nearest(&spans, &problem.place)
        {
            let offset = entry.value.start;
            let lines = breaks.partition_point(|&at| at < offset);
            let start = lines.checked_sub(1).map_or(0, |last| breaks[last] + 1);
            problem.line = Some(1 + lines);
            problem.column = Some(1 + offset - start);
        }
    }
}

/// A value in the text of a document, in bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Where it begins with its key; without one, with the value.
    pub start: usize,
    pub value: Range<usize>,
}

/// The value at a path; none where it is missing, or the path is empty.
pub(super) fn entry(text: &[u8], place: &str) -> Option<Entry> {
    spans(text, [place].into_iter()).remove(place)?
}

/// The value at a path, or where that is missing, the one that should hold it.
fn nearest(spans: &HashMap<String, Option<Entry>>, place: &str) -> Option<Entry> {
    let mut all = prefixes(place).collect::<Vec<_>>().into_iter().rev();
    all.find_map(|prefix| spans.get(prefix)?.clone())
}

/// A path and all that it goes through: `objects`, `objects[2]`, `objects[2].material`.
fn prefixes(place: &str) -> impl Iterator<Item = &str> {
    let ends = place.match_indices(['.', '[']).map(|(at, _)| at);
    ends.chain([place.len()])
        .filter(|&end| end > 0)
        .map(|end| &place[..end])
}

/// Where the values at those paths, and at what they go through, are.
fn spans<'a>(text: &[u8], places: impl Iterator<Item = &'a str>) -> HashMap<String, Option<Entry>> {
    let wanted = places.flat_map(prefixes);
    let mut scan = Scan {
        text,
        // A byte order mark is passed over.
        at: if text.starts_with(b"\xef\xbb\xbf") {
            3
        } else {
            0
        },
        path: String::new(),
        wanted: wanted.map(|prefix| (prefix.to_owned(), None)).collect(),
    };
    if !scan.wanted.is_empty() {
        // What cannot be scanned has been refused before with its line.
        let _ = scan.value(0);
    }
    scan.wanted
}

struct Scan<'a> {
    text: &'a [u8],
    at: usize,
    path: String,
    wanted: HashMap<String, Option<Entry>>,
}

impl Scan<'_> {
    fn peek(&mut self) -> Option<u8> {
        let rest = self.text.get(self.at..)?;
        self.at += rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        self.text.get(self.at).copied()
    }

    fn skip(&mut self, byte: u8) -> Option<()> {
        (self.peek()? == byte).then(|| self.at += 1)
    }

    /// Passes over a value whose entry begins there; none where the text ends or is no JSON.
    fn value(&mut self, entry: usize) -> Option<()> {
        let first = self.peek()?;
        let start = self.at;
        match first {
            b'{' => self.members(b'}', |scan, _| {
                let key = scan.string()?;
                scan.skip(b':')?;
                if !scan.path.is_empty() {
                    scan.path.push('.');
                }
                scan.path += &key;
                Some(())
            })?,
            b'[' => self.members(b']', |scan, index| {
                scan.path += &format!("[{index}]");
                Some(())
            })?,
            b'"' => drop(self.string()?),
            _ => {
                let rest = &self.text[start..];
                let ends = |byte: &u8| byte.is_ascii_whitespace() || b",]}".contains(byte);
                self.at += rest.iter().position(ends).unwrap_or(rest.len());
            }
        }
        if let Some(span) = self.wanted.get_mut(&self.path) {
            *span = Some(Entry {
                start: entry,
                value: start..self.at,
            });
        }
        Some(())
    }

    /// Passes over the values between brackets; `head` adds to the path what leads to the next one.
    fn members(&mut self, end: u8, head: impl Fn(&mut Self, usize) -> Option<()>) -> Option<()> {
        self.at += 1;
        let before = self.path.len();
        for index in 0.. {
            if self.peek()? == end {
                break;
            }
            if index > 0 {
                self.skip(b',')?;
                self.peek()?;
            }
            let entry = self.at;
            head(self, index)?;
            self.value(entry)?;
            self.path.truncate(before);
        }
        self.at += 1;
        Some(())
    }

    fn string(&mut self) -> Option<String> {
        self.peek().filter(|&byte| byte == b'"')?;
        let start = self.at;
        let mut escaped = true;
        let length = self.text[start..].iter().position(|&byte| {
            let ends = byte == b'"' && !escaped;
            escaped = byte == b'\\' && !escaped;
            ends
        })?;
        self.at = start + length + 1;
        serde_json::from_slice(&self.text[start..self.at]).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str =
        "{\n  \"a.b\": { \"c\": [1,\n    {\"d\\\"\": \"}\"} ] },\n  \"e\": [], \"f\": -1e5 }";

    #[test]
    fn a_path_leads_to_its_value_or_to_what_should_hold_it() {
        for (place, value) in [
            ("a.b.c[0]", "1"),
            ("a.b.c[1].d\"", "\"}\""),
            ("a.b.c[1].missing", "{\"d\\\"\": \"}\"}"),
            ("e[3].x", "[]"),
            ("f", "-1e5"),
        ] {
            let spans = spans(TEXT.as_bytes(), [place].into_iter());
            let entry = nearest(&spans, place).expect(place);
            assert_eq!(&TEXT[entry.value], value, "{place}");
        }
        for missing in ["", "g.h", "a.b.c[2]"] {
            assert_eq!(entry(TEXT.as_bytes(), missing), None, "{missing}");
        }
        let entry = entry(TEXT.as_bytes(), "e").unwrap();
        assert_eq!(&TEXT[entry.start..entry.value.end], "\"e\": []");
    }

    #[test]
    fn lines_and_columns_count_from_1_and_known_ones_stay() {
        let problem = |place: &str, line| Problem {
            place: place.into(),
            line,
            column: line,
            message: String::new(),
        };
        let mut problems = [problem("a.b.c[1]", None), problem("f", Some(7))];
        locate(TEXT.as_bytes(), &mut problems);
        let places = problems.map(|problem| (problem.line, problem.column));
        assert_eq!(places, [(Some(3), Some(5)), (Some(7), Some(7))]);
    }

    #[test]
    fn a_text_that_breaks_off_is_scanned_as_far_as_it_goes() {
        for end in 0..TEXT.len() {
            let found = entry(&TEXT.as_bytes()[..end], "a.b.c[1].d\"");
            assert_eq!(found.is_some(), end >= TEXT.find('}').unwrap() + 2, "{end}");
        }
    }
}
