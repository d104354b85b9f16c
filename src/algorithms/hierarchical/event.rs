//! What happens in hierarchical radiosity, and its pseudocode.

use crate::color::Rgb;
use crate::record::Listing;

/// Elements and links go by their numbers. The field names are those of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens the run, closed by `HierarchyDone`. `flux` is Σ A E, in the channel that has the most.
    Hierarchy {
        roots: u32,
        patches: u32,
        flux: f64,
    },
    HierarchyDone {
        elements: u32,
        leaves: u32,
        links: u32,
    },
    /// Opens a pass, counted from 0, closed by `PassDone`. The first one links by form factor alone.
    Pass {
        pass: u32,
        allowed: f64,
    },
    PassDone {
        elements: u32,
        links: u32,
    },
    /// Opens the refinement of a pair, closed by `Linked` or `Parted`. `link` is the one that it had.
    Refining {
        p: u32,
        q: u32,
        link: Option<u32>,
        areas: [f64; 2],
        f_pq: f64,
        /// The largest of ρ_p B_q and ρ_q B_p in any channel; none in the first pass.
        rho_b: Option<f64>,
    },
    /// No light passes between the two.
    Unlinked {
        p: u32,
        q: u32,
    },
    /// An element has got children, numbered from `first` on.
    Divided {
        divided: u32,
        first: u32,
        parts: u32,
        level: u32,
    },
    /// Closes `Refining`: F_pq, of which the share `visible` passes what stands between.
    Linked {
        link: u32,
        f_pq: f64,
        visible: f64,
    },
    /// Closes `Refining`: the pair goes to the children of `divided`.
    Parted {
        divided: u32,
    },
    /// Opens one gathering over all links, and the push–pull after it; counted from 0 over all passes, closed by `SweepDone`.
    Sweep {
        sweep: u32,
    },
    /// The largest change of the radiosity of a leaf, as a share of the largest radiosity.
    SweepDone {
        change: f64,
    },
    /// Opens the gathering of an element, closed by `LinksGathered`.
    LinksGathering {
        p: u32,
        links: u32,
        rho_p: Rgb,
    },
    /// What comes over one link, and the sum so far.
    LinkGathered {
        q: u32,
        f_pq: f64,
        b_q: Rgb,
        sum: Rgb,
    },
    LinksGathered {
        b_g: Rgb,
    },
    /// Opens the push–pull of an element: B_down comes from above. Closed by `PulledUp`, or `LeafLit` where it has no children.
    PushedDown {
        p: u32,
        b_g: Rgb,
        b_down: Rgb,
    },
    /// What a child brings to the mean of its parent.
    ChildPulled {
        child: u32,
        share: f64,
        b_q: Rgb,
        sum: Rgb,
    },
    PulledUp {
        b_p: Rgb,
    },
    LeafLit {
        b_p: Rgb,
        e_p: Rgb,
    },
}

const _: () = assert!(size_of::<Event>() <= 64);

pub static PSEUDOCODE: Listing = Listing {
    name: "hierarchical radiosity",
    lines: &[
        ("hierarchy", "SolveSystem(ε)"),
        ("pass", "  {for-each-tolerance-from-coarse-to-fine}"),
        ("", "    {refine-each-pair-or-link-above-it}"),
        ("sweep", "    {repeat-until-nothing-changes}"),
        ("", "      GatherRad; PushPullRad"),
        ("refine", "Refine(p, q, ε)"),
        ("unlinked", "  {if-no-light-passes-return}"),
        ("linked", "  {if-error-small-enough-link-p-and-q}"),
        ("divided", "  {else-divide-the-larger-one}"),
        ("parted", "  {for-each-child-refine-with-the-other}"),
        ("gather", "GatherRad(p)"),
        (
            "link-gathered",
            "  {for-each-link-of-p} B_g ← B_g + ρ_p F_pq B_q",
        ),
        ("gathered", "  {and-so-for-the-children-of-p}"),
        ("push", "PushPullRad(p, B_down)"),
        ("leaf", "  {if-p-is-a-leaf} B_p ← E_p + B_g + B_down"),
        (
            "pull",
            "  {else-of-p} B_p ← Σ A_c / A_p PushPullRad(c, B_g + B_down)",
        ),
    ],
};
