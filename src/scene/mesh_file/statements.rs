//! The statements of OBJ files that have no use here, counted by what they are about.

use super::Remark;
use super::list::Found;

#[derive(Default)]
pub(super) struct Statements {
    materials: Found,
    groups: Found,
    lines: Found,
    curves: Found,
    unknown: Found,
}

impl Statements {
    pub fn count(&mut self, keyword: &[u8], line: usize) {
        let statements = match keyword {
            b"" => return,
            b"usemtl" | b"mtllib" | b"usemap" | b"maplib" => &mut self.materials,
            b"g" | b"o" | b"s" | b"mg" => &mut self.groups,
            b"l" | b"p" => &mut self.lines,
            b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf"
            | b"parm" | b"trim" | b"hole" | b"scrv" | b"sp" | b"end" | b"con" | b"ctech"
            | b"stech" => &mut self.curves,
            _ => &mut self.unknown,
        };
        statements.add(line);
    }

    /// What a file without faces has, as the end of a sentence.
    pub fn in_place_of_faces(&self) -> String {
        match (self.lines.count, self.curves.count, self.unknown.count) {
            (0, 0, 0) => String::new(),
            (0, 0, n) => format!(
                "; {n} of its lines are none of an OBJ file, the first is line {}",
                self.unknown.line
            ),
            (0, _, _) => "; its curves and surfaces (`curv`, `surf`) are not supported".into(),
            (_, _, _) => "; it has lines and points (`l`, `p`) only".into(),
        }
    }

    pub fn remark(&self, remarks: &mut Vec<Remark>) {
        let kinds = [
            (
                self.materials,
                "of materials (`usemtl`, `mtllib`)",
                "an object takes its material from the scene file",
            ),
            (
                self.groups,
                "of groups (`g`, `o`, `s`)",
                "a mesh is one object",
            ),
            (
                self.lines,
                "of lines and points (`l`, `p`)",
                "only faces are drawn",
            ),
            (
                self.curves,
                "of curves and surfaces (`curv`, `surf` and the like)",
                "only faces are drawn",
            ),
            (
                self.unknown,
                "without a known first word",
                "they say nothing about faces",
            ),
        ];
        for (Found { count, line }, about, why) in kinds {
            if count > 0 {
                let lines = if count == 1 { "line" } else { "lines" };
                remarks.push(Remark::new(
                    format!("{count} {lines} {about}, the first is line {line}"),
                    why,
                ));
            }
        }
    }
}
