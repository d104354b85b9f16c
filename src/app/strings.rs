//! The window's words, in both languages.

use crate::panels::strings::Words;
use crate::study::harness::Point;
use crate::study::report::strings as report;

macro_rules! strings {
    ($($name:ident: $en:literal, $id:literal;)*) => {
        $(pub const $name: Words = Words::new($en, $id);)*
        /// All of them, for the test.
        #[cfg(test)]
        const ALL: &[(&str, Words)] = &[$((stringify!($name), $name)),*];
    };
}

strings! {
    PRESENT: "Present", "Presentasi";
    SHARE: "Share step", "Bagikan langkah";
    SHARED: "Copied: the command that opens this lesson at this step.", "Disalin: perintah yang membuka pelajaran ini pada langkah ini.";
    THEME: "Theme", "Tema";
    THEME_LIGHT: "light", "terang";
    THEME_DARK: "dark", "gelap";
    THEME_PROJECTOR: "projector", "proyektor";
    KEYS: "keys", "tombol";
    KEYS_TITLE: "Keys", "Tombol";
    CLOSE: "Close", "Tutup";
    MENU: "More", "Lainnya";
    QUESTIONS: "Ask me questions", "Ajukan pertanyaan";
    STUDIES: "Error against run time", "Galat terhadap waktu jalan";
    STUDY: "Study", "Studi";
    QUICK: "few and small settings", "pengaturan sedikit dan kecil";
    MEASURE: "Measure", "Ukur";
    CALL_OFF: "Call off", "Batalkan";
    BACK_TO_THE_RUN: "Back to the lesson", "Kembali ke pelajaran";
    MEASURING: "measuring", "mengukur";
    CALLED_OFF: "Called off; what had come stays.", "Dibatalkan; yang sudah masuk tetap ada.";
    NO_FINDINGS: "No result:", "Tidak ada hasil:";
    NOTHING_MEASURED: "Choose a study and measure it. It runs in the background, on one thread.", "Pilih sebuah studi lalu ukur. Studi berjalan di latar belakang, pada satu utas.";
    DEBUG_BUILD: "This is a debug build: its times say nothing about the algorithms.", "Ini build debug: waktunya tidak mengatakan apa-apa tentang algoritme.";
    STUDY_PLOT: "plot of the study", "grafik studi";
    TIME_OF_A_RUN: "time of a run (median)", "waktu satu kali jalan (median)";
    RMS_ERROR_OF: "rms error of", "galat rms dari";
    ON_THE_FRONT: "On the Pareto front: no other setting is as quick and as exact.", "Di front Pareto: tidak ada pengaturan lain yang secepat dan seteliti ini.";
    ERROR_IS: "error", "galat";
    TIME_IS: "time", "waktu";
    QUARTILES: "quartiles", "kuartil";
    MEMORY_IS: "memory", "memori";
    ERROR_FALLS: "error", "galat";
    TIME_GROWS: "time", "waktu";
    NO_LAW: "no clean law", "tidak ada hukum yang jelas";
    CLICK_OPENS_IT: "A click opens its picture and its run.", "Klik membuka gambar dan jalannya.";
    MEASURED_AGAIN_BY: "It draws no picture. Measured again, with a row of its own in the table, by", "Tidak menghasilkan gambar. Diukur lagi, dengan baris tersendiri di tabel, oleh";
    REFERENCE: "Reference", "Acuan";
    PARETO: "Ringed, on the grey line: the Pareto front. Bars: quartiles.", "Berlingkar, pada garis abu-abu: front Pareto. Batang: kuartil.";

    TEXT_SIZE: "Text size", "Ukuran teks";

    AT_THE_START_NAME: "first step", "langkah pertama";
    PREVIOUS_SCOPE: "previous scope", "lingkup sebelumnya";
    ONE_BACK: "one event back", "satu kejadian mundur";
    PLAY: "play or pause", "putar atau jeda";
    ONE_ON: "one event on", "satu kejadian maju";
    NEXT_SCOPE: "next scope", "lingkup berikutnya";
    SLOWER: "slower", "lebih lambat";
    FASTER: "faster", "lebih cepat";

    STEP: "step", "langkah";
    OF: "of", "dari";
    STEPS_A_SECOND: "steps/s", "langkah/dtk";
    LOOP: "loop", "ulang";
    LOOP_OFF: "loop off", "tanpa ulang";
    LOOP_FROM_HERE: "from this step", "dari langkah ini";
    LOOP_TO_HERE: "to this step", "sampai langkah ini";
    RUN_TO: "run to", "lompat ke";
    NEXT_OF_THIS_KIND: "next of this kind", "berikutnya yang sejenis";
    SEARCH: "search", "cari";
    SEARCH_HINT: "EdgeInterpolated y=15", "EdgeInterpolated y=15";
    BREAKPOINT: "breakpoint", "titik henti";
    TRUNCATED: "Only the beginning of this run fits in memory; the picture is whole all the same.", "Hanya awal dari proses ini yang muat di memori; gambarnya tetap utuh.";

    MAKING_THE_PICTURE: "whole picture:", "seluruh gambar:";
    UNSAID: "With these values, some of what this lesson explains does not happen.", "Dengan nilai-nilai ini, sebagian dari yang dijelaskan pelajaran ini tidak terjadi.";
    PUT_BACK: "Start again with the lesson's own values", "Mulai lagi dengan nilai-nilai pelajaran";

    SLIDE: "As on the slide", "Seperti pada salindia";
    LAST_SAID: "Said before, at step", "Sebelumnya, pada langkah";
    NEXT_SAID: "next explained step", "langkah berikut yang dijelaskan";
    OTHER_FOCUS: "You look at another part than the lesson does.", "Anda melihat bagian lain daripada pelajaran.";
    BACK_TO_LESSON: "Back to the lesson", "Kembali ke pelajaran";

    BEFORE_YOU_GO_ON: "Before you go on", "Sebelum melanjutkan";
    CHECK: "Check", "Periksa";
    SKIP: "skip", "lewati";
    YOUR_ANSWER: "Your answer", "Jawaban Anda";
    CLICK_A_PIXEL: "Click the pixel in the image.", "Klik piksel itu pada gambar.";
    RIGHT: "Right.", "Benar.";
    WRONG: "Not quite.", "Belum tepat.";
    SKIPPED: "Skipped.", "Dilewati.";
    THE_ANSWER_IS: "The answer is", "Jawabannya";
    SHOW_THE_STEP: "show the step", "tunjukkan langkahnya";

    IMAGE: "Image", "Gambar";
    SCAN_LINE: "Scan line", "Garis scan";
    ACTIVE_EDGES: "Active edges", "Sisi aktif";
    VERTEX: "Vertex", "Titik sudut";
    LEFT_OUT: "Left out: not needed here", "Ditinggalkan: tidak diperlukan di sini";
    LEFT_OUT_ABOUT: "The scene needs none of this, so it is not done. Tick a line to have it done all the same: nothing changes but the steps and the time.", "Adegan ini tidak memerlukannya, maka tidak dikerjakan. Centang satu baris agar tetap dikerjakan: tidak ada yang berubah selain langkah dan waktunya.";
    NOTHING_LEFT_OUT: "Nothing: this way to draw the scene needs all that it does.", "Tidak ada: cara menggambar adegan ini memerlukan semua yang dikerjakannya.";
    IS_NEEDED: "That is needed here, or not part of this method.", "Itu diperlukan di sini, atau bukan bagian metode ini.";
    TIMES_MEASURED: "measuring …", "mengukur …";
    TIMES_NONE: "too slow to be timed here; `lightwalk needs` measures it", "terlalu lama untuk diukur di sini; `lightwalk needs` mengukurnya";
    TIME_WITHOUT: "left out:", "ditinggalkan:";
    TIME_WITH: "done all the same:", "tetap dikerjakan:";
    TIME_TIE: "no difference beyond noise", "tidak ada beda di luar derau";
    SHARE_AS_LEFT_OUT_ONLY: "The steps differ from the lesson's while something is done that is not needed.", "Langkahnya berbeda dari pelajaran selama sesuatu yang tidak diperlukan dikerjakan.";
    UNSAID_ANYWAY: "With that done all the same, the lesson does not find its steps.", "Dengan hal itu tetap dikerjakan, pelajaran tidak menemukan langkah-langkahnya.";
    LEAVE_OUT_AGAIN: "Start again with it left out", "Mulai lagi tanpa hal itu";
    RAY_TREE: "Ray tree", "Pohon sinar";
    VECTORS: "Vectors at the point", "Vektor di titik ini";
    RADIOSITY: "Radiosity, patch by patch", "Radiositas, patch demi patch";
    FORM_FACTOR: "Form factor", "Faktor bentuk";
    MATRIX: "Matrix of form factors", "Matriks faktor bentuk";
    CONVERGENCE: "Convergence", "Konvergensi";
    RACE: "Solvers side by side", "Para penyelesai berdampingan";
    COMPARISON: "Methods side by side", "Metode berdampingan";
    DIFFERENCE: "Differences", "Perbedaan";
    PROFILE: "Along the scan line", "Sepanjang garis scan";
    SMOOTH: "smooth", "halus";
    SMOOTH_ROOM: "interpolate the light between the corners of patches", "interpolasikan cahaya antara sudut-sudut patch";
    ILLUMINATION: "Terms, and the slide's factor", "Suku, dan faktor salindia";
    RAYS: "Rays in the scene", "Sinar di dalam adegan";
    TREE_FIT: "fit", "pas";
    WHOLE_TREE: "show the whole tree", "tampilkan seluruh pohon";
    LARGER_TREE: "larger tree", "perbesar pohon";
    SMALLER_TREE: "smaller tree", "perkecil pohon";
    TREE_AS_IT_IS: "The tree is already shown that way.", "Pohon sudah tampil demikian.";
    INSPECTOR: "Inspector", "Inspektur";
    CODE: "Code", "Kode";
    FORMULA: "Formula", "Rumus";
    TIME_LINE: "Time line", "Garis waktu";
    CLICK_A_ROW: "click a row to light it up", "klik baris untuk menyorotnya";

    DRAG_THE_LIGHT: "drag to move the light", "seret untuk memindahkan cahaya";
    DRAG_THE_EYE: "drag to move the eye", "seret untuk memindahkan mata";
    PARAMETERS: "Parameters", "Parameter";
    PUT_BACK_ALL: "lesson's values", "nilai pelajaran";
    LIGHT: "light", "cahaya";
    EYE: "eye", "mata";
    AS_A_NUMBER: "as a number", "sebagai angka";
    DISTANCE: "distance", "jarak";
    FROM_THE_TARGET: "from what the camera looks at", "dari yang dilihat kamera";
    DIVISIONS: "divisions", "pembagian";

    LINE: "line", "garis";
    POLYGON: "polygon", "poligon";
    PIXEL: "pixel", "piksel";
    FRAME: "whole picture", "seluruh gambar";
    FOCUS_ON: "Look at", "Lihat";
    THE_LESSONS_PART: "the lesson's part", "bagian pelajaran";

    AT_THE_START: "This is the first step.", "Ini langkah pertama.";
    AT_THE_END: "This is the last step.", "Ini langkah terakhir.";
    NO_SCOPE_AHEAD: "No further scope opens behind this step.", "Tidak ada lingkup lagi sesudah langkah ini.";
    NO_SCOPE_BEFORE: "No scope opens before this step.", "Tidak ada lingkup sebelum langkah ini.";
    NOTHING_AROUND: "This step lies in no scope that could be left.", "Langkah ini tidak berada di dalam lingkup.";
    NOTHING_NARRATED_AHEAD: "Nothing more is explained behind this step.", "Tidak ada penjelasan lagi sesudah langkah ini.";
    NOTHING_NARRATED_BEFORE: "Nothing is explained before this step.", "Tidak ada penjelasan sebelum langkah ini.";
    ANSWER_FIRST: "Answer the question first, or skip it.", "Jawab dahulu pertanyaannya, atau lewati.";
    NO_QUESTION: "No question waits at this step.", "Tidak ada pertanyaan pada langkah ini.";
    NOT_A_NUMBER: "That is no number; write for example 0.52.", "Itu bukan angka; tulis misalnya 0.52.";
    NOT_FOUND: "No step matches.", "Tidak ada langkah yang cocok.";
    FASTEST: "This is the fastest.", "Ini yang tercepat.";
    SLOWEST: "This is the slowest.", "Ini yang paling lambat.";
    NO_LOOP: "No loop is set; [ and ] set one.", "Belum ada ulangan; [ dan ] menentukannya.";
    NOTHING_UNDER_POINTER: "Point at a pixel, a scan line or a polygon first.", "Arahkan dahulu ke piksel, garis scan, atau poligon.";
    NOTHING_DRAWN_THERE: "No polygon is seen at that pixel.", "Tidak ada poligon pada piksel itu.";
    OUTSIDE: "That lies outside the picture.", "Itu di luar gambar.";
    LARGEST: "The text is as large as it gets.", "Teks sudah terbesar.";
    SMALLEST: "The text is as small as it gets.", "Teks sudah terkecil.";
    NO_SUCH_LESSON: "There is no such lesson.", "Tidak ada pelajaran itu.";
    STAYS: "The lesson keeps this as it is.", "Pelajaran ini membiarkannya seperti adanya.";
    STILL_MEASURING: "A study is being measured; call it off first.", "Sebuah studi sedang diukur; batalkan dahulu.";
    NOTHING_IS_MEASURED: "Nothing is being measured.", "Tidak ada yang sedang diukur.";
    NO_SUCH_STUDY: "There is no such study.", "Tidak ada studi itu.";
    NO_SUCH_POINT: "There is no such point.", "Tidak ada titik itu.";
    SHARE_NO_STUDY: "A point of a study can only be opened from the study.", "Titik sebuah studi hanya dapat dibuka dari studinya.";
    TOO_FAR: "That is too far away.", "Itu terlalu jauh.";
    NO_VIEW: "From there, what is up in the picture would not be known.", "Dari sana tidak diketahui mana yang atas pada gambar.";
    OUT_OF_RANGE: "That value cannot be had.", "Nilai itu tidak diperbolehkan.";
    SHARE_UNCHANGED_ONLY: "A parameter was changed: r puts it back, and then this step can be shared.", "Sebuah parameter diubah: r mengembalikannya, lalu langkah ini dapat dibagikan.";
    SHARE_LESSON_ONLY: "Only steps of the lesson itself can be shared; r leads back to it.", "Hanya langkah pelajaran yang dapat dibagikan; r kembali ke pelajaran.";
}

/// What is said where the picture of a study's point is opened, by language.
pub fn said_of_a_point(point: &Point) -> [String; 2] {
    let time = report::seconds(point.seconds.median);
    let error = point.errors.map(|errors| report::error(errors.rms));
    let [en, id] = match error {
        Some(error) => [
            format!("an rms error of {error} in {time}"),
            format!("galat rms {error} dalam {time}"),
        ],
        None => [
            format!("a picture in {time}"),
            format!("satu gambar dalam {time}"),
        ],
    };
    let setting = &point.setting;
    [
        format!(
            "A point of a study: {setting} came to {en} on one thread. Here is the run behind it; the list of lessons leads back, and the menu to the study."
        ),
        format!(
            "Sebuah titik studi: {setting} mencapai {id} pada satu utas. Inilah jalannya; daftar pelajaran membawa kembali, dan menu membuka studi."
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_there_in_both_languages() {
        for (name, strings) in ALL {
            assert!(!strings.en.is_empty() && !strings.id.is_empty(), "{name}");
        }
    }
}
