//! A scene as radiosity sees it: patches, what stands between them, their form factors, and in the end their light.

use super::enclosure_needs::{known_channels, shortcuts, skipped_of_channels, skipped_of_pairs};
use super::exchange::Exchange;
use super::form_factor::{Blockers, Estimated, FormFactors, Method};
use super::radiosity::race::Race;
use super::radiosity::{
    self, Channel, ChannelUnsolved, Event, Matrix, RecordFilter, Rows, Solution, Solver,
    SolverEvent, Stop, System, Unsolved, shoot, solve, solve_channels,
};
use crate::color::Rgb;
use crate::record::{Recorder, Unrecorded};
use crate::scene::patch_primitives::PatchPrimitives;
use crate::scene::patches::{PatchError, Patches};
use crate::scene::{LeftOut, Limits, Part, Parts, Scene};
use std::sync::OnceLock;

/// How the light of an enclosure is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    pub form_factors: Method,
    /// By which a form factor that is followed is found a second time.
    pub then_by: Option<Method>,
    /// Whether what stands between two patches counts. What lies behind one of them never exchanges with it.
    pub visibility: bool,
    /// Whether the form factors of a closed scene are changed so that each row sums to 1.
    pub closure: bool,
    pub solver: Solver,
    pub stop: Stop,
    /// Whether pictures interpolate radiosity between the corners of patches.
    pub smooth: bool,
    /// The most patches that a scene may be divided into.
    pub max_patches: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            form_factors: Method::Auto { tolerance: 1e-6 },
            then_by: None,
            visibility: true,
            closure: true,
            solver: Solver::Auto,
            stop: Stop::default(),
            smooth: false,
            max_patches: Limits::default().max_patches,
        }
    }
}

/// The patches of a scene. Their matrix is made on first use.
#[derive(Clone, Debug)]
pub struct Enclosure {
    pub patches: Patches,
    pub blockers: Blockers,
    pub settings: Settings,
    /// What is done although the scene does not need it.
    forced: Parts,
    /// By patch: ρ and E.
    pub reflectance: Vec<Rgb>,
    pub emission: Vec<Rgb>,
    exchange: OnceLock<Exchange>,
    light: OnceLock<Result<Light, ChannelUnsolved>>,
    skipped: OnceLock<Vec<LeftOut>>,
    /// The patches as rays meet them.
    pub primitives: PatchPrimitives,
}

pub const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// The light of an enclosure.
#[derive(Clone, Debug)]
pub struct Light {
    /// B of every patch.
    pub radiosity: Vec<Rgb>,
    /// By channel.
    pub solutions: [Solution; 3],
}

impl Enclosure {
    /// `forced` is done although the scene does not need it. Errors: planes, patches without area, too many patches.
    pub fn of(scene: &Scene, settings: Settings, forced: Parts) -> Result<Enclosure, PatchError> {
        let patches = Patches::of(scene, settings.max_patches)?;
        let blockers = Blockers::of(scene, &patches);
        let primitives = PatchPrimitives::of(scene, &patches);
        let materials = patches
            .iter()
            .map(|patch| &scene.materials[scene.objects[patch.object as usize].material]);
        let (reflectance, emission) = materials
            .map(|material| (material.reflectance, material.emission))
            .unzip();
        Ok(Enclosure {
            patches,
            blockers,
            settings,
            forced,
            reflectance,
            emission,
            primitives,
            exchange: OnceLock::new(),
            light: OnceLock::new(),
            skipped: OnceLock::new(),
        })
    }

    /// What the exchange of light does not need, found on first use.
    pub fn skipped(&self) -> &[LeftOut] {
        self.skipped.get_or_init(|| {
            let lists = self.lists();
            let mut skipped = skipped_of_channels(&channels(&lists));
            if self.settings.form_factors.is_reciprocal() {
                let n = self.patches.len();
                skipped.extend(skipped_of_pairs(n, &self.form_factors(), self.visibility()));
            }
            skipped
        })
    }

    /// What stands between patches, where that counts.
    pub fn visibility(&self) -> Option<&Blockers> {
        self.settings.visibility.then_some(&self.blockers)
    }

    /// By the pair, by the row, or all of them.
    pub fn form_factors(&self) -> FormFactors<'_> {
        self.form_factors_by(self.settings.form_factors)
    }

    pub fn form_factors_by(&self, method: Method) -> FormFactors<'_> {
        FormFactors::new(&self.patches, method, self.visibility())
            .with_shortcuts(shortcuts(self.forced))
    }

    /// F, row-major, n×n for n patches, corrected where the scene is closed and the settings say so. `make` computes it, where it is not
    /// there yet.
    pub fn matrix_or(&self, make: impl FnOnce() -> Estimated) -> &[f64] {
        let exchange = self.exchange.get_or_init(|| {
            Exchange::of(
                &self.patches,
                self.visibility(),
                self.settings.closure,
                make(),
            )
        });
        &exchange.matrix
    }

    /// F, where it was made.
    pub fn matrix(&self) -> Option<&[f64]> {
        self.exchange().map(|exchange| &*exchange.matrix)
    }

    /// F and what is known of it, where it was made.
    pub fn exchange(&self) -> Option<&Exchange> {
        self.exchange.get()
    }

    /// The areas that light is exchanged by: where the matrix was corrected, of what light comes to.
    fn areas(&self) -> Vec<f64> {
        let exchange = self.exchange();
        exchange.map_or_else(|| self.patches.areas(), |exchange| exchange.areas.clone())
    }

    /// How many bytes a matrix of all form factors takes.
    pub fn matrix_bytes(&self) -> u64 {
        let n = self.patches.len() as u64;
        n.saturating_mul(n).saturating_mul(8)
    }

    /// The light, given its matrix; solved for on first use. Errors: as of [`Enclosure::solve`].
    pub fn light(&self, matrix: &[f64]) -> Result<&Light, &ChannelUnsolved> {
        self.light_or(|| self.solve(matrix, &RecordFilter::default(), &mut Unrecorded))
    }

    /// The light, where it is known; else what `solve` finds.
    pub fn light_or(
        &self,
        solve: impl FnOnce() -> Result<Light, ChannelUnsolved>,
    ) -> Result<&Light, &ChannelUnsolved> {
        self.light.get_or_init(solve).as_ref()
    }

    /// The first channel in which patches reflect and emit as much as in channel `c`: one is solved for both.
    pub fn first_equal_channel(&self, c: usize) -> usize {
        let equal = |other: usize| {
            let mut colors = self.reflectance.iter().chain(&self.emission);
            colors.all(|color| color.channels()[other] == color.channels()[c])
        };
        (0..c).find(|&other| equal(other)).unwrap_or(c)
    }

    /// Solves for the light, given its matrix. Errors: those of the first channel that has no result.
    pub fn solve<R: Recorder<Event>>(
        &self,
        matrix: &[f64],
        filter: &RecordFilter,
        recorder: &mut R,
    ) -> Result<Light, ChannelUnsolved> {
        let Settings { solver, stop, .. } = self.settings;
        let matrix = Matrix::new(matrix, self.patches.len()).map_err(|why| ChannelUnsolved {
            channel: "all channels",
            why,
        })?;
        self.solve_by(recorder, |patches, recorder| {
            let system = System::new(&matrix, *patches)?;
            solve(&system, solver, stop, filter, recorder)
        })
    }

    /// Solves for the light by shooting, with no matrix: the row of a patch is computed when it shoots. Errors: as of [`Enclosure::solve`].
    pub fn shoot<R: Recorder<Event>>(
        &self,
        filter: &RecordFilter,
        recorder: &mut R,
    ) -> Result<Light, ChannelUnsolved> {
        let Settings { solver, stop, .. } = self.settings;
        let overshoots = solver == Solver::Overshooting;
        self.solve_by(recorder, |patches, recorder| {
            let rows = FoundRows {
                form_factors: self.form_factors(),
                row: vec![0.0; patches.len()],
            };
            shoot(rows, patches, overshoots, stop, filter, recorder)
        })
    }

    /// All solvers on the first channel that has light, each timed by `clock`, in seconds.
    /// Errors: those of `go_on`, which calls the race off; inside, why not even the exact solution was found.
    pub fn race<E>(
        &self,
        matrix: &[f64],
        clock: impl FnMut() -> f64,
        go_on: impl Fn() -> Result<(), E>,
    ) -> Result<Result<Race, Unsolved>, E> {
        let lists = self.lists();
        let lit = |(_, emission): &(_, Vec<f64>)| emission.iter().any(|&e| e > 0.0);
        let c = lists.iter().position(lit).unwrap_or(0);
        let (rho, emission) = &lists[c];
        let areas = self.areas();
        let patches = radiosity::Patches::new(&areas, rho, emission);
        let matrix = Matrix::new(matrix, self.patches.len());
        let (patches, matrix) = match (patches, matrix) {
            (Ok(patches), Ok(matrix)) => (patches, matrix),
            (Err(why), _) | (_, Err(why)) => return Ok(Err(why)),
        };
        let tolerance = self.settings.stop.tolerance;
        match System::new(&matrix, patches) {
            Ok(system) => Race::run(&system, CHANNELS[c], tolerance, clock, go_on),
            Err(why) => Ok(Err(why)),
        }
    }

    /// By channel, ρ and E of every patch.
    fn lists(&self) -> [(Vec<f64>, Vec<f64>); 3] {
        [0, 1, 2].map(|c| {
            let of = |colors: &[Rgb]| colors.iter().map(|color| color.channels()[c]).collect();
            (of(&self.reflectance), of(&self.emission))
        })
    }

    fn solve_by<R: Recorder<Event>>(
        &self,
        recorder: &mut R,
        mut solve: impl FnMut(&radiosity::Patches, &mut R) -> Result<Solution, Unsolved>,
    ) -> Result<Light, ChannelUnsolved> {
        let lists = self.lists();
        let channels = channels(&lists);
        let known = known_channels(&channels, self.forced);
        let black_rows = self.forced.has(Part::BlackRows);
        let solver = self.settings.solver;
        let event = |recorded| Event { solver, recorded };
        let patches = self.patches.len() as u32;
        recorder.enter(|| event(SolverEvent::Enclosure { patches }));
        let areas = self.areas();
        let solved = solve_channels(&areas, channels, known, solver, recorder, |patches, by| {
            solve(&patches.with_black_rows(black_rows), by)
        });
        recorder.leave(|| event(SolverEvent::RoomDone));
        let solutions = solved?;
        let [red, green, blue] = &solutions;
        let radiosity = (0..self.patches.len())
            .map(|i| Rgb::new(red.radiosity[i], green.radiosity[i], blue.radiosity[i]))
            .collect();
        Ok(Light {
            radiosity,
            solutions,
        })
    }
}

/// The channels, of their ρ and E.
fn channels(lists: &[(Vec<f64>, Vec<f64>); 3]) -> [Channel<'_>; 3] {
    [0, 1, 2].map(|c| Channel {
        name: CHANNELS[c],
        rho: &lists[c].0,
        emission: &lists[c].1,
    })
}

/// Rows of form factors, found one by one.
struct FoundRows<'a> {
    form_factors: FormFactors<'a>,
    row: Vec<f64>,
}

impl Rows for FoundRows<'_> {
    fn row(&mut self, i: usize) -> &[f64] {
        self.form_factors.row(i, &mut self.row);
        &self.row
    }
}
