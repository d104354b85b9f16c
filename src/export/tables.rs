//! Tables for other programs: CSV (RFC 4180), and the `.npy` of NumPy.

use super::making::Making;
use std::io::{self, Write};
use std::path::Path;

/// How an array of numbers is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Table {
    Csv,
    Npy,
}

impl Table {
    /// That of a file's name, where it ends in `.csv` or `.npy`.
    pub fn of(path: &Path) -> Option<Table> {
        Table::with_ending(path.extension()?.to_str()?)
    }

    pub fn with_ending(ending: &str) -> Option<Table> {
        match ending {
            "csv" => Some(Table::Csv),
            "npy" => Some(Table::Npy),
            _ => None,
        }
    }

    /// An array of this shape, the last index running fastest; `row` gives all its rows in turn, by their number. In a CSV the last
    /// index runs along a line, and there is no header.
    pub fn array<'a>(
        self,
        shape: &[usize],
        mut row: impl FnMut(usize) -> Vec<f64> + Send + 'a,
    ) -> Making<'a> {
        let header = npy_header(shape);
        let rows: usize = shape[..shape.len() - 1].iter().product();
        Making::new(1 + rows, move |part, out| {
            match (self, part.checked_sub(1)) {
                (Table::Npy, None) => out.write_all(&header),
                (Table::Csv, None) => Ok(()),
                (Table::Npy, Some(number)) => {
                    let numbers = row(number).into_iter();
                    let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
                    out.write_all(&bytes)
                }
                (Table::Csv, Some(number)) => {
                    write_line(out, row(number).iter().map(|value| format!("{value:?}")))
                }
            }
        })
    }
}

/// Version 1.0 of the format: 64-bit floats, little-endian.
fn npy_header(shape: &[usize]) -> Vec<u8> {
    const START: usize = b"\x93NUMPY\x01\x00".len() + size_of::<u16>();
    let sides: String = shape.iter().map(|side| format!("{side}, ")).collect();
    let described = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({sides}), }}");
    // The numbers begin at a multiple of 64 bytes, behind a line break.
    let whole = (START + described.len() + 1).next_multiple_of(64);
    let mut header = b"\x93NUMPY\x01\x00".to_vec();
    header.extend(((whole - START) as u16).to_le_bytes());
    header.extend(described.bytes());
    header.resize(whole - 1, b' ');
    header.push(b'\n');
    header
}

/// A line of a CSV.
pub fn write_line<T: AsRef<str>>(
    out: &mut dyn Write,
    cells: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    for (number, cell) in cells.into_iter().enumerate() {
        let (cell, before) = (cell.as_ref(), if number == 0 { "" } else { "," });
        match cell.contains([',', '"', '\n', '\r']) {
            true => write!(out, "{before}\"{}\"", cell.replace('"', "\"\""))?,
            false => write!(out, "{before}{cell}")?,
        }
    }
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(table: Table, shape: &[usize]) -> Vec<u8> {
        let mut file = Vec::new();
        let values = [1.0, 0.5, -2.0, 1e-300, 0.1, f64::NAN];
        let rows = table.array(shape, |row| values.chunks(3).nth(row).unwrap().to_vec());
        rows.write_all(&mut file, &|_, _| ()).unwrap();
        file
    }

    #[test]
    fn an_npy_has_its_shape_and_its_numbers_at_a_multiple_of_64() {
        let file = written(Table::Npy, &[2, 3]);
        let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3, ), }";
        assert_eq!(file[..10], *b"\x93NUMPY\x01\x00\x76\x00");
        assert!(file[10..].starts_with(header.as_bytes()));
        assert_eq!(file[127], b'\n');
        assert_eq!(file.len(), 128 + 6 * 8);
        assert_eq!(file[128..136], 1.0_f64.to_le_bytes());
        assert_eq!(file[160..168], 0.1_f64.to_le_bytes());
    }

    #[test]
    fn a_csv_has_a_line_a_row_and_every_digit() {
        let file = String::from_utf8(written(Table::Csv, &[2, 3])).unwrap();
        assert_eq!(file, "1.0,0.5,-2.0\n1e-300,0.1,NaN\n");
    }

    #[test]
    fn a_cell_with_a_comma_is_quoted() {
        let mut line = Vec::new();
        write_line(&mut line, ["plain", "a, \"b\"", ""]).unwrap();
        assert_eq!(line, b"plain,\"a, \"\"b\"\"\",\n");
    }
}
