//! The events of the solvers.

use super::Solver;

/// A step of one solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    pub solver: Solver,
    pub recorded: SolverEvent,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolverEvent {
    /// Opens the light of an enclosure in all its channels, closed by `RoomDone`.
    Enclosure {
        patches: u32,
    },
    RoomDone,
    /// Opens the system of one channel, closed by `ChannelDone`.
    Channel {
        channel: &'static str,
    },
    /// A channel that needs no solving; `why` says so, `like` is the channel whose solution it shares.
    ChannelLeftOut {
        channel: &'static str,
        why: &'static str,
        like: Option<&'static str>,
    },
    ChannelDone {
        channel: &'static str,
    },
    /// Opens the work of one solver, closed by `Converged` or `NotConverged`. `gain` is max_i ρ_i Σ_j F_ij, where it is known.
    System {
        patches: u32,
        gain: Option<f64>,
    },
    /// The values of a patch before the first recorded iteration. `unshot` is its part of the residual.
    Started {
        i: u32,
        b: f64,
        unshot: f64,
    },
    /// Opens iteration `k`, counted from 0; closed by `IterationDone`.
    Iteration {
        k: u32,
    },
    /// The weight of over-relaxation, or of the current iteration of Chebyshev's.
    Weighted {
        omega: f64,
    },
    /// The step lengths of conjugate gradients.
    StepLengths {
        alpha: f64,
        beta: f64,
    },
    /// Opens the gathering of patch `i`.
    Gathering {
        i: u32,
        e_i: f64,
        rho_i: f64,
        b_old: f64,
    },
    /// What patch `j` brings to the patch that gathers, and the sum so far.
    Exchanged {
        j: u32,
        f_ij: f64,
        b_j: f64,
        product: f64,
        sum: f64,
    },
    /// Closes `Gathering`.
    Gathered {
        i: u32,
        b_new: f64,
        change: f64,
    },
    /// The ambient radiosity of overshooting: what the unshot radiosity will become in the mean.
    Ambient {
        ambient: f64,
    },
    /// Opens the shot of patch `i`: of `shot`, its unshot radiosity and, when overshooting, the ambient.
    Shooting {
        i: u32,
        unshot: f64,
        shot: f64,
        a_i: f64,
    },
    /// What the shot brings to patch `j`, whose values are those after it.
    Received {
        j: u32,
        f_ji: f64,
        rho_j: f64,
        delta: f64,
        b_j: f64,
        unshot_j: f64,
    },
    /// Closes `Shooting`: what patch `i` has now.
    ShotDone {
        i: u32,
        b_i: f64,
        unshot: f64,
    },
    /// The value of a patch, changed with all others at once.
    Updated {
        i: u32,
        b_old: f64,
        b_new: f64,
    },
    /// Closes `Iteration`: the relative residual, and the bound on the error where one is known.
    IterationDone {
        residual: f64,
        error_bound: Option<f64>,
    },
    Converged {
        iterations: u32,
        residual: f64,
        error_bound: Option<f64>,
    },
    NotConverged {
        iterations: u32,
        residual: f64,
    },
}

const _: () = assert!(size_of::<Event>() <= 64);
