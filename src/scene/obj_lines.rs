//! The lines of an OBJ file, read and judged one by one.

use super::validate::LARGEST;
use glam::{DVec2, DVec3};
use std::str::SplitAsciiWhitespace;

/// What the lines of an OBJ file say, each known to be right.
pub(super) struct Lines {
    pub positions: Vec<DVec3>,
    /// The first is (0, 0), for corners without one.
    pub uvs: Vec<DVec2>,
    /// Face `f` has the corners `starts[f]..starts[f + 1]`.
    pub starts: Vec<u32>,
    /// Indices into `positions` and `uvs`.
    pub corners: Vec<[u32; 2]>,
    pub triangles: u64,
    /// Of `v`, `vt` and `vn`, in the order in which a corner names them.
    referred: [Referred; 3],
}

/// What faces refer to: how many there are so far, and the furthest reference, which may come before them, with its line.
struct Referred {
    word: &'static str,
    count: u64,
    furthest: u64,
    line: usize,
}

impl Lines {
    /// Errors: the first line that is wrong, no faces at all, or more than `max_triangles`, as a sentence.
    pub fn read(bytes: &[u8], max_triangles: u64) -> Result<Lines, String> {
        let mut lines = Lines {
            positions: Vec::new(),
            uvs: vec![DVec2::ZERO],
            starts: vec![0],
            corners: Vec::new(),
            triangles: 0,
            referred: ["v", "vt", "vn"].map(|word| Referred {
                word,
                count: 0,
                furthest: 0,
                line: 0,
            }),
        };
        for (index, line) in bytes.split(|&byte| byte == b'\n').enumerate() {
            lines
                .take_line(line, index + 1, max_triangles)
                .map_err(|problem| format!("line {}: {problem}", index + 1))?;
        }
        for referred in &lines.referred {
            if referred.furthest > referred.count {
                return Err(format!(
                    "line {}: a face refers to `{word}` number {}; the file has {} lines `{word}`",
                    referred.line,
                    referred.furthest,
                    referred.count,
                    word = referred.word
                ));
            }
        }
        match lines.triangles {
            0 => {
                Err("found no faces (lines that start with `f`); a mesh needs at least one".into())
            }
            n if n > max_triangles => Err(format!(
                "found {n} triangles; at most {max_triangles} are allowed (--max-triangles)"
            )),
            _ => Ok(lines),
        }
    }

    fn take_line(&mut self, line: &[u8], number: usize, max_triangles: u64) -> Result<(), String> {
        let end = line.iter().position(|&b| b == b'#').unwrap_or(line.len());
        let line = line[..end].trim_ascii();
        let kind = line.split(u8::is_ascii_whitespace).next();
        if !matches!(kind, Some(b"v" | b"vt" | b"vn" | b"f")) {
            return Ok(());
        }
        let line = std::str::from_utf8(line).map_err(|_| "found bytes that are not text")?;
        if line.ends_with('\\') {
            return Err(
                "a line that goes on in the next (`\\`) is not supported; join the two".into(),
            );
        }
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => self.take_position(words),
            Some("vt") => {
                // A third coordinate, for solid textures, has no use here.
                let uv = numbers(&mut words, "`vt` takes two numbers")?;
                self.referred[1].count += 1;
                self.uvs.push(DVec2::from_array(uv));
                Ok(())
            }
            Some("vn") => {
                numbers::<3>(&mut words, "`vn` takes three numbers")?;
                self.referred[2].count += 1;
                Ok(())
            }
            _ => self.take_face(words, number, max_triangles),
        }
    }

    fn take_position(&mut self, mut words: SplitAsciiWhitespace) -> Result<(), String> {
        let allowed = "`v` takes x y z, then nothing, a weight, or a colour r g b";
        let mut position = DVec3::from_array(numbers(&mut words, allowed)?);
        match words.clone().take(4).count() {
            0 | 3 => {}
            1 => {
                let [weight] = numbers(&mut words, allowed)?;
                position /= weight;
                if !position.to_array().iter().all(|x| x.abs() <= LARGEST) {
                    return Err(format!(
                        "found the weight {weight:?}, which takes the point too far away"
                    ));
                }
            }
            n => {
                return Err(format!(
                    "found {}{} numbers; {allowed}",
                    3 + n,
                    if n == 4 { " or more" } else { "" }
                ));
            }
        }
        self.referred[0].count += 1;
        self.positions.push(position);
        Ok(())
    }

    fn take_face(
        &mut self,
        words: SplitAsciiWhitespace,
        line: usize,
        max_triangles: u64,
    ) -> Result<(), String> {
        let mut corners = 0;
        // Once there are too many triangles they are only counted.
        let kept = self.triangles <= max_triangles;
        for word in words {
            corners += 1;
            let mut indices = [None; 3];
            for (kind, part) in word.split('/').enumerate() {
                let Some(referred) = self.referred.get_mut(kind) else {
                    return Err(format!(
                        "found the corner {word:?}; a corner is v, v/vt, v//vn or v/vt/vn"
                    ));
                };
                if !part.is_empty() {
                    indices[kind] = Some(referred.resolve(part, line)?);
                }
            }
            let [Some(position), uv, _] = indices else {
                return Err(format!(
                    "found the corner {word:?} without a vertex; a corner is v, v/vt, v//vn or v/vt/vn"
                ));
            };
            if kept {
                self.corners.push([position - 1, uv.unwrap_or(0)]);
            }
        }
        if kept {
            self.starts.push(self.corners.len() as u32);
        }
        if corners < 3 {
            return Err(format!(
                "found a face of {corners} corners; a face has three or more"
            ));
        }
        self.triangles += corners - 2;
        Ok(())
    }
}

impl Referred {
    /// The index, counted from 1, that a word in line `line` means: from the start, or where negative, back from here.
    /// One that is too large is kept as the furthest, and refused in the end.
    fn resolve(&mut self, part: &str, line: usize) -> Result<u32, String> {
        let wrong = |allowed: &str| {
            format!(
                "found {part:?} as an index of `{}`; allowed is {allowed}",
                self.word
            )
        };
        let index: i64 = part.parse().map_err(|_| wrong("a whole number"))?;
        match index {
            0 => Err(wrong(
                "1 for the first or −1 for the last before this line, never 0",
            )),
            1.. => {
                let index = index.unsigned_abs();
                if index > self.furthest {
                    (self.furthest, self.line) = (index, line);
                }
                Ok(u32::try_from(index).unwrap_or(u32::MAX))
            }
            _ => match self.count.checked_sub(index.unsigned_abs()) {
                Some(before) => Ok(before as u32 + 1),
                None => Err(wrong(&format!(
                    "at least -{}: so many stand before this line",
                    self.count
                ))),
            },
        }
    }
}

/// The next `N` words as numbers within bounds.
fn numbers<'a, const N: usize>(
    words: &mut impl Iterator<Item = &'a str>,
    allowed: &str,
) -> Result<[f64; N], String> {
    let mut numbers = [0.0_f64; N];
    for number in &mut numbers {
        let word = words
            .next()
            .ok_or_else(|| format!("found too few numbers; {allowed}"))?;
        *number = word
            .parse()
            .map_err(|_| format!("found {word:?}; {allowed}"))?;
        if !number.is_finite() || number.abs() > LARGEST {
            return Err(format!(
                "found {word}; allowed are finite numbers up to {LARGEST:?} in magnitude"
            ));
        }
    }
    Ok(numbers)
}
