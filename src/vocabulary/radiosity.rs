//! The solvers of radiosity.

use super::Declared;
use super::entry::{Formula, When, entry, if_finite, if_recorded, is, only};
use crate::algorithms::radiosity::{Event, SolverEvent as S};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
    };
    Event { recorded: S::Enclosure { patches }, solver } => "Room" at "start" scope "scope-enclosure"
        {
            "n" = patches,
        }
        [
            entry("event-room", &[is("B_i = E_i + ρ_i Σ_j F_i_j B_j")]),
        ];
    Event { recorded: S::RoomDone, solver } => "RoomDone" at "start"
        {
        }
        [
            entry("event-room-done", &[]),
        ];
    Event { recorded: S::Channel { channel }, solver } => "Channel" at "start" number "channel" scope "scope-channel"
        {
            "channel" = channel,
        }
        [
            entry("event-channel", &[]),
        ];
    Event { recorded: S::ChannelLeftOut { channel, why, like }, solver } => "ChannelLeftOut" at "start"
        {
            "channel" = channel,
            "why" = why,
            "like" = like,
        }
        [
            only(When::Recorded("like"), "event-channel-left-out-like-another", &[]),
            entry("event-channel-left-out-dark", &[]),
        ];
    Event { recorded: S::ChannelDone { channel }, solver } => "ChannelDone" at "start"
        {
            "channel" = channel,
        }
        [
            entry("event-channel-done", &[]),
        ];
    Event { recorded: S::System { patches, gain }, solver } => "System" at "start" scope "scope-system"
        {
            "solver" = solver.name(),
            "n" = patches,
            "gain" = gain,
        }
        [
            entry(
                "event-system",
                &[
                    is("(I − ρF) B = E"),
                    if_recorded("gain", "{μ=gain} = max_i ρ_i Σ_j F_i_j"),
                    ],
            ),
        ];
    Event { recorded: S::Started { i, b, unshot }, solver } => "Started" at "started"
        {
            "i" = i,
            "B_i" = b,
            "unshot_i" = unshot,
        }
        [
            entry("event-started", &[is("{B_i}"), is("{r_i=unshot_i}")]),
        ];
    Event { recorded: S::Iteration { k }, solver } => "Iteration" at "iteration" number "k" scope "scope-iteration"
        {
            "k" = k,
        }
        [
            entry("event-iteration", &[]),
        ];
    Event { recorded: S::Weighted { omega }, solver } => "Weighted" at "weight"
        {
            "omega" = omega,
        }
        [
            only(
                When::Is("solver", "over-relaxation"),
                "event-weighted-over-relaxation",
                &[is("{omega} = [2; 1 + √(1 − {μ=gain}^2)]")],
            ),
            only(When::NotPositive("k"), "event-weighted-first", &[is("{omega}")]),
            entry("event-weighted-chebyshev", &[is("{omega} = [1; 1 − {μ=gain}^2 ω′ / 4]")]),
        ];
    Event { recorded: S::StepLengths { alpha, beta }, solver } => "StepLengths" at "step-lengths"
        {
            "alpha" = alpha,
            "beta" = beta,
        }
        [
            entry(
                "event-step-lengths",
                &[
                    is("{alpha} = [δ; p · S p]"),
                    is("{beta} = [s · M^−^1 s; δ]"),
                    ],
            ),
        ];
    Event { recorded: S::Gathering { i, e_i, rho_i, b_old }, solver } => "Gathering" at "gathering" number "i" scope "scope-patch"
        {
            "i" = i,
            "E_i" = e_i,
            "rho_i" = rho_i,
            "B_old" = b_old,
        }
        [
            entry("event-gathering", &[is("{E_i}"), is("{rho_i}"), is("{B_old}")]),
        ];
    Event { recorded: S::Exchanged { j, f_ij, b_j, product, sum }, solver } => "Exchanged" at "exchange"
        {
            "j" = j,
            "F_ij" = f_ij,
            "B_j" = b_j,
            "product" = product,
            "sum" = sum,
        }
        [
            entry("event-exchanged", &[is("{sum} = sum′ + {F_ij} · {B_j}")]),
        ];
    Event { recorded: S::Gathered { i, b_new, change }, solver } => "Gathered" at "gathered"
        {
            "i" = i,
            "B_i" = b_new,
            "DeltaB" = change,
        }
        [
            only(
                When::Recorded("omega"),
                "event-gathered-relaxed",
                &[
                    if_recorded(
                    "sum",
                    "{B_i} = {B_old} + {omega} ({E_i} + {rho_i} · {Σ_j F_i_j B_j=sum} − {B_old})",
                    ),
                    CHANGE,
                    ],
            ),
            entry(
                "event-gathered",
                &[
                    if_recorded("sum", "{B_i} = {E_i} + {rho_i} · {Σ_j F_i_j B_j=sum}"),
                    CHANGE,
                    ],
            ),
        ];
    Event { recorded: S::Ambient { ambient }, solver } => "Ambient" at "ambient"
        {
            "ambient" = ambient,
        }
        [
            only(
                When::Recorded("ambient"),
                "event-ambient-radiosity",
                &[is("{ambient} = [⟨ρ⟩ ⟨ΔB⟩; 1 − ⟨ρ⟩]")],
            ),
        ];
    Event { recorded: S::Shooting { i, unshot, shot, a_i }, solver } => "Shooting" at "shooting" number "i" scope "scope-patch"
        {
            "i" = i,
            "unshot_i" = unshot,
            "shot" = shot,
            "A_i" = a_i,
        }
        [
            only(
                When::Recorded("ambient"),
                "event-overshooting",
                &[is("{shot} = {ΔB_i=unshot_i} + {ambient}"), is("{A_i}")],
            ),
            entry("event-shooting", &[is("{ΔB_i=unshot_i}"), is("{A_i}")]),
        ];
    Event { recorded: S::Received { j, f_ji, rho_j, delta, b_j, unshot_j }, solver } => "Received" at "received"
        {
            "j" = j,
            "F_ji" = f_ji,
            "rho_j" = rho_j,
            "DeltaB" = delta,
            "B_j" = b_j,
            "unshot_j" = unshot_j,
        }
        [
            entry(
                "event-received",
                &[
                    is("{F_ji} = F_i_j A_i / A_j"),
                    is("{ΔRad=DeltaB} = {rho_j} · {F_ji} · {ΔB_i=shot}"),
                    is("{ΔB_j=unshot_j} = ΔB_j′ + {ΔRad=DeltaB}"),
                    ],
            ),
        ];
    Event { recorded: S::ShotDone { i, b_i, unshot }, solver } => "ShotDone" at "shot"
        {
            "i" = i,
            "B_i" = b_i,
            "unshot_i" = unshot,
        }
        [
            entry("event-shot-done", &[is("{B_i} = B_i′ + {shot}"), is("{ΔB_i=unshot_i}")]),
        ];
    Event { recorded: S::Updated { i, b_old, b_new }, solver } => "Updated" at "updated"
        {
            "i" = i,
            "B_old" = b_old,
            "B_i" = b_new,
        }
        [
            only(
                When::Is("solver", "chebyshev"),
                "event-updated-chebyshev",
                &[is("{B_i} = B″_i + {omega} (γ r_i + {B_old} − B″_i)")],
            ),
            only(
                When::Is("solver", "direct"),
                "event-updated-direct",
                &[is("{B_i} = {B_old} + d_i")],
            ),
            entry("event-updated-along-direction", &[is("{B_i} = {B_old} + α p_i")]),
        ];
    Event { recorded: S::IterationDone { residual, error_bound }, solver } => "IterationDone" at "iteration"
        {
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry("event-iteration-done", RESIDUAL),
        ];
    Event { recorded: S::Converged { iterations, residual, error_bound }, solver } => "Converged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry("event-converged", RESIDUAL),
        ];
    Event { recorded: S::NotConverged { iterations, residual }, solver } => "NotConverged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
        }
        [
            entry("event-not-converged", &[is(RELATIVE)]),
        ];
}

const CHANGE: Formula = is("{ΔB=DeltaB} = {B_i} − {B_old}");
const RESIDUAL: &[Formula] = &[
    is(RELATIVE),
    if_finite("error_bound", "{ε_B=error_bound} = [‖r‖_∞; 1 − {μ=gain}]"),
];
const RELATIVE: &str = "{residual} = [‖E − (I − ρF) B‖; ‖E‖]";

/// A bound on the error, where one is known.
struct Bound(Option<f64>);

impl super::declare::Recorded for Bound {
    fn push(self, name: &'static str, fields: &mut Fields) {
        match self.0 {
            Some(bound) => fields.push(name, bound),
            None => fields.push(name, "unknown"),
        };
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        self.solver.listing().line(self.label())
    }

    fn holds_on(&self) -> bool {
        !matches!(
            self.recorded,
            S::Started { .. }
                | S::Exchanged { .. }
                | S::Received { .. }
                | S::Updated { .. }
                | S::ChannelLeftOut { .. }
        )
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
