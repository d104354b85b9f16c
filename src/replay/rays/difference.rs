//! Where the trees of two pixels differ first, in the order in which their rays are traced.

use super::{CurrentBranch, Outcome, State};
use crate::algorithms::ray_tree::{End, RayKind};
use crate::algorithms::visible::Intersection;
use crate::color::Rgb;

/// The first difference: what one tree has, and what the other has in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Of each tree the ray that differs; where a branch has none, the ray that it comes from.
    pub rays: [usize; 2],
    pub what: Differs,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Differs {
    /// Kinds of the ray.
    Kind([RayKind; 2]),
    /// What the ray meets first.
    Met([Intersection; 2]),
    /// Coefficients of branches of that kind.
    Coefficient(RayKind, [Rgb; 2]),
    /// Why a branch of that kind ends; none where it goes on.
    End(RayKind, [Option<End>; 2]),
}

/// What is still to be compared.
enum Pair {
    Rays([usize; 2]),
    /// Of those rays, on one side of the surface.
    Branches([usize; 2], usize),
}

/// Compares what both trees have; what one has not come to yet is no difference.
pub fn first_difference(trees: [&State; 2]) -> Option<Difference> {
    let mut pairs = vec![Pair::Rays([0, 0])];
    while let Some(pair) = pairs.pop() {
        match pair {
            Pair::Rays(rays) => {
                let [one, other] = [0, 1].map(|tree| trees[tree].rays.get(rays[tree]));
                let (one, other) = one.zip(other)?;
                let (Some(met), Some(other_met)) = (one.met, other.met) else {
                    continue;
                };
                if thing(met) != thing(other_met) {
                    let what = Differs::Met([met, other_met]);
                    return Some(Difference { rays, what });
                }
                // The reflected branch is compared first.
                pairs.extend([1, 0].map(|side| Pair::Branches(rays, side)));
            }
            Pair::Branches(parents, side) => {
                let branch = |tree: usize| trees[tree].rays.get(parents[tree])?.branches[side];
                let (Some(one), Some(other)) = (branch(0), branch(1)) else {
                    continue;
                };
                let branches = [one, other];
                let child = |tree: usize| match branches[tree].outcome {
                    Outcome::Ray(index) => index,
                    Outcome::Open | Outcome::Ended(_) => parents[tree],
                };
                let rays = [child(0), child(1)];
                if let Some(what) = between(branches) {
                    return Some(Difference { rays, what });
                }
                if let [Outcome::Ray(_), Outcome::Ray(_)] = branches.map(|branch| branch.outcome) {
                    pairs.push(Pair::Rays(rays));
                }
            }
        }
    }
    None
}

/// What a ray meets, wherever it does.
fn thing(met: Intersection) -> (bool, Option<u32>) {
    match met {
        Intersection::Nothing => (false, None),
        Intersection::Light { light, .. } => (true, Some(light)),
        Intersection::Object(hit) => (false, Some(hit.object)),
    }
}

/// How two branches of the same side differ by themselves.
fn between([one, other]: [CurrentBranch; 2]) -> Option<Differs> {
    if one.kind != other.kind {
        return Some(Differs::Kind([one.kind, other.kind]));
    }
    let end = |branch: CurrentBranch| match branch.outcome {
        Outcome::Open => None,
        Outcome::Ray(_) => Some(None),
        Outcome::Ended(end) => Some(Some(end)),
    };
    if let (Some(end), Some(other_end)) = (end(one), end(other))
        && end != other_end
    {
        return Some(Differs::End(one.kind, [end, other_end]));
    }
    let [a, b] = [one, other].map(|branch| branch.branch.map(|sent| sent.coefficient));
    let (a, b) = a.zip(b)?;
    (a != b).then_some(Differs::Coefficient(one.kind, [a, b]))
}
