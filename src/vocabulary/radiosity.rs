//! The solvers of radiosity.

use super::Declared;
use super::entry::{Formula, When, entry, if_finite, if_recorded, is, only};
use crate::algorithms::radiosity::{
    Event, Solver, SolverEvent as S, chebyshev, conjugate_gradients, direct, gauss_seidel, jacobi,
    over_relaxation, shooting,
};
use crate::record::{self, Fields, Line, Listing};

vocabulary! {
    [] Event {
    };
    Event { recorded: S::Enclosure { patches }, solver } => "Room" at "start" scope ("enclosure", "ruang")
        {
            "n" = patches,
        }
        [
            entry(
                "The light of a room of {n} patches is to be found: one system of equations for each channel of the colour.",
                "Cahaya ruang dengan {n} patch akan dicari: satu sistem persamaan untuk tiap kanal warna.",
                &[is("B_i = E_i + ρ_i Σ_j F_i_j B_j")],
            ),
        ];
    Event { recorded: S::RoomDone, solver } => "RoomDone" at "start"
        {
        }
        [
            entry(
                "All channels are done: every patch has its radiosity.",
                "Semua kanal selesai: setiap patch mendapat radiositasnya.",
                &[],
            ),
        ];
    Event { recorded: S::Channel { channel }, solver } => "Channel" at "start" number "channel" scope ("channel", "kanal")
        {
            "channel" = channel,
        }
        [
            entry(
                "The channel {channel} begins: radiosity is monochrome, so each channel is solved by itself.",
                "Kanal {channel} dimulai: radiositas bersifat monokrom, jadi tiap kanal diselesaikan sendiri.",
                &[],
            ),
        ];
    Event { recorded: S::ChannelLeftOut { channel, why, like }, solver } => "ChannelLeftOut" at "start"
        {
            "channel" = channel,
            "why" = why,
            "like" = like,
        }
        [
            only(
                When::Recorded("like"),
                "The channel {channel} has the reflectances and emissions of the channel {like}: its solution serves both.",
                "Kanal {channel} memiliki reflektansi dan emisi yang sama dengan kanal {like}: solusinya dipakai bersama.",
                &[],
            ),
            entry(
                "In the channel {channel} nothing emits, so every radiosity is 0: there is nothing to solve.",
                "Pada kanal {channel} tidak ada yang memancar, jadi semua radiositas 0: tidak ada yang perlu diselesaikan.",
                &[],
            ),
        ];
    Event { recorded: S::ChannelDone { channel }, solver } => "ChannelDone" at "start"
        {
            "channel" = channel,
        }
        [
            entry(
                "The channel {channel} is done.",
                "Kanal {channel} selesai.",
                &[],
            ),
        ];
    Event { recorded: S::System { patches, gain }, solver } => "System" at "start" scope ("system", "sistem")
        {
            "solver" = solver.name(),
            "n" = patches,
            "gain" = gain,
        }
        [
            entry(
                "{n} equations for {n} radiosities, to be solved by {solver}. μ, the largest gain of a row, says how much of the light is reflected at most.",
                "{n} persamaan untuk {n} radiositas, diselesaikan dengan {solver}. μ, penguatan baris terbesar, menyatakan paling banyak berapa bagian cahaya yang dipantulkan.",
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
            entry(
                "Patch {i} before the iteration: its radiosity, and its part r_i of the residual.",
                "Patch {i} sebelum iterasi: radiositasnya, dan bagiannya r_i dari residu.",
                &[is("{B_i}"), is("{r_i=unshot_i}")],
            ),
        ];
    Event { recorded: S::Iteration { k }, solver } => "Iteration" at "iteration" number "k" scope ("iteration", "iterasi")
        {
            "k" = k,
        }
        [
            entry(
                "Iteration {k} begins.",
                "Iterasi {k} dimulai.",
                &[],
            ),
        ];
    Event { recorded: S::Weighted { omega }, solver } => "Weighted" at "weight"
        {
            "omega" = omega,
        }
        [
            only(
                When::Is("solver", "over-relaxation"),
                "Every patch goes ω times as far as it gathers, by Young’s ω for the bound μ.",
                "Setiap patch melangkah ω kali sejauh yang dikumpulkannya, dengan ω dari Young untuk batas μ.",
                &[is("{omega} = [2; 1 + √(1 − {μ=gain}^2)]")],
            ),
            only(
                When::NotPositive("k"),
                "The weight of the first iteration of Chebyshev is 1.",
                "Bobot iterasi Chebyshev yang pertama adalah 1.",
                &[is("{omega}")],
            ),
            entry(
                "The weight of this iteration of Chebyshev, from the weight ω′ before; in the second iteration 2 stands for ω′.",
                "Bobot iterasi Chebyshev ini, dari bobot ω′ sebelumnya; pada iterasi kedua ω′ diganti 2.",
                &[is("{omega} = [1; 1 − {μ=gain}^2 ω′ / 4]")],
            ),
        ];
    Event { recorded: S::StepLengths { alpha, beta }, solver } => "StepLengths" at "step-lengths"
        {
            "alpha" = alpha,
            "beta" = beta,
        }
        [
            entry(
                "The step lengths of conjugate gradients: α along the direction p, and β for the next direction.",
                "Panjang langkah gradien konjugat: α sepanjang arah p, dan β untuk arah berikutnya.",
                &[
                    is("{alpha} = [δ; p · S p]"),
                    is("{beta} = [s · M^−^1 s; δ]"),
                    ],
            ),
        ];
    Event { recorded: S::Gathering { i, e_i, rho_i, b_old }, solver } => "Gathering" at "gathering" number "i" scope ("patch", "patch")
        {
            "i" = i,
            "E_i" = e_i,
            "rho_i" = rho_i,
            "B_old" = b_old,
        }
        [
            entry(
                "Patch {i} gathers the light of all others: it emits E_i itself and reflects the share ρ_i of what arrives.",
                "Patch {i} mengumpulkan cahaya dari semua patch lain: ia memancarkan E_i sendiri dan memantulkan bagian ρ_i dari yang tiba.",
                &[is("{E_i}"), is("{rho_i}"), is("{B_old}")],
            ),
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
            entry(
                "Of the light that patch {i} gathers, patch {j} brings form factor times radiosity.",
                "Dari cahaya yang dikumpulkan patch {i}, patch {j} menyumbang faktor bentuk kali radiositas.",
                &[is("{sum} = sum′ + {F_ij} · {B_j}")],
            ),
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
                "Patch {i} has gathered, and goes ω times as far as from the old radiosity to what it gathered.",
                "Patch {i} selesai mengumpulkan, dan melangkah ω kali sejauh dari radiositas lama ke hasil pengumpulan.",
                &[
                    if_recorded(
                    "sum",
                    "{B_i} = {B_old} + {omega} ({E_i} + {rho_i} · {Σ_j F_i_j B_j=sum} − {B_old})",
                    ),
                    CHANGE,
                    ],
            ),
            entry(
                "Patch {i} has gathered: its new radiosity is what it emits and what it reflects.",
                "Patch {i} selesai mengumpulkan: radiositas barunya adalah yang dipancarkan ditambah yang dipantulkan.",
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
                "The ambient radiosity: what the light not shot yet will come to in the mean, were the room evenly lit. ⟨…⟩ are means by area.",
                "Radiositas ambien: nilai rata-rata yang akan dicapai cahaya yang belum ditembakkan, andai ruang terang merata. ⟨…⟩ rata-rata menurut luas.",
                &[is("{ambient} = [⟨ρ⟩ ⟨ΔB⟩; 1 − ⟨ρ⟩]")],
            ),
        ];
    Event { recorded: S::Shooting { i, unshot, shot, a_i }, solver } => "Shooting" at "shooting" number "i" scope ("patch", "patch")
        {
            "i" = i,
            "unshot_i" = unshot,
            "shot" = shot,
            "A_i" = a_i,
        }
        [
            only(
                When::Recorded("ambient"),
                "Patch {i} overshoots: its unshot radiosity ΔB_i, and the ambient in advance. ΔB_i A_i with the ambient is the largest of all.",
                "Patch {i} menembak lebih: radiositas ΔB_i yang belum ditembakkan, dan ambien di muka. ΔB_i A_i dengan ambien terbesar di antara semua.",
                &[is("{shot} = {ΔB_i=unshot_i} + {ambient}"), is("{A_i}")],
            ),
            entry(
                "Patch {i} shoots its unshot radiosity ΔB_i to all others: ΔB_i A_i is the largest of all.",
                "Patch {i} menembakkan radiositas ΔB_i yang belum ditembakkan ke semua patch lain: ΔB_i A_i terbesar di antara semua.",
                &[is("{ΔB_i=unshot_i}"), is("{A_i}")],
            ),
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
                "Patch {j} receives, and reflects the share ρ_j: that is light it has not shot yet. F_j_i follows from the row of patch {i} by reciprocity.",
                "Patch {j} menerima, dan memantulkan bagian ρ_j: itu cahaya yang belum ditembakkannya. F_j_i diperoleh dari baris patch {i} melalui resiprositas.",
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
            entry(
                "The shot of patch {i} is over: what it shot belongs to its radiosity now.",
                "Tembakan patch {i} selesai: yang ditembakkannya kini termasuk radiositasnya.",
                &[is("{B_i} = B_i′ + {shot}"), is("{ΔB_i=unshot_i}")],
            ),
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
                "Patch {i}, changed with all others at once: B″ is its radiosity one iteration earlier, r the residual.",
                "Patch {i}, diubah bersama semua patch lain: B″ radiositasnya satu iterasi sebelumnya, r residunya.",
                &[is("{B_i} = B″_i + {omega} (γ r_i + {B_old} − B″_i)")],
            ),
            only(
                When::Is("solver", "direct"),
                "Patch {i}: d solves the system for the residual, by elimination.",
                "Patch {i}: d menyelesaikan sistem untuk residu, dengan eliminasi.",
                &[is("{B_i} = {B_old} + d_i")],
            ),
            entry(
                "Patch {i}, changed with all others at once, along the direction p.",
                "Patch {i}, diubah bersama semua patch lain, sepanjang arah p.",
                &[is("{B_i} = {B_old} + α p_i")],
            ),
        ];
    Event { recorded: S::IterationDone { residual, error_bound }, solver } => "IterationDone" at "iteration"
        {
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry(
                "The iteration is over: how large the residual is against the emission. ε_B bounds the error of every radiosity, where a bound is known.",
                "Iterasi selesai: seberapa besar residu dibandingkan emisi. ε_B membatasi galat setiap radiositas, bila batasnya diketahui.",
                RESIDUAL,
            ),
        ];
    Event { recorded: S::Converged { iterations, residual, error_bound }, solver } => "Converged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
            "error_bound" = Bound(error_bound),
        }
        [
            entry(
                "Converged after {iterations} iterations: the residual is small enough.",
                "Konvergen setelah {iterations} iterasi: residunya cukup kecil.",
                RESIDUAL,
            ),
        ];
    Event { recorded: S::NotConverged { iterations, residual }, solver } => "NotConverged" at "iteration"
        {
            "iterations" = iterations,
            "residual" = residual,
        }
        [
            entry(
                "Not converged after {iterations} iterations: this is no solution.",
                "Tidak konvergen setelah {iterations} iterasi: ini bukan solusi.",
                &[is(RELATIVE)],
            ),
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

fn listing(solver: Solver) -> &'static Listing {
    match solver {
        Solver::Jacobi => &jacobi::PSEUDOCODE,
        Solver::GaussSeidel => &gauss_seidel::PSEUDOCODE,
        Solver::OverRelaxation => &over_relaxation::PSEUDOCODE,
        Solver::Shooting => &shooting::SHOOTING,
        Solver::Overshooting => &shooting::OVERSHOOTING,
        Solver::Chebyshev => &chebyshev::PSEUDOCODE,
        Solver::ConjugateGradients | Solver::Auto => &conjugate_gradients::PSEUDOCODE,
        Solver::Direct => &direct::PSEUDOCODE,
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        listing(self.solver).line(self.label())
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
