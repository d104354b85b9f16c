//! Hierarchical radiosity.

use super::Declared;
use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::hierarchical::{Event, PSEUDOCODE};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
    };
    Event::Hierarchy { roots, patches, flux } => "Hierarchy" at "hierarchy" scope "scope-hierarchy"
        {
            "roots" = roots,
            "n" = patches,
            "pairs" = 0.5 * f64::from(patches) * (f64::from(patches) - 1.0),
            "flux" = flux,
        }
        [
            entry(
                "event-hierarchy",
                &[
                    is("pairs = n (n − 1) / 2"),
                    is("flux = 'Σ_p A_p E_p'").unevaluated("a sum over all roots"),
                ],
            ),
        ];
    Event::HierarchyDone { elements, leaves, links } => "HierarchyDone" at "hierarchy"
        {
            "elements" = elements,
            "leaves" = leaves,
            "links" = links,
        }
        [
            entry("event-hierarchy-done", &[is("{m=per_leaf} := links / leaves")]),
        ];
    Event::Pass { pass, allowed } => "Pass" at "pass" number "pass" scope "scope-pass"
        {
            "pass" = pass,
            "F_eps" = (pass == 0).then_some(allowed),
            "BFA_eps" = (pass > 0).then_some(allowed),
        }
        [
            only(When::Recorded("F_eps"), "event-pass-first", &[is("F_eps")]),
            entry("event-pass", &[is("BFA_eps")]),
        ];
    Event::PassDone { elements, links } => "PassDone" at "pass"
        {
            "elements" = elements,
            "links" = links,
        }
        [
            entry("event-pass-done", &[]),
        ];
    Event::Refining { p, q, link, areas, f_pq, rho_b } => "Refining" at "refine" number "p", "q" scope "scope-refining"
        {
            "p" = p,
            "q" = q,
            "link" = link,
            "A_p" = areas[0],
            "A_q" = areas[1],
            "F_pq" = f_pq,
            "F_qp" = f_pq * areas[0] / areas[1],
            "rho_B" = rho_b,
            "BFA" = rho_b.map(|rho_b| rho_b * f_pq * areas[0]),
        }
        [
            only(When::Unrecorded("BFA"), "event-refining-by-form-factor", &[RECIPROCITY]),
            entry("event-refining", &[RECIPROCITY, CARRIED]),
        ];
    Event::Unlinked { p, q } => "Unlinked" at "unlinked"
        {
            "p" = p,
            "q" = q,
        }
        [
            entry("event-unlinked", &[]),
        ];
    Event::Divided { divided, first, parts, level } => "Divided" at "divided"
        {
            "divided" = divided,
            "first" = first,
            "parts" = parts,
            "level" = level,
        }
        [
            entry("event-divided", &[]),
        ];
    Event::Linked { link, f_pq, visible } => "Linked" at "linked"
        {
            "link" = link,
            "V_pq" = visible,
            "F_link" = f_pq * visible,
        }
        [
            only(When::AtLeast("V_pq", 1.0), "event-linked", &[is("F_link = F_pq")]),
            entry("event-linked-partly", &[is("F_link = F_pq · V_pq")]),
        ];
    Event::Parted { divided } => "Parted" at "parted"
        {
            "divided" = divided,
        }
        [
            entry("event-parted", &[]),
        ];
    Event::Sweep { sweep } => "Sweep" at "sweep" number "sweep" scope "scope-sweep"
        {
            "sweep" = sweep,
        }
        [
            entry("event-sweep", &[]),
        ];
    Event::SweepDone { change } => "SweepDone" at "sweep"
        {
            "change" = change,
        }
        [
            entry(
                "event-sweep-done",
                &[is("change = ['max |ΔB|'; 'max B']").unevaluated("over all leaves and channels")],
            ),
        ];
    Event::LinksGathering { p, links, rho_p } => "LinksGathering" at "gather" number "p" scope "scope-gathering"
        {
            "p" = p,
            "links" = links,
            "rho_p" = rho_p,
        }
        [
            entry("event-links-gathering", &[is("rho_p")]),
        ];
    Event::LinkGathered { q, f_pq, b_q, sum } => "LinkGathered" at "link-gathered"
        {
            "q" = q,
            "F_link" = f_pq,
            "B_q" = b_q,
            "sum" = sum,
        }
        [
            entry("event-link-gathered", &[is("sum = {sum_{old}=sum<0} + F_link · B_q")]),
        ];
    Event::LinksGathered { b_g } => "LinksGathered" at "gathered"
        {
            "B_g" = b_g,
        }
        [
            entry("event-links-gathered", &[is("B_g = rho_p · {Σ F_{link} B_q=sum<}")]),
        ];
    Event::PushedDown { p, b_g, b_down } => "PushedDown" at "push" number "p" scope "scope-push-pull"
        {
            "p" = p,
            "B_g" = b_g,
            "B_down" = b_down,
        }
        [
            entry("event-pushed-down", &[is("B_g"), is("B_down")]),
        ];
    Event::ChildPulled { child, share, b_q, sum } => "ChildPulled" at "pull"
        {
            "child" = child,
            "share" = share,
            "B_c" = b_q,
            "sum" = sum,
        }
        [
            entry("event-child-pulled", &[is("sum = {sum_{old}=sum<0} + share · B_c")]),
        ];
    Event::PulledUp { b_p } => "PulledUp" at "pull"
        {
            "B_p" = b_p,
        }
        [
            entry("event-pulled-up", &[is("B_p = {Σ A_c B_c / A_p=sum<}")]),
        ];
    Event::LeafLit { b_p, e_p } => "LeafLit" at "leaf"
        {
            "E_p" = e_p,
            "B_p" = b_p,
        }
        [
            entry("event-leaf-lit", &[is("B_p = E_p + B_g + B_down")]),
        ];
}

const RECIPROCITY: Formula = is("F_qp = F_pq · A_p / A_q");
const CARRIED: Formula = is("BFA = rho_B · F_pq · A_p");

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        PSEUDOCODE.line(self.label())
    }

    fn holds_on(&self) -> bool {
        !matches!(
            self,
            Event::Unlinked { .. } | Event::LinkGathered { .. } | Event::ChildPulled { .. }
        )
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
