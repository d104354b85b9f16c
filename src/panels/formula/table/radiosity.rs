//! What the steps of the radiosity solvers say.

use super::{Entry, Formula, When, entry, if_finite, if_told, is, only};

pub const TABLE: &[Entry] = &[
    // The room and its channels
    entry(
        "Room",
        "The light of a room of {n} patches is to be found: one system of equations for each channel of the colour.",
        "Cahaya ruang dengan {n} patch akan dicari: satu sistem persamaan untuk tiap kanal warna.",
        &[is("B_i = E_i + ρ_i Σ_j F_i_j B_j")],
    ),
    entry(
        "RoomDone",
        "All channels are done: every patch has its radiosity.",
        "Semua kanal selesai: setiap patch mendapat radiositasnya.",
        &[],
    ),
    entry(
        "Channel",
        "The channel {channel} begins: radiosity is monochrome, so each channel is solved by itself.",
        "Kanal {channel} dimulai: radiositas bersifat monokrom, jadi tiap kanal diselesaikan sendiri.",
        &[],
    ),
    only(
        "ChannelLeftOut",
        When::RecordedField("like"),
        "The channel {channel} has the reflectances and emissions of the channel {like}: its solution serves both.",
        "Kanal {channel} memiliki reflektansi dan emisi yang sama dengan kanal {like}: solusinya dipakai bersama.",
        &[],
    ),
    entry(
        "ChannelLeftOut",
        "In the channel {channel} nothing emits, so every radiosity is 0: there is nothing to solve.",
        "Pada kanal {channel} tidak ada yang memancar, jadi semua radiositas 0: tidak ada yang perlu diselesaikan.",
        &[],
    ),
    entry(
        "ChannelDone",
        "The channel {channel} is done.",
        "Kanal {channel} selesai.",
        &[],
    ),
    entry(
        "System",
        "{n} equations for {n} radiosities, to be solved by {solver}. μ, the largest gain of a row, says how much of the light is reflected at most.",
        "{n} persamaan untuk {n} radiositas, diselesaikan dengan {solver}. μ, penguatan baris terbesar, menyatakan paling banyak berapa bagian cahaya yang dipantulkan.",
        &[
            is("(I − ρF) B = E"),
            if_told("gain", "{μ=gain} = max_i ρ_i Σ_j F_i_j"),
        ],
    ),
    entry(
        "Started",
        "Patch {i} before the iteration: its radiosity, and its part r_i of the residual.",
        "Patch {i} sebelum iterasi: radiositasnya, dan bagiannya r_i dari residu.",
        &[is("{B_i}"), is("{r_i=unshot_i}")],
    ),
    entry(
        "Iteration",
        "Iteration {k} begins.",
        "Iterasi {k} dimulai.",
        &[],
    ),
    // Gathering
    only(
        "Weighted",
        When::Is("solver", "over-relaxation"),
        "Every patch goes ω times as far as it gathers, by Young’s ω for the bound μ.",
        "Setiap patch melangkah ω kali sejauh yang dikumpulkannya, dengan ω dari Young untuk batas μ.",
        &[is("{omega} = [2; 1 + √(1 − {μ=gain}^2)]")],
    ),
    only(
        "Weighted",
        When::NotPositive("k"),
        "The weight of the first iteration of Chebyshev is 1.",
        "Bobot iterasi Chebyshev yang pertama adalah 1.",
        &[is("{omega}")],
    ),
    entry(
        "Weighted",
        "The weight of this iteration of Chebyshev, from the weight ω′ before; in the second iteration 2 stands for ω′.",
        "Bobot iterasi Chebyshev ini, dari bobot ω′ sebelumnya; pada iterasi kedua ω′ diganti 2.",
        &[is("{omega} = [1; 1 − {μ=gain}^2 ω′ / 4]")],
    ),
    entry(
        "Gathering",
        "Patch {i} gathers the light of all others: it emits E_i itself and reflects the share ρ_i of what arrives.",
        "Patch {i} mengumpulkan cahaya dari semua patch lain: ia memancarkan E_i sendiri dan memantulkan bagian ρ_i dari yang tiba.",
        &[is("{E_i}"), is("{rho_i}"), is("{B_old}")],
    ),
    entry(
        "Exchanged",
        "Of the light that patch {i} gathers, patch {j} brings form factor times radiosity.",
        "Dari cahaya yang dikumpulkan patch {i}, patch {j} menyumbang faktor bentuk kali radiositas.",
        &[is("{sum} = sum′ + {F_ij} · {B_j}")],
    ),
    only(
        "Gathered",
        When::RecordedField("omega"),
        "Patch {i} has gathered, and goes ω times as far as from the old radiosity to what it gathered.",
        "Patch {i} selesai mengumpulkan, dan melangkah ω kali sejauh dari radiositas lama ke hasil pengumpulan.",
        &[
            if_told(
                "sum",
                "{B_i} = {B_old} + {omega} ({E_i} + {rho_i} · {Σ_j F_i_j B_j=sum} − {B_old})",
            ),
            CHANGE,
        ],
    ),
    entry(
        "Gathered",
        "Patch {i} has gathered: its new radiosity is what it emits and what it reflects.",
        "Patch {i} selesai mengumpulkan: radiositas barunya adalah yang dipancarkan ditambah yang dipantulkan.",
        &[
            if_told("sum", "{B_i} = {E_i} + {rho_i} · {Σ_j F_i_j B_j=sum}"),
            CHANGE,
        ],
    ),
    // Shooting
    only(
        "Ambient",
        When::RecordedField("ambient"),
        "The ambient radiosity: what the light not shot yet will come to in the mean, were the room evenly lit. ⟨…⟩ are means by area.",
        "Radiositas ambien: nilai rata-rata yang akan dicapai cahaya yang belum ditembakkan, andai ruang terang merata. ⟨…⟩ rata-rata menurut luas.",
        &[is("{ambient} = [⟨ρ⟩ ⟨ΔB⟩; 1 − ⟨ρ⟩]")],
    ),
    only(
        "Shooting",
        When::RecordedField("ambient"),
        "Patch {i} overshoots: its unshot radiosity ΔB_i, and the ambient in advance. ΔB_i A_i with the ambient is the largest of all.",
        "Patch {i} menembak lebih: radiositas ΔB_i yang belum ditembakkan, dan ambien di muka. ΔB_i A_i dengan ambien terbesar di antara semua.",
        &[is("{shot} = {ΔB_i=unshot_i} + {ambient}"), is("{A_i}")],
    ),
    entry(
        "Shooting",
        "Patch {i} shoots its unshot radiosity ΔB_i to all others: ΔB_i A_i is the largest of all.",
        "Patch {i} menembakkan radiositas ΔB_i yang belum ditembakkan ke semua patch lain: ΔB_i A_i terbesar di antara semua.",
        &[is("{ΔB_i=unshot_i}"), is("{A_i}")],
    ),
    entry(
        "Received",
        "Patch {j} receives, and reflects the share ρ_j: that is light it has not shot yet. F_j_i follows from the row of patch {i} by reciprocity.",
        "Patch {j} menerima, dan memantulkan bagian ρ_j: itu cahaya yang belum ditembakkannya. F_j_i diperoleh dari baris patch {i} melalui resiprositas.",
        &[
            is("{F_ji} = F_i_j A_i / A_j"),
            is("{ΔRad=DeltaB} = {rho_j} · {F_ji} · {ΔB_i=shot}"),
            is("{ΔB_j=unshot_j} = ΔB_j′ + {ΔRad=DeltaB}"),
        ],
    ),
    entry(
        "ShotDone",
        "The shot of patch {i} is over: what it shot belongs to its radiosity now.",
        "Tembakan patch {i} selesai: yang ditembakkannya kini termasuk radiositasnya.",
        &[is("{B_i} = B_i′ + {shot}"), is("{ΔB_i=unshot_i}")],
    ),
    // All at once
    entry(
        "StepLengths",
        "The step lengths of conjugate gradients: α along the direction p, and β for the next direction.",
        "Panjang langkah gradien konjugat: α sepanjang arah p, dan β untuk arah berikutnya.",
        &[
            is("{alpha} = [δ; p · S p]"),
            is("{beta} = [s · M^−^1 s; δ]"),
        ],
    ),
    only(
        "Updated",
        When::Is("solver", "chebyshev"),
        "Patch {i}, changed with all others at once: B″ is its radiosity one iteration earlier, r the residual.",
        "Patch {i}, diubah bersama semua patch lain: B″ radiositasnya satu iterasi sebelumnya, r residunya.",
        &[is("{B_i} = B″_i + {omega} (γ r_i + {B_old} − B″_i)")],
    ),
    only(
        "Updated",
        When::Is("solver", "direct"),
        "Patch {i}: d solves the system for the residual, by elimination.",
        "Patch {i}: d menyelesaikan sistem untuk residu, dengan eliminasi.",
        &[is("{B_i} = {B_old} + d_i")],
    ),
    entry(
        "Updated",
        "Patch {i}, changed with all others at once, along the direction p.",
        "Patch {i}, diubah bersama semua patch lain, sepanjang arah p.",
        &[is("{B_i} = {B_old} + α p_i")],
    ),
    // How far it is from the solution
    entry(
        "IterationDone",
        "The iteration is over: how large the residual is against the emission. ε_B bounds the error of every radiosity, where a bound is known.",
        "Iterasi selesai: seberapa besar residu dibandingkan emisi. ε_B membatasi galat setiap radiositas, bila batasnya diketahui.",
        RESIDUAL,
    ),
    entry(
        "Converged",
        "Converged after {iterations} iterations: the residual is small enough.",
        "Konvergen setelah {iterations} iterasi: residunya cukup kecil.",
        RESIDUAL,
    ),
    entry(
        "NotConverged",
        "Not converged after {iterations} iterations: this is no solution.",
        "Tidak konvergen setelah {iterations} iterasi: ini bukan solusi.",
        &[is(RELATIVE)],
    ),
];

const CHANGE: Formula = is("{ΔB=DeltaB} = {B_i} − {B_old}");

const RESIDUAL: &[Formula] = &[
    is(RELATIVE),
    if_finite("error_bound", "{ε_B=error_bound} = [‖r‖_∞; 1 − {μ=gain}]"),
];

const RELATIVE: &str = "{residual} = [‖E − (I − ρF) B‖; ‖E‖]";
