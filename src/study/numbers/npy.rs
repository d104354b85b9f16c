//! The `.npy` of NumPy (NEP 1): a header that says type, order and shape, and then the numbers.

const MAGIC: &[u8] = b"\x93NUMPY";

pub fn is_npy(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The rows of an array of one or two dimensions; an array of one has a number a row. Errors: what is wrong.
pub fn rows(bytes: &[u8]) -> Result<Vec<Vec<f64>>, String> {
    let cut = || "the .npy file ends in its header".to_owned();
    let (major, rest) = (bytes.get(MAGIC.len()), bytes.get(MAGIC.len() + 2..));
    let rest = rest.ok_or_else(cut)?;
    // Version 1 has two bytes for the length of the header, later ones four.
    let width = if major == Some(&1) { 2 } else { 4 };
    let length = rest.get(..width).ok_or_else(cut)?;
    let length = length
        .iter()
        .rev()
        .fold(0_usize, |sum, &byte| 256 * sum + usize::from(byte));
    let header = rest.get(width..).and_then(|rest| rest.get(..length));
    let header = String::from_utf8_lossy(header.ok_or_else(cut)?).into_owned();
    let value = |key: &str| {
        let (_, behind) = header.split_once(&format!("'{key}'"))?;
        Some(behind.trim_start().strip_prefix(':')?.trim_start())
    };
    let wrong = || {
        format!(
            "the header of the .npy file is not understood: {}",
            header.trim()
        )
    };
    let kind = value("descr").and_then(|value| value.strip_prefix('\''));
    let kind = kind
        .and_then(|kind| kind.split('\'').next())
        .ok_or_else(wrong)?;
    let by_columns = value("fortran_order")
        .ok_or_else(wrong)?
        .starts_with("True");
    let shape = value("shape").and_then(|value| value.strip_prefix('('));
    let shape = shape
        .and_then(|shape| shape.split(')').next())
        .ok_or_else(wrong)?;
    let sides = shape
        .split(',')
        .map(str::trim)
        .filter(|side| !side.is_empty());
    let sides = sides.map(|side| side.parse::<usize>().map_err(|_| wrong()));
    let sides: Vec<usize> = sides.collect::<Result<_, _>>()?;
    let [count, columns] = match sides[..] {
        [count] => [count, 1],
        [count, columns] => [count, columns],
        _ => {
            let found = sides.len();
            return Err(format!(
                "the array has {found} dimensions; allowed are 1 and 2"
            ));
        }
    };
    let numbers = numbers(kind, &rest[width + length..])?;
    if count.checked_mul(columns) != Some(numbers.len()) {
        let found = numbers.len();
        return Err(format!(
            "the shape is ({shape}), and {found} numbers follow"
        ));
    }
    if numbers.is_empty() {
        return Ok(Vec::new());
    }
    let at = |row: usize, column: usize| match by_columns {
        true => numbers[column * count + row],
        false => numbers[row * columns + column],
    };
    let row = |row: usize| (0..columns).map(|column| at(row, column)).collect();
    Ok((0..count).map(row).collect())
}

/// The numbers of a type such as `<f8`: the order of its bytes, its kind, and how many bytes it has.
fn numbers(kind: &str, bytes: &[u8]) -> Result<Vec<f64>, String> {
    let whole = |bytes: &[u8]| -> [u8; 8] { std::array::from_fn(|at| bytes[at]) };
    let half = |bytes: &[u8]| -> [u8; 4] { std::array::from_fn(|at| bytes[at]) };
    let big = kind.starts_with('>');
    // All bytes from the least to the greatest.
    let each = |size: usize, number: &dyn Fn(&[u8]) -> f64| {
        let chunks = bytes.chunks_exact(size).map(|chunk| {
            let mut chunk = chunk.to_vec();
            if big {
                chunk.reverse();
            }
            number(&chunk)
        });
        chunks.collect()
    };
    match kind.trim_start_matches(['<', '>', '=']) {
        "f8" => Ok(each(8, &|bytes| f64::from_le_bytes(whole(bytes)))),
        "f4" => Ok(each(4, &|bytes| f32::from_le_bytes(half(bytes)).into())),
        "i8" => Ok(each(8, &|bytes| i64::from_le_bytes(whole(bytes)) as f64)),
        "i4" => Ok(each(4, &|bytes| i32::from_le_bytes(half(bytes)).into())),
        _ => Err(format!(
            "its numbers are of the type {kind:?}; allowed are f8, f4, i8 and i4"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(described: &str, numbers: &[u8]) -> Vec<u8> {
        let mut file = b"\x93NUMPY\x01\x00".to_vec();
        file.extend((described.len() as u16).to_le_bytes());
        file.extend(described.bytes());
        file.extend(numbers);
        file
    }

    fn header(kind: &str, by_columns: &str, shape: &str) -> String {
        format!("{{'descr': '{kind}', 'fortran_order': {by_columns}, 'shape': {shape}, }}   \n")
    }

    #[test]
    fn arrays_are_read_in_both_orders_and_of_several_types() {
        let doubles: Vec<u8> = [0.0, 0.4, 0.1, 0.2_f64]
            .iter()
            .flat_map(|n| n.to_le_bytes())
            .collect();
        let by_rows = Ok(vec![vec![0.0, 0.4], vec![0.1, 0.2]]);
        assert_eq!(
            rows(&file(&header("<f8", "False", "(2, 2)"), &doubles)),
            by_rows
        );
        let turned = Ok(vec![vec![0.0, 0.1], vec![0.4, 0.2]]);
        assert_eq!(
            rows(&file(&header("<f8", "True", "(2, 2)"), &doubles)),
            turned
        );
        let floats: Vec<u8> = [0.5, -2.0_f32]
            .iter()
            .flat_map(|n| n.to_be_bytes())
            .collect();
        let column = Ok(vec![vec![0.5], vec![-2.0]]);
        assert_eq!(
            rows(&file(&header(">f4", "False", "(2,)"), &floats)),
            column
        );
        let whole: Vec<u8> = [3_i64, -1].iter().flat_map(|n| n.to_le_bytes()).collect();
        let row = Ok(vec![vec![3.0, -1.0]]);
        assert_eq!(rows(&file(&header("<i8", "False", "(1, 2)"), &whole)), row);
    }

    #[test]
    fn an_array_without_numbers_has_no_rows() {
        let empty = file(&header("<f8", "False", "(99999999999999, 0)"), &[]);
        assert_eq!(rows(&empty), Ok(Vec::new()));
    }

    #[test]
    fn what_is_not_understood_is_reported() {
        for (bytes, expected) in [
            (b"\x93NUMPY\x01".to_vec(), "ends in its header"),
            (b"\x93NUMPY\x01\x00\xff\xff{".to_vec(), "ends in its header"),
            (file("{'descr': 3}", &[]), "is not understood"),
            (
                file(&header("<c16", "False", "(1,)"), &[0; 16]),
                "\"<c16\"; allowed are f8",
            ),
            (
                file(&header("<f8", "False", "(2, 2)"), &[0; 16]),
                "2 numbers follow",
            ),
            (
                file(&header("<f8", "False", "(1, 1, 1)"), &[0; 8]),
                "has 3 dimensions",
            ),
            (
                file(
                    &header("<f8", "False", "(99999999999, 99999999999)"),
                    &[0; 8],
                ),
                "1 numbers follow",
            ),
        ] {
            let error = rows(&bytes).unwrap_err();
            assert!(error.contains(expected), "{error}");
        }
    }
}
