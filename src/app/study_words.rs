//! What studies are called and ask, in Indonesian too. Names of methods and settings are those of the command line in both.

use super::session::Session;
use super::strings;
use crate::panels::strings::Language;
use crate::study::form::Study;
use crate::study::harness::{Line, Point};
use crate::study::report::strings as report;

pub fn title(study: &Study, language: Language) -> &'static str {
    match language {
        Language::English => study.title,
        _ => in_indonesian(study.name).map_or(study.title, |[title, _]| title),
    }
}

pub fn about(study: &Study, language: Language) -> &'static str {
    match language {
        Language::English => study.about,
        _ => in_indonesian(study.name).map_or(study.about, |[_, about]| about),
    }
}

/// Title and question, by the name.
fn in_indonesian(name: &str) -> Option<[&'static str; 2]> {
    Some(match name {
        "shading" => [
            "Metode peneduhan menurut kehalusan poligon",
            "Berapa banyak poligon yang diperlukan tiap metode peneduhan, dan berapa lama, sampai bola tampak sehalus aslinya?",
        ],
        "interpolation" => [
            "Interpolasi inkremental lawan langsung",
            "Satu penjumlahan tiap langkah, atau rumusnya dihitung ulang: apa yang dihemat penjumlahan, dan apa yang hilang?",
        ],
        "ray-depth" => [
            "Ray tracing menurut kedalaman",
            "Seberapa dalam sinar harus diikuti, dan berapa biaya tiap tingkat? Sinar tidak dipotong secara adaptif: `path_attenuation` mengubah gambarnya, sehingga pemotongan menurut kedalaman lebih cepat tidak merugikan.",
        ],
        "ray-samples" => [
            "Metode sinar menurut jumlah sampel per piksel",
            "Berapa sinar per piksel cukup untuk melawan tepi bergerigi?",
        ],
        "search" => [
            "Semua objek satu per satu lawan hierarki",
            "Mulai berapa objek hierarki menguntungkan? Keduanya menemukan hal yang sama, jadi tidak ada galat.",
        ],
        "precision" => [
            "f32 lawan f64: titik temu pada bola satuan yang jauh",
            "Apakah rumus lebih menentukan daripada presisi? Sinar datang ke bola satuan dari tempat yang makin jauh.",
        ],
        "form-factors" => [
            "Metode faktor bentuk menurut jumlah sampel",
            "Cara mana yang termurah untuk galat tertentu, bila patch berhadapan, dan bila bersentuhan? Untuk metode adaptif, 1/toleransi dihitung sebagai sampel.",
        ],
        "solvers" => [
            "Penyelesai sistem radiositas",
            "Penyelesai mana yang lebih dahulu mencapai galat B tertentu? Satu sapuan adalah satu iterasi, atau tembakan sebanyak jumlah patch.",
        ],
        "patches" => [
            "Radiositas menurut jumlah patch per dinding",
            "Seberapa halus dinding harus dibagi, dan seberapa teliti faktor bentuk untuk itu?",
        ],
        "growth" => [
            "Bagaimana kerja bertambah",
            "Berapa biaya dua kali lipat piksel, segitiga, tingkat, patch, atau kejadian?",
        ],
        _ => return None,
    })
}

/// What the size of a setting counts, or what errors are errors of.
pub fn measure(english: &'static str, language: Language) -> &'static str {
    if language == Language::English {
        return english;
    }
    match english {
        "longitudes of a sphere" => "garis bujur sebuah bola",
        "steps" => "langkah",
        "levels" => "tingkat",
        "rays along a pixel's side" => "sinar sepanjang sisi piksel",
        "objects" => "objek",
        "distance, in radii" => "jarak, dalam jari-jari",
        "samples" => "sampel",
        "sweeps" => "sapuan",
        "patches along a wall" => "patch sepanjang dinding",
        "pixels" => "piksel",
        "triangles" => "segitiga",
        "patches" => "patch",
        "events" => "kejadian",
        "intensity" => "intensitas",
        "intensity where N·V ≥ 0.6" => "intensitas di mana N·V ≥ 0.6",
        "the values from 0 to 1" => "nilai dari 0 sampai 1",
        "t, a share of the distance" => "t, sebagai bagian dari jarak",
        "B, in the unit of the emission" => "B, dalam satuan emisi",
        "B, at the centres of the finest patches" => "B, di pusat patch terhalus",
        other => other,
    }
}

/// Everything about a point, a line each.
pub fn recorded(session: &Session, line: &Line, point: &Point) -> String {
    let localize = |strings| session.localize(strings);
    let mut recorded = format!("{}, {}", line.name, point.setting);
    if let Some(errors) = point.errors {
        let [rms, largest, relative] = [errors.rms, errors.largest, errors.relative]
            .map(|error| session.look.language.magnitude(error));
        recorded += &format!(
            "\n{}: rms {rms}, max {largest}, rel {relative}",
            localize(strings::ERROR_IS)
        );
    }
    let timing = &point.seconds;
    let [median, lower, upper] = [timing.median, timing.lower, timing.upper]
        .map(|seconds| report::seconds(seconds, session.look.language));
    recorded += &format!(
        "\n{}: {median} ({} {lower} – {upper}, {}×)",
        localize(strings::TIME_IS),
        localize(strings::QUARTILES),
        timing.runs
    );
    let mut counts: Vec<String> = Vec::new();
    for operations in &point.operations {
        counts.push(format!(
            "{} {}",
            operations.count,
            operations.of.replace('_', " ")
        ));
    }
    counts.push(format!(
        "{} {}",
        localize(strings::MEMORY_IS),
        report::bytes(point.bytes, session.look.language)
    ));
    recorded += &format!("\n{}", counts.join(", "));
    if point.on_front {
        recorded += &format!("\n{}", localize(strings::ON_THE_FRONT));
    }
    match (&point.drawn, session.studying().command_line()) {
        (Some(_), _) => recorded += &format!("\n{}", localize(strings::CLICK_OPENS_IT)),
        (None, Some(command)) => {
            recorded += &format!("\n{} {command}", localize(strings::MEASURED_AGAIN_BY));
        }
        (None, None) => {}
    }
    recorded
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::families;

    #[test]
    fn every_study_has_its_title_and_question_in_both_languages() {
        for study in families::ALL {
            assert!(in_indonesian(study.name).is_some(), "{}", study.name);
        }
    }
}
