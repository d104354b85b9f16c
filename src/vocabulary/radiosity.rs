//! The solvers of radiosity.

use super::Declared;
use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::radiosity::{Event, SolverEvent as S};
use crate::language::Message;
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
    };
    Event { recorded: S::Enclosure { patches }, .. } => "Room" at "start" scope "scope-enclosure"
        {
            "n" = patches,
        }
        [
            entry(
                "event-room",
                &[is("'B_i' = 'E_i' + 'ρ_i Σ_j F_{ij} B_j'").unevaluated(UNKNOWNS)],
            ),
        ];
    Event { recorded: S::RoomDone, .. } => "RoomDone" at "start"
        {
        }
        [
            entry("event-room-done", &[]),
        ];
    Event { recorded: S::Channel { channel }, .. } => "Channel" at "start" number "channel" scope "scope-channel"
        {
            "channel" = channel,
        }
        [
            entry("event-channel", &[]),
        ];
    Event { recorded: S::ChannelLeftOut { channel, why, like }, .. } => "ChannelLeftOut" at "start"
        {
            "channel" = channel,
            "why" = why,
            "like" = like,
        }
        [
            only(When::Recorded("like"), "event-channel-left-out-like-another", &[]),
            entry("event-channel-left-out-dark", &[]),
        ];
    Event { recorded: S::ChannelDone { channel }, .. } => "ChannelDone" at "start"
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
                    is("('I' − 'ρF') 'B' = 'E'").unevaluated(UNKNOWNS),
                    is("{μ=gain} = 'max_i ρ_i Σ_j F_{ij}'")
                        .unevaluated("over all rows of the matrix")
                        .when(When::Recorded("gain")),
                    ],
            ),
        ];
    Event { recorded: S::Started { i, b, unshot }, .. } => "Started" at "started"
        {
            "i" = i,
            "B_i" = b,
            "unshot_i" = unshot,
        }
        [
            entry("event-started", &[is("B_i"), is("{r_i=unshot_i}")]),
        ];
    Event { recorded: S::Iteration { k }, .. } => "Iteration" at "iteration" number "k" scope "scope-iteration"
        {
            "k" = k,
        }
        [
            entry("event-iteration", &[]),
        ];
    Event { recorded: S::Weighted { omega }, .. } => "Weighted" at "weight"
        {
            "omega" = omega,
        }
        [
            only(
                When::Is("solver", "over-relaxation"),
                "event-weighted-over-relaxation",
                &[
                    is("omega = [2; 1 + √(1 − {μ=gain}^2)]").when(When::Not(&MAY_GAIN_LIGHT)),
                    is("omega = 1").when(MAY_GAIN_LIGHT),
                    ],
            ),
            only(When::NotPositive("k"), "event-weighted-first", &[is("omega = 1")]),
            entry(
                "event-weighted-chebyshev",
                &[
                    is("omega = [1; 1 − {μ=gain}^2 · 2 / 4]").when(SECOND),
                    is("omega = [1; 1 − {μ=gain}^2 {ω_{old}=omega<<k-1} / 4]").when(When::Not(&SECOND)),
                ],
            ),
        ];
    Event { recorded: S::StepLengths { alpha, beta }, .. } => "StepLengths" at "step-lengths"
        {
            "alpha" = alpha,
            "beta" = beta,
        }
        [
            entry(
                "event-step-lengths",
                &[
                    is("alpha = ['δ'; 'p · S p']").unevaluated(ALL_PATCHES),
                    is("beta = ['s · M^{−1} s'; 'δ']").unevaluated(ALL_PATCHES),
                    ],
            ),
        ];
    Event { recorded: S::Gathering { i, e_i, rho_i, b_old }, .. } => "Gathering" at "gathering" number "i" scope "scope-patch"
        {
            "i" = i,
            "E_i" = e_i,
            "rho_i" = rho_i,
            "B_old" = b_old,
        }
        [
            entry("event-gathering", &[is("E_i"), is("rho_i"), is("B_old")]),
        ];
    Event { recorded: S::Exchanged { j, f_ij, b_j, product, sum }, .. } => "Exchanged" at "exchange"
        {
            "j" = j,
            "F_ij" = f_ij,
            "B_j" = b_j,
            "product" = product,
            "sum" = sum,
        }
        [
            entry(
                "event-exchanged",
                &[
                    is("product = F_ij · B_j"),
                    is("sum = {sum_{old}=sum<0} + product"),
                    is("F_ij = matrix_F_ij"),
                    is("{M_{ij}=entry} := 1 − rho_i · F_ij").when(SAME).noted(ROW),
                    is("{M_{ij}=entry} := −rho_i · F_ij").when(When::Not(&SAME)).noted(ROW),
                    ],
            ),
        ];
    Event { recorded: S::Gathered { i, b_new, change }, .. } => "Gathered" at "gathered"
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
                    is("B_i = B_old + omega (E_i + rho_i · {Σ_j F_{ij} B_j=sum<} − B_old)")
                        .when(When::Recorded("sum")),
                    is("B_i = B_old + omega (E_i + rho_i 'Σ_j F_{ij} B_j' − B_old)")
                        .when(When::Unrecorded("sum"))
                        .unevaluated(UNFOLLOWED),
                    CHANGE,
                    ],
            ),
            entry(
                "event-gathered",
                &[
                    is("{Σ_j F_{ij} B_j=sum<} = Σ{*product}").when(When::Recorded("sum")),
                    is("B_i = E_i + rho_i · {Σ_j F_{ij} B_j=sum<}").when(When::Recorded("sum")),
                    is("B_i = E_i + rho_i 'Σ_j F_{ij} B_j'").when(When::Unrecorded("sum")).unevaluated(UNFOLLOWED),
                    CHANGE,
                    ],
            ),
        ];
    Event { recorded: S::Ambient { ambient }, .. } => "Ambient" at "ambient"
        {
            "ambient" = ambient,
        }
        [
            only(
                When::Recorded("ambient"),
                "event-ambient-radiosity",
                &[is("ambient = ['⟨ρ⟩ ⟨unshot⟩'; 1 − '⟨ρ⟩']").unevaluated(ALL_PATCHES)],
            ),
        ];
    Event { recorded: S::Shooting { i, unshot, shot, a_i }, .. } => "Shooting" at "shooting" number "i" scope "scope-patch"
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
                &[is("shot = unshot_i + ambient"), is("A_i = area_of_i")],
            ),
            entry("event-shooting", &[is("shot = unshot_i"), is("A_i = area_of_i")]),
        ];
    Event { recorded: S::Received { j, f_ji, rho_j, delta, b_j, unshot_j }, .. } => "Received" at "received"
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
                    is("F_ji = matrix_F_ij · A_i / area_of_j"),
                    is("{ΔB_j=DeltaB} = rho_j · F_ji · shot"),
                    // The patch that shoots has its unshot light no longer.
                    is("unshot_j = −ambient + {ΔB_j=DeltaB}")
                        .when(When::All(&[SAME, When::Recorded("ambient")])),
                    is("unshot_j = {ΔB_j=DeltaB}")
                        .when(When::All(&[SAME, When::Unrecorded("ambient")])),
                    is("unshot_j = {unshot_{j,old}=unshot_i<<i:j} + {ΔB_j=DeltaB}")
                        .when(When::All(&[When::Not(&SAME), FIRST])),
                    is("unshot_j = {unshot_{j,old}=unshot_j<<j,k-1|unshot_i<<i:j,k-1} + {ΔB_j=DeltaB}")
                        .when(When::All(&[When::Not(&SAME), When::Not(&FIRST)])),
                    ],
            ),
        ];
    Event { recorded: S::ShotDone { i, b_i, unshot }, .. } => "ShotDone" at "shot"
        {
            "i" = i,
            "B_i" = b_i,
            "unshot_i" = unshot,
        }
        [
            entry(
                "event-shot-done",
                &[
                    is("B_i = {B_{i,old}=B_i<<i} + shot").when(FIRST),
                    is("B_i = {B_{i,old}=B_j<<j:i,k-1|B_i<<i,k-1} + shot").when(When::Not(&FIRST)),
                    is("unshot_i = −ambient + 'ρ_i F_{ii} shot'")
                        .when(When::Recorded("ambient"))
                        .unevaluated(UNFOLLOWED),
                    is("unshot_i = 'ρ_i F_{ii} shot'")
                        .when(When::Unrecorded("ambient"))
                        .unevaluated(UNFOLLOWED),
                ],
            ),
        ];
    Event { recorded: S::Updated { i, b_old, b_new }, .. } => "Updated" at "updated"
        {
            "i" = i,
            "B_old" = b_old,
            "B_i" = b_new,
        }
        [
            only(
                When::Is("solver", "chebyshev"),
                "event-updated-chebyshev",
                &[is("B_i = 'B″_i' + omega ('γ r_i' + B_old − 'B″_i')")
                    .unevaluated("the residual of each patch is not recorded")],
            ),
            only(
                When::Is("solver", "direct"),
                "event-updated-direct",
                &[is("B_i = B_old + 'd_i'").unevaluated("d solves a whole system")],
            ),
            entry(
                "event-updated-along-direction",
                &[is("B_i = B_old + 'α p_i'").unevaluated("the direction p is not recorded")],
            ),
        ];
    Event { recorded: S::IterationDone { residual, error_bound }, .. } => "IterationDone" at "iteration"
        {
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry("event-iteration-done", RESIDUAL),
        ];
    Event { recorded: S::Converged { iterations, residual, error_bound }, .. } => "Converged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry("event-converged", RESIDUAL),
        ];
    Event { recorded: S::NotConverged { iterations, residual }, .. } => "NotConverged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
        }
        [
            entry("event-not-converged", &[RELATIVE]),
        ];
}

const CHANGE: Formula = is("DeltaB = B_i − B_old");
const RESIDUAL: &[Formula] = &[
    RELATIVE,
    is("{ε_B=error_bound} = ['‖r‖_∞'; 1 − {μ=gain}]")
        .unevaluated(ALL_PATCHES)
        .when(When::Finite("error_bound")),
];
const RELATIVE: Formula = is("residual = ['‖E − (I − ρF) B‖'; '‖E‖']").unevaluated(ALL_PATCHES);
const UNKNOWNS: &str = "the unknowns of a whole system";
const ALL_PATCHES: &str = "a sum over all patches, whose parts are not recorded";
const UNFOLLOWED: &str = "the exchanges of this patch are not recorded";
const ROW: Message = Message("note-row-of-the-system");
const FIRST: When = When::Equals("k", 0);
const SECOND: When = When::Equals("k", 1);
const SAME: When = When::Same("i", "j");
/// Young’s ω is then 1.
const MAY_GAIN_LIGHT: When = When::AtLeast("gain", 1.0);

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
