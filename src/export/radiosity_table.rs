//! The light of a room and the system that was solved for it as tables.

use super::making::Making;
use super::tables::{Table, write_line};
use crate::algorithms::enclosure::{CHANNELS, Enclosure, Light};
use crate::scene::Scene;

/// B alone, or in a CSV every patch with its ρ, E and B.
pub fn radiosities(
    table: Table,
    scene: &Scene,
    enclosure: &Enclosure,
    light: &Light,
) -> Making<'static> {
    let b = &light.radiosity;
    if table == Table::Npy {
        let rows: Vec<_> = b.iter().map(|b| b.channels().to_vec()).collect();
        return table.array(&[rows.len(), CHANNELS.len()], move |i| rows[i].clone());
    }
    let channels = ["reflectance", "emission", "radiosity"].map(|name| {
        let of = |end: &str| format!("{name}.{end}");
        ["r", "g", "b"].map(of)
    });
    let place = ["object", "i", "j", "area"].map(String::from);
    let mut lines = vec![[&place[..], channels.as_flattened()].concat()];
    lines.extend(enclosure.patches.iter().enumerate().map(|(number, patch)| {
        let [i, j] = patch.cell.map(|index| index.to_string());
        let object = scene.objects[patch.object as usize].name.clone();
        let colors = [&enclosure.reflectance, &enclosure.emission, b];
        let numbers = colors.map(|color| color[number].channels());
        let numbers = numbers.as_flattened().iter();
        let area = format!("{:?}", patch.area);
        let numbers = numbers.map(|number| format!("{number:?}"));
        [object, i, j, area].into_iter().chain(numbers).collect()
    }));
    Making::new(lines.len(), move |line, out| write_line(out, &lines[line]))
}

/// I − ρF of each channel, from the matrix F.
pub fn system<'a>(
    table: Table,
    enclosure: &Enclosure,
    matrix: impl AsRef<[f64]> + Send + 'a,
) -> Making<'a> {
    let reflectance = enclosure.reflectance.clone();
    let n = reflectance.len();
    table.array(&[CHANNELS.len(), n, n], move |row| {
        let (channel, i) = (row / n, row % n);
        let rho = reflectance[i].channels()[channel];
        let f = &matrix.as_ref()[i * n..(i + 1) * n];
        let entries = f.iter().enumerate();
        entries
            .map(|(j, f)| f64::from(u8::from(i == j)) - rho * f)
            .collect()
    })
}
