//! The panel's words.

use crate::panels::strings::Words;

pub(super) const NO_RAY: Words = Words::new(
    "Once a ray is sent through a pixel, this panel draws the tree of all rays that make its colour. At this step there is none yet: step on.",
    "Begitu sebuah sinar dikirim lewat piksel, panel ini menggambar pohon semua sinar pembentuk warnanya. Pada langkah ini belum ada: lanjutkan.",
);
pub(super) const NO_RAYS: Words = Words::new(
    "This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing to see a pixel's ray tree.",
    "Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran ray casting atau ray tracing untuk melihat pohon sinar sebuah piksel.",
);
pub(super) const INSIDE: Words = Words::new("inside", "di dalam");
pub(super) const BACKGROUND: Words = Words::new("background", "latar belakang");
pub(super) const LEAVES: Words = Words::new("leaves the scene", "keluar dari adegan");
pub(super) const LEAVES_SHORT: Words = Words::new("leaves", "keluar");
pub(super) const LIGHT_MET: Words = Words::new("meets a light", "mengenai cahaya");
pub(super) const SEARCHING: Words = Words::new("searching …", "mencari …");
pub(super) const NOT_TRACED: Words = Words::new("not traced yet", "belum ditelusuri");
pub(super) const ASKED: Words = Words::new("asked for", "diminta");
pub(super) const NO_TRANSMITTED: Words = Words::new("no transmitted ray", "tanpa sinar bias");
pub(super) const DEPTH_REACHED: Words = Words::new("depth reached", "batas kedalaman");
pub(super) const NO_COEFFICIENT: Words = Words::new("no coefficient", "tanpa koefisien");
pub(super) const TIR: Words = Words::new("total internal reflection", "pantulan internal total");

pub(super) const RAY: Words = Words::new("ray", "sinar");
pub(super) const RAYS: Words = Words::new("rays", "sinar");
pub(super) const LEVEL: Words = Words::new("level", "tingkat");
pub(super) const OF: Words = Words::new("of", "dari");
pub(super) const HIDDEN: Words = Words::new("not shown", "tak tampak");

pub(super) const SHADOW_RAYS: Words = Words::new("Shadow rays at", "Sinar bayangan di");
pub(super) const LIGHTS: Words = Words::new("Lights at", "Cahaya di");
pub(super) const COMING_BACK: Words = Words::new("Coming back up", "Kembali ke atas");
pub(super) const BLOCKED: Words = Words::new("blocked", "terhalang");
pub(super) const BLOCKED_BY: Words = Words::new("blocked by", "terhalang");
pub(super) const CLEAR: Words = Words::new("clear", "bebas");
pub(super) const SO_FAR: Words = Words::new("so far", "sejauh ini");
pub(super) const NEAREST: Words = Words::new("nearest", "terdekat");
pub(super) const TESTED: Words = Words::new("tested", "diuji");
pub(super) const MISSED: Words = Words::new("missed", "meleset");
