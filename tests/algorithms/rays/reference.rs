//! A second renderer with the same meaning, written from the contract alone: plain formulas, vectors of three numbers, no
//! hierarchy, a fixed offset. It shares only the scene's types with the program.

use glam::DVec3;
use lightwalk::color::Rgb;
use lightwalk::scene::{Camera, Highlight, Light, Material, Scene, Shape};

const OFFSET: f64 = 1e-9;

struct Contact {
    t: f64,
    object: usize,
    outward: DVec3,
}

/// The colour of pixel (x, y) of a picture of `size`, one ray through its centre.
pub fn pixel(scene: &Scene, size: [u32; 2], depth: u32, (x, y): (u32, u32)) -> Rgb {
    let Camera {
        eye,
        target,
        up,
        fov_x,
    } = scene.camera.expect("a camera");
    let forward = (target - eye).normalize();
    let right = forward.cross(up).normalize();
    let up = right.cross(forward);
    let [width, height] = size.map(f64::from);
    let half = (fov_x / 2.0).tan();
    let across = ((f64::from(x) + 0.5) / width * 2.0 - 1.0) * half;
    let down = ((f64::from(y) + 0.5) / height * 2.0 - 1.0) * half * height / width;
    let direction = (forward + across * right - down * up).normalize();
    let inside: Vec<usize> = (0..scene.objects.len())
        .filter(|&i| material(scene, i).transmission != Rgb::BLACK)
        .filter(|&i| matches!(scene.objects[i].shape, Shape::Sphere { center, radius } if eye.distance(center) < radius))
        .collect();
    assert!(inside.len() < 2, "the order of several is not known here");
    trace(scene, eye, direction, 1, depth, &inside).0
}

fn material(scene: &Scene, object: usize) -> &Material {
    &scene.materials[scene.objects[object].material]
}

fn contact(scene: &Scene, object: usize, o: DVec3, u: DVec3) -> Option<Contact> {
    let found = |t: f64, outward: DVec3| {
        (t > 0.0 && t.is_finite()).then_some(Contact { t, object, outward })
    };
    match &scene.objects[object].shape {
        Shape::Sphere { center, radius } => {
            ball(*center, *radius, o, u).and_then(|t| found(t, (o + t * u - *center) / *radius))
        }
        Shape::Plane { point, normal } => {
            found((*point - o).dot(*normal) / u.dot(*normal), *normal)
        }
        Shape::Polygon { vertices } => {
            // A convex planar polygon: inside all of its edges
            let n = (vertices[1] - vertices[0])
                .cross(vertices[2] - vertices[0])
                .normalize();
            let t = (vertices[0] - o).dot(n) / u.dot(n);
            let p = o + t * u;
            let inside = (0..vertices.len()).all(|i| {
                let (a, b) = (vertices[i], vertices[(i + 1) % vertices.len()]);
                (b - a).cross(p - a).dot(n) >= 0.0
            });
            if inside { found(t, n) } else { None }
        }
        other => panic!("the reference intersects planes, polygons and spheres, found {other:?}"),
    }
}

fn ball(center: DVec3, radius: f64, o: DVec3, u: DVec3) -> Option<f64> {
    let m = o - center;
    let (b, c) = (m.dot(u), m.length_squared() - radius * radius);
    let d = b * b - c;
    if d < 0.0 {
        return None;
    }
    [-b - d.sqrt(), -b + d.sqrt()]
        .into_iter()
        .find(|&t| t > 0.0)
}

fn trace(
    scene: &Scene,
    o: DVec3,
    u: DVec3,
    level: u32,
    depth: u32,
    inside: &[usize],
) -> (Rgb, f64) {
    if level > depth {
        return (Rgb::BLACK, f64::INFINITY);
    }
    let mut nearest: Option<Contact> = None;
    for object in 0..scene.objects.len() {
        if let Some(found) = contact(scene, object, o, u)
            && nearest.as_ref().is_none_or(|nearest| found.t < nearest.t)
        {
            nearest = Some(found);
        }
    }
    let mut nearest_t = nearest.as_ref().map_or(f64::INFINITY, |nearest| nearest.t);
    let mut light_met = None;
    for light in &scene.lights {
        if let Light::Point {
            position,
            radius,
            color,
            ..
        } = light
            && *radius > 0.0
            && let Some(t) = ball(*position, *radius, o, u)
            && t < nearest_t
        {
            nearest_t = t;
            light_met = Some(*color);
        }
    }
    if let Some(color) = light_met {
        return (color, nearest_t);
    }
    let Some(Contact { t, object, outward }) = nearest else {
        return (scene.background, f64::INFINITY);
    };
    let p = o + t * u;
    let entering = u.dot(outward) < 0.0;
    let n = if entering { outward } else { -outward };
    let m = material(scene, object);

    let mut color = m.ambient * scene.ambient + m.emission;
    for light in &scene.lights {
        let (l, distance, power) = match *light {
            Light::Point {
                position,
                color,
                attenuation: [a0, a1, a2],
                ..
            } => {
                let d = position.distance(p);
                ((position - p) / d, d, color / (a0 + a1 * d + a2 * d * d))
            }
            Light::Directional { toward, color } => (-toward, f64::INFINITY, color),
        };
        if n.dot(l) <= 0.0 {
            continue;
        }
        let from = p + OFFSET * n;
        let between = |i: usize| {
            scene.objects[i].casts_shadow
                && contact(scene, i, from, l).is_some_and(|found| found.t < distance)
        };
        if (0..scene.objects.len()).any(between) {
            continue;
        }
        let v = -u;
        let cosine = match m.highlight {
            Highlight::Phong => (2.0 * n.dot(l) * n - l).dot(v),
            Highlight::Blinn => n.dot((l + v).normalize()),
        };
        color += power * (m.diffuse * n.dot(l) + m.specular * cosine.max(0.0).powf(m.shininess));
    }

    let [a0, a1, a2] = scene.path_attenuation;
    let mut go_on = |k: Rgb, toward: DVec3, side: f64, inside: &[usize]| {
        if k != Rgb::BLACK {
            let (light, d) = trace(
                scene,
                p + side * OFFSET * n,
                toward,
                level + 1,
                depth,
                inside,
            );
            let divisor = if d.is_finite() {
                a0 + a1 * d + a2 * d * d
            } else {
                1.0
            };
            color += k * (light / divisor);
        }
    };
    let mirrored = u - 2.0 * u.dot(n) * n;
    go_on(m.reflection, mirrored, 1.0, inside);
    let mut beyond = inside.to_vec();
    // Of planes, polygons and spheres only spheres have an inside; the others are thin panes.
    let is_body = matches!(scene.objects[object].shape, Shape::Sphere { .. });
    if is_body && entering {
        beyond.push(object);
    } else if let Some(at) = beyond.iter().rposition(|&one| one == object) {
        beyond.remove(at);
    }
    let index = |media: &[usize]| {
        media
            .last()
            .map_or(1.0, |&object| material(scene, object).ior)
    };
    let eta = index(inside) / index(&beyond);
    let cos_i = -u.dot(n);
    let cos2_r = 1.0 - eta * eta * (1.0 - cos_i * cos_i);
    if cos2_r < 0.0 {
        go_on(m.transmission, mirrored, 1.0, inside);
    } else {
        go_on(
            m.transmission,
            eta * u - (cos2_r.sqrt() - eta * cos_i) * n,
            -1.0,
            &beyond,
        );
    }
    (color, t)
}
