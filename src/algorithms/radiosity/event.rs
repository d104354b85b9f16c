//! What the solvers tell.

use super::{
    Solver, chebyshev, conjugate_gradients, direct, gathering, gauss_seidel, jacobi,
    over_relaxation, shooting,
};
use crate::record::{self, Fields, Line, Listing};

/// A step of one solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    pub solver: Solver,
    pub recorded: SolverEvent,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolverEvent {
    /// Opens the light of a room in all its channels, closed by `RoomDone`.
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
    /// The values of a patch before the first iteration that is told. `unshot` is its part of the residual.
    Started {
        i: u32,
        b: f64,
        unshot: f64,
    },
    /// Opens iteration `k`, counted from 0; closed by `IterationDone`.
    Iteration {
        k: u32,
    },
    /// The weight of over-relaxation, or of Chebyshev's iteration in hand.
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

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self.recorded {
            SolverEvent::Enclosure { .. } => "Room",
            SolverEvent::RoomDone => "RoomDone",
            SolverEvent::Channel { .. } => "Channel",
            SolverEvent::ChannelLeftOut { .. } => "ChannelLeftOut",
            SolverEvent::ChannelDone { .. } => "ChannelDone",
            SolverEvent::System { .. } => "System",
            SolverEvent::Started { .. } => "Started",
            SolverEvent::Iteration { .. } => "Iteration",
            SolverEvent::Weighted { .. } => "Weighted",
            SolverEvent::StepLengths { .. } => "StepLengths",
            SolverEvent::Gathering { .. } => "Gathering",
            SolverEvent::Exchanged { .. } => "Exchanged",
            SolverEvent::Gathered { .. } => "Gathered",
            SolverEvent::Ambient { .. } => "Ambient",
            SolverEvent::Shooting { .. } => "Shooting",
            SolverEvent::Received { .. } => "Received",
            SolverEvent::ShotDone { .. } => "ShotDone",
            SolverEvent::Updated { .. } => "Updated",
            SolverEvent::IterationDone { .. } => "IterationDone",
            SolverEvent::Converged { .. } => "Converged",
            SolverEvent::NotConverged { .. } => "NotConverged",
        }
    }

    fn line(&self) -> Line {
        let (listing, lines): (&'static Listing, Lines) = match self.solver {
            Solver::Jacobi => (&jacobi::PSEUDOCODE, gathering::line),
            Solver::GaussSeidel => (&gauss_seidel::PSEUDOCODE, gathering::line),
            Solver::OverRelaxation => (&over_relaxation::PSEUDOCODE, gathering::line),
            Solver::Shooting => (&shooting::SHOOTING, shooting::line),
            Solver::Overshooting => (&shooting::OVERSHOOTING, shooting::overshooting_line),
            Solver::Chebyshev => (&chebyshev::PSEUDOCODE, chebyshev::line),
            Solver::ConjugateGradients | Solver::Auto => {
                (&conjugate_gradients::PSEUDOCODE, conjugate_gradients::line)
            }
            Solver::Direct => (&direct::PSEUDOCODE, direct::line),
        };
        Line {
            listing,
            number: lines(&self.recorded),
        }
    }

    fn holds_on(&self) -> bool {
        !matches!(
            self.recorded,
            SolverEvent::Started { .. }
                | SolverEvent::Exchanged { .. }
                | SolverEvent::Received { .. }
                | SolverEvent::Updated { .. }
                | SolverEvent::ChannelLeftOut { .. }
        )
    }

    fn fields(&self, fields: &mut Fields) {
        match self.recorded {
            SolverEvent::Enclosure { patches } => {
                fields.push("n", patches);
            }
            SolverEvent::RoomDone => {}
            SolverEvent::Channel { channel } | SolverEvent::ChannelDone { channel } => {
                fields.push("channel", channel);
            }
            SolverEvent::ChannelLeftOut { channel, why, like } => {
                fields.push("channel", channel).push("why", why);
                if let Some(like) = like {
                    fields.push("like", like);
                }
            }
            SolverEvent::System { patches, gain } => {
                fields.push("solver", self.solver.name()).push("n", patches);
                if let Some(gain) = gain {
                    fields.push("gain", gain);
                }
            }
            SolverEvent::Started { i, b, unshot } => {
                fields.push("i", i).push("B_i", b).push("unshot_i", unshot);
            }
            SolverEvent::Iteration { k } => {
                fields.push("k", k);
            }
            SolverEvent::Weighted { omega } => {
                fields.push("omega", omega);
            }
            SolverEvent::StepLengths { alpha, beta } => {
                fields.push("alpha", alpha).push("beta", beta);
            }
            SolverEvent::Gathering {
                i,
                e_i,
                rho_i,
                b_old,
            } => {
                fields.push("i", i).push("E_i", e_i);
                fields.push("rho_i", rho_i).push("B_old", b_old);
            }
            SolverEvent::Exchanged {
                j,
                f_ij,
                b_j,
                product,
                sum,
            } => {
                fields.push("j", j).push("F_ij", f_ij).push("B_j", b_j);
                fields.push("product", product).push("sum", sum);
            }
            SolverEvent::Gathered { i, b_new, change } => {
                fields
                    .push("i", i)
                    .push("B_i", b_new)
                    .push("DeltaB", change);
            }
            SolverEvent::Ambient { ambient } => {
                fields.push("ambient", ambient);
            }
            SolverEvent::Shooting {
                i,
                unshot,
                shot,
                a_i,
            } => {
                fields.push("i", i).push("unshot_i", unshot);
                fields.push("shot", shot).push("A_i", a_i);
            }
            SolverEvent::Received {
                j,
                f_ji,
                rho_j,
                delta,
                b_j,
                unshot_j,
            } => {
                fields.push("j", j).push("F_ji", f_ji).push("rho_j", rho_j);
                fields
                    .push("DeltaB", delta)
                    .push("B_j", b_j)
                    .push("unshot_j", unshot_j);
            }
            SolverEvent::ShotDone { i, b_i, unshot } => {
                fields
                    .push("i", i)
                    .push("B_i", b_i)
                    .push("unshot_i", unshot);
            }
            SolverEvent::Updated { i, b_old, b_new } => {
                fields.push("i", i).push("B_old", b_old).push("B_i", b_new);
            }
            SolverEvent::IterationDone {
                residual,
                error_bound,
            } => {
                fields.push("residual", residual);
                push_bound(fields, error_bound);
            }
            SolverEvent::Converged {
                iterations,
                residual,
                error_bound,
            } => {
                fields
                    .push("iterations", iterations)
                    .push("residual", residual);
                push_bound(fields, error_bound);
            }
            SolverEvent::NotConverged {
                iterations,
                residual,
            } => {
                fields
                    .push("iterations", iterations)
                    .push("residual", residual);
            }
        }
    }
}

/// The line of pseudocode that a step carries out.
type Lines = fn(&SolverEvent) -> usize;

fn push_bound(fields: &mut Fields, error_bound: Option<f64>) {
    match error_bound {
        Some(bound) => fields.push("error_bound", bound),
        None => fields.push("error_bound", "unknown"),
    };
}
