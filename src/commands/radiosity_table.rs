//! The light of a room and the system that was solved for it as tables.

use super::failure::Failure;
use super::form_factors::matrix_of;
use super::output;
use super::tables::{Table, write_line};
use crate::algorithms::enclosure::{CHANNELS, Enclosure, Light};
use crate::scene::Scene;
use std::path::Path;

/// B alone, or in a CSV every patch with its ρ, E and B.
pub fn write_radiosities(
    table: Table,
    out: &Path,
    scene: &Scene,
    enclosure: &Enclosure,
    light: &Light,
) -> Result<(), Failure> {
    output::write_whole(out, |out| {
        if table == Table::Npy {
            let shape = [light.radiosity.len(), CHANNELS.len()];
            let channels = light.radiosity.iter().flat_map(|patch| patch.channels());
            return table.write(out, &shape, channels);
        }
        let channels = ["reflectance", "emission", "radiosity"].map(|name| {
            let of = |end: &str| format!("{name}.{end}");
            ["r", "g", "b"].map(of)
        });
        let place = ["object", "i", "j", "area"].map(String::from);
        write_line(out, place.iter().chain(channels.as_flattened()))?;
        for (number, patch) in enclosure.patches.iter().enumerate() {
            let [i, j] = patch.cell.map(|index| index.to_string());
            let object = scene.objects[patch.object as usize].name.clone();
            let colors = [
                &enclosure.reflectance,
                &enclosure.emission,
                &light.radiosity,
            ];
            let numbers = colors.map(|color| color[number].channels());
            let numbers = numbers.as_flattened().iter();
            let area = format!("{:?}", patch.area);
            let numbers = numbers.map(|number| format!("{number:?}"));
            write_line(out, [object, i, j, area].into_iter().chain(numbers))?;
        }
        Ok(())
    })
}

/// I − ρF of each channel.
pub fn write_system(path: &Path, enclosure: &Enclosure) -> Result<(), Failure> {
    let n = enclosure.patches.len();
    let matrix = matrix_of(enclosure);
    let entry = |channel: usize, i: usize, j: usize| {
        let rho = enclosure.reflectance[i].channels()[channel];
        f64::from(u8::from(i == j)) - rho * matrix[i * n + j]
    };
    let rows = (0..CHANNELS.len()).flat_map(|channel| (0..n).map(move |i| (channel, i)));
    let entries = rows.flat_map(|(channel, i)| (0..n).map(move |j| entry(channel, i, j)));
    let table = Table::of(path).unwrap_or(Table::Npy);
    output::write_whole(path, |out| {
        table.write(out, &[CHANNELS.len(), n, n], entries)
    })
}
