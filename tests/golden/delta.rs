//! Texts of one panel in one file, a section a step. A section is written as what it changes in an earlier one, so that the file
//! stays small and a difference between two versions of it stays short.

use std::fmt::Write;

/// A step's text under a heading of one line.
#[derive(Clone, PartialEq, Debug)]
pub struct Section {
    pub heading: String,
    pub lines: Vec<String>,
}

/// How far back a section looks for the one that it is most like: both languages have their turn.
const REACH: usize = 2;

/// `== heading` opens a section, `~ n` says how many sections back stands what it changes (0: nothing). Then, in order,
/// `=n` keeps n lines, `-n` drops n lines, and `+line` adds one. What is left at the end is dropped.
pub fn write(sections: &[Section]) -> String {
    let mut text = String::new();
    for (i, section) in sections.iter().enumerate() {
        let shortest = (0..=REACH.min(i))
            .map(|back| {
                let base = if back == 0 {
                    &[][..]
                } else {
                    &sections[i - back].lines[..]
                };
                format!("~ {back}\n{}", edits(base, &section.lines))
            })
            .min_by_key(String::len)
            .unwrap();
        let _ = write!(text, "== {}\n{shortest}", section.heading);
    }
    text
}

pub fn read(text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    let mut base: Vec<String> = Vec::new();
    let mut at = 0;
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("== ") {
            sections.push(Section {
                heading: heading.to_owned(),
                lines: Vec::new(),
            });
            continue;
        }
        let current = sections.len() - 1;
        let count = || line[1..].trim().parse::<usize>().unwrap();
        let into = &mut sections[current].lines;
        match line.as_bytes()[0] {
            b'+' => into.push(line[1..].to_owned()),
            b'=' => {
                into.extend_from_slice(&base[at..at + count()]);
                at += count();
            }
            b'-' => at += count(),
            b'~' => {
                base = match count() {
                    0 => Vec::new(),
                    back => sections[current - back].lines.clone(),
                };
                at = 0;
            }
            _ => panic!("no line of a golden text: {line}"),
        }
    }
    sections
}

fn edits(old: &[String], new: &[String]) -> String {
    let mut text = String::new();
    let (mut from, mut to) = (0, 0);
    for (start, new_start, length) in common_runs(old, new) {
        if start > from {
            let _ = writeln!(text, "-{}", start - from);
        }
        for line in &new[to..new_start] {
            let _ = writeln!(text, "+{line}");
        }
        let _ = writeln!(text, "={length}");
        (from, to) = (start + length, new_start + length);
    }
    for line in &new[to..] {
        let _ = writeln!(text, "+{line}");
    }
    text
}

/// Runs of lines that both have, as (place in old, place in new, length): a longest common subsequence.
fn common_runs(old: &[String], new: &[String]) -> Vec<(usize, usize, usize)> {
    let head = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let (a, b) = (&old[head..], &new[head..]);
    let tail = a
        .iter()
        .rev()
        .zip(b.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let (a, b) = (&a[..a.len() - tail], &b[..b.len() - tail]);
    // length[i][j]: of the longest common subsequence of a[i..] and b[j..]
    let columns = b.len() + 1;
    let mut length = vec![0u32; (a.len() + 1) * columns];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            length[i * columns + j] = if a[i] == b[j] {
                length[(i + 1) * columns + j + 1] + 1
            } else {
                length[(i + 1) * columns + j].max(length[i * columns + j + 1])
            };
        }
    }
    let mut pairs: Vec<(usize, usize)> = (0..head).map(|i| (i, i)).collect();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        if a[i] == b[j] {
            pairs.push((head + i, head + j));
            (i, j) = (i + 1, j + 1);
        } else if length[(i + 1) * columns + j] >= length[i * columns + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs.extend(
        (0..tail)
            .rev()
            .map(|back| (old.len() - 1 - back, new.len() - 1 - back)),
    );

    let mut runs: Vec<(usize, usize, usize)> = Vec::new();
    for (i, j) in pairs {
        match runs.last_mut() {
            Some((start, new_start, length))
                if *start + *length == i && *new_start + *length == j =>
            {
                *length += 1;
            }
            _ => runs.push((i, j, 1)),
        }
    }
    runs
}

#[test]
fn sections_read_back_as_they_were_written() {
    let section = |heading: &str, lines: &str| Section {
        heading: heading.to_owned(),
        lines: lines.chars().map(String::from).collect(),
    };
    let sections = [
        section("00", "abcdef"),
        section("01", "ghij"),
        section("02", "abxdef"),
        section("03", "ghij"),
        section("04", ""),
        section("05", "fedxcba"),
    ];
    let text = write(&sections);
    assert_eq!(read(&text), sections);
    assert!(text.contains("== 03\n~ 2\n=4\n"), "{text}");
}
