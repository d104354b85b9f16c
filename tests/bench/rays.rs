//! Million rays a second on meshes made by a formula, one thread: every triangle, `obvhs` by itself with f32 hits, and ours with exact
//! f64 hits. All in one run, in alternating order; medians with quartiles, and the median ratio of alternating runs.

mod race;

use glam::{DVec3, Vec3A};
use lightwalk::numeric::Random;
use lightwalk::scene::primitives::{Primitives, Ray};
use lightwalk::scene::{Material, Mesh, Object, Scene, Shape, Tessellation};
use lightwalk::study::timing::Timing;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use race::{race, ratio};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::{Duration, Instant};

const RAYS: usize = 1 << 17;
const ROUNDS: usize = 9;

/// A torus with bumps, of about `triangles` triangles: around a ring of radius 1, a tube of radius 0.45 + 0.05 sin 12φ sin 8θ.
fn bumpy_torus(triangles: usize) -> Mesh {
    let across = ((triangles as f64 / 4.0).sqrt().round() as u32).max(3);
    let along = 2 * across;
    let mut positions = Vec::new();
    for i in 0..along {
        let phi = TAU * f64::from(i) / f64::from(along);
        for j in 0..across {
            let theta = TAU * f64::from(j) / f64::from(across);
            let tube = 0.45 + 0.05 * (12.0 * phi).sin() * (8.0 * theta).sin();
            let from_axis = 1.0 + tube * theta.cos();
            let (x, y) = (from_axis * phi.cos(), from_axis * phi.sin());
            positions.push(DVec3::new(x, y, tube * theta.sin()));
        }
    }
    let at = |i: u32, j: u32| (i % along) * across + j % across;
    let faces = (0..along).flat_map(|i| {
        (0..across).flat_map(move |j| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
    });
    Mesh::new(&positions, faces, &[])
}

/// Evenly spread over the unit sphere (Archimedes: z is evenly spread over [−1, 1]).
fn direction(random: &mut Random) -> DVec3 {
    let z = random.number();
    let (sin, cos) = (0.5 * TAU * random.number()).sin_cos();
    let r = (1.0 - z * z).sqrt();
    DVec3::new(r * cos, r * sin, z)
}

/// Through the pixels of a picture, line by line.
fn primary_rays() -> Vec<Ray> {
    let width = (RAYS as f64).sqrt() as usize;
    let eye = DVec3::new(0.6, -2.2, 2.4);
    let forward = -eye.normalize();
    let right = forward.cross(DVec3::Z).normalize();
    let up = right.cross(forward);
    let at = |i: usize| (i as f64 + 0.5) / width as f64 - 0.5;
    (0..width * width)
        .map(|pixel| {
            let (x, y) = (at(pixel % width), at(pixel / width));
            Ray {
                origin: eye,
                direction: (forward + 0.95 * (x * right - y * up)).normalize(),
            }
        })
        .collect()
}

/// From anywhere in the mesh's box, to anywhere.
fn incoherent_rays() -> Vec<Ray> {
    let mut random = Random(2024);
    (0..RAYS)
        .map(|_| {
            let mut within = |half: f64| half * random.number();
            Ray {
                origin: DVec3::new(within(1.5), within(1.5), within(0.5)),
                direction: direction(&mut random),
            }
        })
        .collect()
}

fn scene_of(mesh: Mesh) -> Scene {
    Scene {
        materials: vec![Material::default()],
        objects: vec![Object::new("torus", 0, Shape::Mesh(mesh))],
        ..Scene::default()
    }
}

/// Finds the nearest hits, and counts them.
type Hits = dyn Fn(&[Ray]) -> usize;

/// A way to find the nearest hit.
struct Contender {
    name: String,
    build: Duration,
    hits: Box<Hits>,
}

fn single(ray: &Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new_inf(ray.origin.as_vec3().into(), ray.direction.as_vec3().into())
}

fn obvhs_contenders(mesh: &Mesh, presets: &[(&str, BvhBuildParams)]) -> Vec<Contender> {
    let corner = |vertex: u32| Vec3A::from(mesh.position(vertex).as_vec3());
    let triangles: Vec<Triangle> = (0..mesh.face_count())
        .map(|face| {
            let [v0, v1, v2] = [0, 1, 2].map(|i| corner(mesh.face(face)[i]));
            Triangle { v0, v1, v2 }
        })
        .collect();
    let in_order = |indices: &[u32]| -> Vec<RtTriangle> {
        let of = |&index: &u32| RtTriangle::from(&triangles[index as usize]);
        indices.iter().map(of).collect()
    };
    let mut contenders = Vec::new();
    for &(preset, parameters) in presets {
        let start = Instant::now();
        let bvh = build_cwbvh_from_tris(&triangles, parameters, &mut Duration::default());
        let leaves = in_order(&bvh.primitive_indices);
        contenders.push(Contender {
            name: format!("obvhs CwBvh {preset}"),
            build: start.elapsed(),
            hits: Box::new(move |rays| {
                let meets = |ray: &&Ray| {
                    let mut hit = RayHit::none();
                    bvh.ray_traverse(single(ray), &mut hit, |ray, i| leaves[i].intersect(ray))
                };
                rays.iter().filter(meets).count()
            }),
        });
        let start = Instant::now();
        let bvh = build_bvh2_from_tris(&triangles, parameters, &mut Duration::default());
        let leaves = in_order(&bvh.primitive_indices);
        contenders.push(Contender {
            name: format!("obvhs Bvh2 {preset}"),
            build: start.elapsed(),
            hits: Box::new(move |rays| {
                let meets = |ray: &&Ray| {
                    let mut hit = RayHit::none();
                    bvh.ray_traverse(single(ray), &mut hit, |ray, i| leaves[i].intersect(ray))
                };
                rays.iter().filter(meets).count()
            }),
        });
    }
    contenders
}

fn ours(scene: &Scene) -> Contender {
    let tessellation = Tessellation::of(scene);
    let start = Instant::now();
    let primitives = Primitives::of(scene, &tessellation);
    Contender {
        name: "ours, exact".into(),
        build: start.elapsed(),
        hits: Box::new(move |rays| {
            rays.iter()
                .filter(|ray| primitives.nearest(ray).is_some())
                .count()
        }),
    }
}

fn compare(triangles: usize, presets: &[(&str, BvhBuildParams)]) {
    let scene = scene_of(bumpy_torus(triangles));
    let Shape::Mesh(mesh) = &scene.objects[0].shape else {
        return;
    };
    println!("\n{} triangles", mesh.face_count());
    let mut contenders = vec![ours(&scene)];
    contenders.extend(obvhs_contenders(mesh, presets));
    for contender in &contenders {
        println!("  {:22} built in {:.0?}", contender.name, contender.build);
    }
    let primitives = Primitives::of(&scene, &Tessellation::of(&scene));
    for (kind, rays) in [
        ("primary", primary_rays()),
        ("incoherent", incoherent_rays()),
    ] {
        let few: Vec<Ray> = rays.iter().step_by(rays.len() / 16).copied().collect();
        let start = Instant::now();
        for ray in &few {
            assert_eq!(
                primitives.nearest_by_brute_force(ray),
                primitives.nearest(ray)
            );
        }
        let brute_force = few.len() as f64 / start.elapsed().as_secs_f64() / 1e6;
        let mut runs: Vec<_> = (contenders.iter())
            .map(|contender| || _ = black_box((contender.hits)(black_box(&rays))))
            .collect();
        let mut runs: Vec<&mut dyn FnMut()> = runs.iter_mut().map(|run| run as _).collect();
        let seconds = race(&mut runs, ROUNDS);
        let hits = (contenders[0].hits)(&rays);
        println!("  {kind}: {} rays, {} hits", rays.len(), hits);
        println!("    {:22} {brute_force:.6}", "every triangle");
        for (contender, seconds_of) in contenders.iter().zip(&seconds) {
            let rates = seconds_of.iter().map(|s| rays.len() as f64 / s / 1e6);
            let rate = Timing::of(rates.collect());
            let ratio = ratio(seconds_of, &seconds[0]);
            println!(
                "    {:22} {:.3} ({:.3} to {:.3}) million rays/s; ours is {:.2} of it",
                contender.name, rate.median, rate.lower, rate.upper, ratio.median
            );
        }
    }
}

fn main() {
    let medium = ("medium", BvhBuildParams::medium_build());
    let slow = ("slow", BvhBuildParams::slow_build());
    compare(70_000, &[medium, slow]);
    compare(1_000_000, &[medium, slow]);
    println!("\nGrowth with the number of triangles");
    for triangles in [1_000, 10_000, 100_000] {
        compare(triangles, &[medium]);
    }
}
