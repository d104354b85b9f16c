//! Wavefront OBJ files as they are found: positions (`v`), texture coordinates (`vt`), normals (`vn`) and faces of any size (`f`).
//! Everything else is counted and passed over. A vertex or a face that cannot be right is refused with its line; what is wrong with
//! texture coordinates or normals is dropped, because a mesh is a mesh without them.

use super::kind::kind_of;
use super::lines::{Lines, text_of};
use super::list::{Found, List};
use super::statements::Statements;
use super::{MeshData, Remark};
use crate::scene::validate::{LARGEST, unit};
use glam::{DVec2, DVec3};
use std::collections::HashMap;
use std::str::SplitAsciiWhitespace;

/// Which coordinates a vertex may have.
const FINITE: &str = "allowed are finite numbers from -1e75 to 1e75";

/// Errors: what the file is instead, the first line that is wrong, no faces at all, or more than `max_triangles`, as a sentence.
pub(super) fn read(bytes: &[u8], max_triangles: u64) -> Result<MeshData, String> {
    if let Some(kind) = kind_of(bytes) {
        return Err(format!("found {kind} in place of a Wavefront OBJ file"));
    }
    let text = text_of(bytes);
    if text.trim_ascii_start().starts_with(b"{") {
        return Err(
            "found JSON in place of a Wavefront OBJ file; the name of a glTF file ends in .gltf"
                .into(),
        );
    }
    let mut reader = Reader::new(max_triangles);
    for (number, line) in Lines::new(&text) {
        reader
            .take(&line, number)
            .map_err(|problem| format!("line {number}: {problem}"))?;
    }
    reader.finish()
}

struct Reader {
    file: MeshData,
    max_triangles: u64,
    /// Of `v`, `vt` and `vn`, in the order in which a corner names them.
    lists: [List; 3],
    other: Statements,
    /// The lines of vertices beyond the largest coordinate, which no face may have.
    far: HashMap<u32, usize>,
    few_corners: Found,
    weights: Found,
    colors: Found,
    /// Texture coordinates and normals that are not numbers, or without a direction.
    unusable: [Found; 2],
}

impl Reader {
    fn new(max_triangles: u64) -> Self {
        Reader {
            file: MeshData::default(),
            max_triangles,
            lists: ["v", "vt", "vn"].map(List::new),
            other: Statements::default(),
            far: HashMap::new(),
            few_corners: Found::default(),
            weights: Found::default(),
            colors: Found::default(),
            unusable: [Found::default(); 2],
        }
    }

    fn take(&mut self, line: &[u8], number: usize) -> Result<(), String> {
        let mut words = line.split(u8::is_ascii_whitespace);
        let keyword = words.next().unwrap_or_default();
        if !matches!(keyword, b"v" | b"vt" | b"vn" | b"f" | b"fo") {
            self.other.count(keyword, number);
            return Ok(());
        }
        let line = std::str::from_utf8(line).map_err(|_| "found bytes that are not text")?;
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => self.take_position(words, number),
            Some("vt") => self.take_uv(words, number),
            Some("vn") => self.take_normal(words, number),
            _ => self.take_face(words, number),
        }
    }

    fn take_position(&mut self, words: SplitAsciiWhitespace, line: usize) -> Result<(), String> {
        let allowed = "`v` takes x y z, then nothing, a weight, or a colour";
        let mut position = [0.0; 3];
        let mut count = 0;
        for word in words {
            let value = number(word).map_err(|()| format!("found {word:?}; {allowed}"))?;
            if let Some(coordinate) = position.get_mut(count) {
                if !value.is_finite() {
                    return Err(format!("found {word}; {FINITE}"));
                }
                *coordinate = value;
            }
            count += 1;
        }
        match count {
            0..3 => return Err(format!("found too few numbers; {allowed}")),
            3 => {}
            4 => self.weights.add(line),
            6 | 7 => self.colors.add(line),
            _ => return Err(format!("found {count} numbers; {allowed}")),
        }
        if position.iter().any(|x| x.abs() > LARGEST) {
            self.far.insert(self.file.positions.len() as u32, line);
        }
        self.lists[0].count += 1;
        self.file.positions.push(position.into());
        Ok(())
    }

    /// A third coordinate, for solid textures, has no use here.
    fn take_uv(&mut self, words: SplitAsciiWhitespace, line: usize) -> Result<(), String> {
        let allowed = "`vt` takes one, two or three numbers";
        let ([u, v, _], count) = numbers(words, allowed)?;
        if count == 0 {
            return Err(format!("found no number; {allowed}"));
        }
        let is_usable = u.abs() <= LARGEST && v.abs() <= LARGEST;
        if !is_usable {
            self.unusable[0].add(line);
        }
        self.lists[1].count += 1;
        self.file.uvs.push(if is_usable {
            DVec2::new(u, v)
        } else {
            DVec2::ZERO
        });
        Ok(())
    }

    fn take_normal(&mut self, words: SplitAsciiWhitespace, line: usize) -> Result<(), String> {
        let (normal, count) = numbers(words, "`vn` takes three numbers")?;
        let normal = Some(DVec3::from(normal)).filter(|normal| count == 3 && normal.is_finite());
        let normal = normal.and_then(unit);
        if normal.is_none() {
            self.unusable[1].add(line);
        }
        self.lists[2].count += 1;
        self.file.normals.push(normal.unwrap_or_default());
        Ok(())
    }

    fn take_face(&mut self, words: SplitAsciiWhitespace, line: usize) -> Result<(), String> {
        let start = self.file.corners.len();
        let mut count = 0;
        // Once there are too many triangles they are only counted.
        let kept = self.file.triangles <= self.max_triangles;
        for word in words {
            count += 1;
            let mut indices = [None; 3];
            for (kind, part) in word.split('/').enumerate() {
                let Some(list) = self.lists.get_mut(kind) else {
                    return Err(format!(
                        "found the corner {word:?}; a corner is v, v/vt, v//vn or v/vt/vn"
                    ));
                };
                if !part.is_empty() {
                    indices[kind] = list.resolve(part, line, kind > 0)?;
                }
            }
            let [Some(position), uv, normal] = indices else {
                return Err(format!(
                    "found the corner {word:?} without a vertex; a corner is v, v/vt, v//vn or v/vt/vn"
                ));
            };
            if kept {
                let corner = [position - 1, uv.unwrap_or(0), normal.unwrap_or(0)];
                self.file.corners.push(corner);
            }
        }
        if count < 3 {
            self.few_corners.add(line);
            self.file.corners.truncate(start);
            return Ok(());
        }
        if kept {
            self.file.starts.push(self.file.corners.len() as u32);
        }
        self.file.triangles += count - 2;
        Ok(())
    }

    fn finish(mut self) -> Result<MeshData, String> {
        let [positions, uvs, normals] = &mut self.lists;
        let (furthest, line) = positions.furthest;
        if furthest > positions.count {
            return Err(format!(
                "line {line}: a face refers to `v` number {furthest}; the file has {} lines `v`",
                positions.count
            ));
        }
        match self.file.triangles {
            0 => {
                return Err(format!(
                    "found no faces (lines that start with `f`, with three corners or more); a mesh needs at least one{}",
                    self.other.in_place_of_faces()
                ));
            }
            n if n > self.max_triangles => {
                return Err(format!(
                    "found {n} triangles; at most {} are allowed (--max-triangles)",
                    self.max_triangles
                ));
            }
            _ => {}
        }
        let mut far = self
            .file
            .corners
            .iter()
            .filter_map(|corner| self.far.get(&corner[0]));
        if let Some(line) = far.next() {
            return Err(format!(
                "line {line}: found a vertex of a face too far away; {FINITE}"
            ));
        }
        for corner in &mut self.file.corners {
            for (kind, list) in [(1, &mut *uvs), (2, &mut *normals)] {
                if u64::from(corner[kind]) > list.count {
                    corner[kind] = 0;
                    list.missing.count += 1;
                }
            }
        }
        for list in [uvs, normals] {
            if list.furthest.0 > list.count {
                let first = list.missing.line;
                list.missing.line = if first == 0 {
                    list.furthest.1
                } else {
                    first.min(list.furthest.1)
                };
            }
        }
        self.file.remarks = self.remarks();
        Ok(self.file)
    }

    fn remarks(&self) -> Vec<Remark> {
        let [_, uvs, normals] = &self.lists;
        let mut remarks = Vec::new();
        let mut remark = |found: Found, [one, many]: [&str; 2], why| {
            if found.count > 0 {
                let things = if found.count == 1 { one } else { many };
                remarks.push(Remark::new(
                    format!("{} {things}, the first in line {}", found.count, found.line),
                    why,
                ));
            }
        };
        remark(
            self.few_corners,
            [
                "face of fewer than three corners",
                "faces of fewer than three corners",
            ],
            "left out, having no area",
        );
        remark(
            uvs.missing,
            [
                "corner with a `vt` that the file lacks",
                "corners with a `vt` that the file lacks",
            ],
            "their texture coordinates are (0, 0)",
        );
        remark(
            self.unusable[0],
            ["`vt` that is no number", "`vt` that are no numbers"],
            "their texture coordinates are (0, 0)",
        );
        remark(
            normals.missing,
            [
                "corner with a `vn` that the file lacks",
                "corners with a `vn` that the file lacks",
            ],
            "they have no normal of their own",
        );
        remark(
            self.unusable[1],
            ["`vn` without a direction", "`vn` without a direction"],
            "corners that name them have no normal of their own",
        );
        remark(
            self.weights,
            [
                "vertex with a fourth number",
                "vertices with a fourth number",
            ],
            "left out: a weight is for rational curves and surfaces",
        );
        remark(
            self.colors,
            ["vertex with a colour", "vertices with a colour"],
            "colours come from the material of the object",
        );
        self.other.remark(&mut remarks);
        remarks
    }
}

/// A number as compilers write it, also where it is none: `nan`, `-nan(ind)`, `1.#QNAN`, `-1.#INF`.
fn number(word: &str) -> Result<f64, ()> {
    if let Ok(value) = word.parse() {
        return Ok(value);
    }
    let lower = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    let is_none = lower.starts_with("nan") || lower.starts_with("1.#");
    is_none.then_some(f64::NAN).ok_or(())
}

/// The first three numbers of a line, 0 where it has fewer, and how many there are.
fn numbers(words: SplitAsciiWhitespace, allowed: &str) -> Result<([f64; 3], usize), String> {
    let (mut numbers, mut count) = ([0.0; 3], 0);
    for word in words {
        let value = number(word).map_err(|()| format!("found {word:?}; {allowed}"))?;
        if let Some(number) = numbers.get_mut(count) {
            *number = value;
        }
        count += 1;
    }
    Ok((numbers, count))
}
