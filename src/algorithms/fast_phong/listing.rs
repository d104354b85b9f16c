//! The pseudocode of Fast Phong shading.

use crate::algorithms::shading::Shading;
use crate::record::Listing;
use crate::scene::Part;

pub static PSEUDOCODE: Listing = Listing {
    name: "Fast Phong",
    lines: &[
        ("polygon", "{for-each-polygon}"),
        ("vertex", "  {for-each-vertex-v-not-yet-met}"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("triangle", "  {for-each-triangle-of-it-about-its-middle}"),
        ("normal-series", "    N(x, y) ← N_0 + N_x·x + N_y·y"),
        (
            "expansion",
            "    V ← {toward-the-eye};  {turn-n-toward-v};  I ← k_a · A",
        ),
        ("light", "    {for-each-light}"),
        (
            "to-light",
            "      L ← {toward-the-light};  f_att ← 1/(a0 + a1·d + a2·d²)",
        ),
        (
            "highlight",
            "      H ← (L+V)/|L+V|   {or}   R ← 2(N·L)N − L",
        ),
        (
            "series",
            "      T_0 … T_5 ← {taylor-series-of-each-cosine-c}",
        ),
        ("edge-table", "    {build-the-edge-table}"),
        ("scan-line", "    {for-each-scan-line-y}"),
        ("edge", "      {for-each-active-edge}"),
        ("cut", "        x_4 ← {where-y-cuts-the-edge}"),
        ("span", "      {for-each-span-from-x-4-to-x-5}"),
        ("pixel", "        {for-each-pixel-x-p}"),
        ("depth", "          {if-nearer-than-the-depth-buffer}"),
        (
            "differences",
            "            {at-the-first-pixel-of-the-span} c, Δc, Δ²c ← T_0 … T_5",
        ),
        (
            "increments",
            "            {then-pixel-by-pixel} c ← c + Δc;  Δc ← Δc + Δ²c",
        ),
        (
            "sum",
            "            I_P ← I + Σ f_att · I_light · (k_d · max(0, c_d) + k_s · table(c_s))",
        ),
        ("color", "            pixel ← I_P"),
    ],
};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FastPhong {}

impl Shading for FastPhong {
    const NAME: &'static str = "fast-phong";
    const LISTING: &'static Listing = &PSEUDOCODE;
    /// Its series includes the highlight, whatever the material.
    const PARTS: &'static [Part] = &[Part::TextureCoordinates];
    /// Nothing is interpolated: the cosines follow from their series.
    type Recorded = ();
}
