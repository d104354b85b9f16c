//! The lines of a text file as they are found: with a byte order mark or in UTF-16, ended by LF, CR or both, continued by a `\`.

use std::borrow::Cow;

/// The text in one byte a character of ASCII, without its byte order mark. UTF-16 is recognised by its mark.
pub(super) fn text_of(bytes: &[u8]) -> Cow<'_, [u8]> {
    let from_utf16 = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = rest.as_chunks().0.iter().map(|&pair| unit(pair));
        let text: String = char::decode_utf16(units)
            .map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        Cow::Owned(text.into_bytes())
    };
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => from_utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => from_utf16(rest, u16::from_be_bytes),
        _ => Cow::Borrowed(bytes),
    }
}

/// The lines of a text, without comments (`#`) and blanks at either end. A line that ends with `\` goes on in the next.
pub(super) struct Lines<'a> {
    /// None behind the last line.
    rest: Option<&'a [u8]>,
    /// Of the line that comes next, counted from 1.
    number: usize,
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        Lines {
            rest: Some(text),
            number: 1,
        }
    }

    /// The next line as it stands in the file, and whether it goes on.
    fn physical(&mut self) -> Option<(&'a [u8], bool)> {
        let rest = self.rest.take()?;
        let end = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r');
        let line = &rest[..end.unwrap_or(rest.len())];
        self.rest = end.map(|end| match &rest[end..] {
            [b'\r', b'\n', behind @ ..] => behind,
            behind => &behind[1..],
        });
        self.number += 1;
        let line = without_comment(line).trim_ascii();
        Some(match line {
            [line @ .., b'\\'] => (line, true),
            line => (line, false),
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    /// With its number, counted from 1; of a line that goes on, that of its beginning.
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let number = self.number;
        let (line, mut goes_on) = self.physical()?;
        let mut line = Cow::Borrowed(line);
        while goes_on {
            let Some((more, again)) = self.physical() else {
                break;
            };
            let whole = line.to_mut();
            whole.push(b' ');
            whole.extend(more);
            goes_on = again;
        }
        Some((number, line))
    }
}

/// A `#` starts a comment, but not in `1.#QNAN` and `1.#INF`, as some compilers write what is no number.
fn without_comment(line: &[u8]) -> &[u8] {
    let is_start = |at: usize| line[at] == b'#' && (at == 0 || line[at - 1] != b'.');
    let end = (0..line.len()).find(|&at| is_start(at));
    &line[..end.unwrap_or(line.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(bytes: &[u8]) -> Vec<(usize, String)> {
        let text = text_of(bytes);
        Lines::new(&text)
            .map(|(number, line)| (number, String::from_utf8(line.into_owned()).unwrap()))
            .filter(|(_, line)| !line.is_empty())
            .collect()
    }

    #[test]
    fn every_line_end_counts_once() {
        for end in ["\n", "\r", "\r\n"] {
            let text = format!("a{end}{end} b # c{end}#{end}1.#INF d");
            let expected = [(1, "a"), (3, "b"), (5, "1.#INF d")];
            let expected = expected.map(|(number, line)| (number, line.to_owned()));
            assert_eq!(lines(text.as_bytes()), expected, "{end:?}");
        }
    }

    #[test]
    fn lines_that_go_on_are_joined_under_the_number_of_their_first() {
        let found = lines(b"f 1 \\\n2 \\\r\n 3\nv # not this one \\\nw\\");
        let expected = [(1, "f 1  2  3"), (4, "v"), (5, "w")];
        assert_eq!(
            found,
            expected.map(|(number, line)| (number, line.to_owned()))
        );
    }

    #[test]
    fn marks_of_the_encoding_are_passed_over() {
        let utf16 = |mark: &[u8], bytes: fn(u16) -> [u8; 2]| {
            let mut text = mark.to_vec();
            text.extend("v é\nw".encode_utf16().flat_map(bytes));
            text
        };
        let expected = [(1, "v é".to_owned()), (2, "w".to_owned())];
        assert_eq!(lines("\u{feff}v é\nw".as_bytes()), expected);
        assert_eq!(lines(&utf16(b"\xff\xfe", u16::to_le_bytes)), expected);
        assert_eq!(lines(&utf16(b"\xfe\xff", u16::to_be_bytes)), expected);
        assert_eq!(lines(b"\xff\xfe\x00\xd8"), [(1, "\u{fffd}".to_owned())]);
    }
}
