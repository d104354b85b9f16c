//! The tree of rays of a pixel.

use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::ray_tree::{Event, RayKind, divisor};

vocabulary! {
    [] Event {
    };
    Event::Ray { kind, level, ray } => "Ray" at "ray" number "level" scope ("ray", "sinar")
        {
            "ray" = kind.name(),
            "level" = level,
            "O" = ray.origin,
            "u" = ray.direction,
        }
        [
            only(
                When::Is("ray", "reflected"),
                "The reflected ray begins, at level {level}: it starts at the surface and goes the way R.",
                "Sinar pantul dimulai, pada tingkat {level}: dari permukaan ke arah R.",
                RAY,
            ),
            only(
                When::Is("ray", "transmitted"),
                "The transmitted ray begins, at level {level}: it passes the surface and goes the way T.",
                "Sinar bias dimulai, pada tingkat {level}: menembus permukaan ke arah T.",
                RAY,
            ),
            only(
                When::Is("ray", "total_internal_reflection"),
                "Nothing passed the surface: this ray, at level {level}, is its total internal reflection.",
                "Tidak ada yang menembus permukaan: sinar ini, pada tingkat {level}, adalah pantulan internal totalnya.",
                RAY,
            ),
            entry(
                "The primary ray begins at the eye O and goes through P_s, the point on the screen; u is its unit direction.",
                "Sinar primer mulai dari mata O melewati P_s, titik di layar; u arah satuannya.",
                &[is("{O}"), is("{u} = [P_s − O; |P_s − O|]")],
            ),
        ];
    Event::ShadowRay { light, direction, distance } => "ShadowRay" at "shadow" number "light" scope ("shadow ray", "sinar bayangan")
        {
            "light" = light,
            "L" = direction,
            "d" = distance,
        }
        [
            only(
                When::Finite("d"),
                "A shadow ray goes to light {light}, at the distance d: is anything nearer?",
                "Sinar bayangan menuju cahaya {light}, pada jarak d: adakah yang lebih dekat?",
                &[
                    is("{L} = [light − P; |light − P|]"),
                    is("{d} = |light − P|"),
                    ],
            ),
            entry(
                "A shadow ray goes to light {light}, which is infinitely far: does it meet anything?",
                "Sinar bayangan menuju cahaya {light} yang jauh tak berhingga: adakah yang dikenainya?",
                &[is("{L}"), is("{d}")],
            ),
        ];
    Event::Shadow { light, blocked, by } => "Shadow" at "shadow"
        {
            "light" = light,
            "blocked" = blocked,
            "blocker" = by.map(|hit| hit.object),
            "t" = by.map(|hit| hit.t),
        }
        [
            only(
                When::True("blocked"),
                "In shadow: light {light} does not arrive. What blocks it lies at t < d.",
                "Dalam bayangan: cahaya {light} tidak sampai. Penghalangnya pada t < d.",
                &[is("{t} < {d}")],
            ),
            entry(
                "Nothing lies between: light {light} arrives.",
                "Tidak ada yang menghalangi: cahaya {light} sampai.",
                &[],
            ),
        ];
    Event::Local { emission, local } => "Local" at "local"
        {
            "emission" = emission,
            "I_local" = local,
            "I_sum" = local,
        }
        [
            entry(
                "The local term: the light that arrives, and what the surface gives off itself.",
                "Suku lokal: cahaya yang sampai, dan yang dipancarkan permukaan sendiri.",
                &[is("{I_local} = {I} + {emission}")],
            ),
        ];
    Event::Refraction { eta_i, eta_r, cos_theta_i, radicand } => "Refraction" at "refraction"
        {
            "eta_i" = eta_i,
            "eta_r" = eta_r,
            "cos_theta_i" = cos_theta_i,
            "cos2_theta_r" = radicand,
            "theta_r_degrees" = Event::angles(eta_i, eta_r, radicand)[0],
            "theta_c_degrees" = Event::angles(eta_i, eta_r, radicand)[1],
        }
        [
            only(
                When::Negative("cos2_theta_r"),
                "The surface is transparent, but the radicand is negative: total internal reflection. θ_c is the critical angle.",
                "Permukaan tembus pandang, tetapi radikannya negatif: pantulan internal total. θ_c adalah sudut kritis.",
                &[
                    is(COSINE),
                    is("{θ_c in °=theta_c_degrees} = arcsin [{η_r=eta_r}; {η_i=eta_i}]"),
                    ],
            ),
            only(
                When::Recorded("theta_c_degrees"),
                "The surface is transparent, and the ray leaves the denser medium: it is bent away from the normal. θ_c is the critical angle.",
                "Permukaan tembus pandang, dan sinar keluar dari medium yang lebih rapat: dibiaskan menjauhi normal. θ_c adalah sudut kritis.",
                &[
                    is(COSINE),
                    is(ANGLE),
                    is("{θ_c in °=theta_c_degrees} = arcsin [{η_r=eta_r}; {η_i=eta_i}]"),
                    ],
            ),
            entry(
                "The surface is transparent: the direction of the ray beyond follows from Snell's law.",
                "Permukaan tembus pandang: arah sinar di baliknya mengikuti hukum Snellius.",
                &[is(COSINE), is(ANGLE)],
            ),
        ];
    Event::Branched { branch } if branch.kind == RayKind::Transmitted => "Transmission" at "refraction"
        {
            "branch" = branch.kind.name(),
            "k_t" = branch.coefficient,
            "T" = branch.direction,
        }
        [
            entry(
                "The direction of the refracted ray.",
                "Arah sinar bias.",
                &[
                    is(
                    "{T} = [{η_i=eta_i}; {η_r=eta_r}] {u} − (√{cos2_theta_r} − [{η_i=eta_i}; {η_r=eta_r}] · {cos_theta_i}) {N}",
                    ),
                    is("{k_t}"),
                    ],
            ),
        ];
    Event::Branched { branch } if branch.kind == RayKind::TotalInternalReflection => "TotalInternalReflection" at "refraction"
        {
            "branch" = branch.kind.name(),
            "k_t" = branch.coefficient,
            "R" = branch.direction,
        }
        [
            entry(
                "Nothing passes: the coefficient k_t goes with a ray in the mirror direction.",
                "Tidak ada yang menembus: koefisien k_t ikut sinar ke arah cermin.",
                &[
                    is("{cos2_theta_r} < 0"),
                    is("{R} = {u} − 2 ({u} · {N}) {N}"),
                    is("{k_t}"),
                    ],
            ),
        ];
    Event::Branched { branch } => "Reflection" at "reflection"
        {
            "branch" = branch.kind.name(),
            "k_r" = branch.coefficient,
            "R" = branch.direction,
        }
        [
            entry(
                "The surface reflects: u is mirrored at N.",
                "Permukaan memantulkan: u dicerminkan pada N.",
                &[is("{R} = {u} − 2 ({u} · {N}) {N}"), is("{k_r}")],
            ),
        ];
    Event::Ended { kind, end } => "BranchEnded" at "refraction" or "reflection" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "why" = end.name(),
        }
        [
            only(
                When::Is("why", "depth"),
                "Level {level} is the last one: this ray is not traced, and contributes black.",
                "Tingkat {level} yang terakhir: sinar ini tidak dilacak, dan menyumbang hitam.",
                &[],
            ),
            only(
                When::Is("branch", "reflected"),
                "The surface does not reflect, k_r = 0: no reflected ray.",
                "Permukaan tidak memantulkan, k_r = 0: tanpa sinar pantul.",
                &[],
            ),
            entry(
                "The surface is not transparent, k_t = 0: no transmitted ray.",
                "Permukaan tidak tembus pandang, k_t = 0: tanpa sinar bias.",
                &[],
            ),
        ];
    Event::Attenuated { kind, distance, attenuation, carried } => "Attenuated" at "transmitted" or "reflected" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "d" = distance,
            "a_0" = attenuation[0],
            "a_1" = attenuation[1],
            "a_2" = attenuation[2],
            "divisor" = divisor(attenuation, distance),
            "carried" = carried,
        }
        [
            entry(
                "The light of the secondary ray is weakened by the distance d to this surface.",
                "Cahaya sinar sekunder dilemahkan oleh jarak d ke permukaan ini.",
                &[
                    is("{a=divisor} = {a_0} + {a_1} · {d} + {a_2} · {d}^2"),
                    is("{I_{att}=carried} = [{I<}; {a=divisor}]"),
                    ],
            ),
        ];
    Event::Added { kind, carried, sum } => "BranchAdded" at "transmitted" or "reflected" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "carried" = carried,
            "I_sum" = sum,
        }
        [
            only(
                When::Is("branch", "reflected"),
                "The light of the reflected ray is added.",
                "Cahaya sinar pantul ditambahkan.",
                &[is("{I=I_sum} = {I_{local}=I_sum<} + {k_r} · {I_R=carried}")],
            ),
            entry(
                "The light of the transmitted ray is added.",
                "Cahaya sinar bias ditambahkan.",
                &[is("{I=I_sum} = {I′=I_sum<} + {k_t} · {I_T=carried}")],
            ),
        ];
    Event::Returned { color } => "Returned" at "returned"
        {
            "I" = color,
        }
        [
            entry(
                "The light that comes back along the ray.",
                "Cahaya yang kembali sepanjang sinar.",
                &[is("{I}")],
            ),
        ];
}

const RAY: &[Formula] = &[is("{O}"), is("{u}")];
const COSINE: &str = "{cos2_theta_r} = 1 − ([{η_i=eta_i}; {η_r=eta_r}])^2 (1 − ({cos_theta_i})^2)";
const ANGLE: &str = "{θ_r in °=theta_r_degrees} = arccos √{cos2_theta_r}";
