//! What the steps of rays say: ray casting, ray tracing, and the ray tree.

use super::{Entry, When, entry, is, only};

pub const TABLE: &[Entry] = &[
    // Primary rays
    only(
        "Pixel",
        When::Untold("x_P"),
        "Pixel ({x}, {y}) begins: a ray finds its colour.",
        "Piksel ({x}, {y}) dimulai: sebuah sinar mencari warnanya.",
        &[],
    ),
    entry(
        "Through",
        "The primary ray goes through this point of the picture plane, in pixels: the centre of the pixel, or of a cell of it.",
        "Sinar primer melewati titik bidang gambar ini, dalam piksel: pusat piksel, atau pusat sel di dalamnya.",
        &[is("{x_P}"), is("{y_P}")],
    ),
    only(
        "Ray",
        When::Is("ray", "reflected"),
        "The reflected ray begins, at level {level}: it starts at the surface and goes the way R.",
        "Sinar pantul dimulai, pada tingkat {level}: dari permukaan ke arah R.",
        RAY,
    ),
    only(
        "Ray",
        When::Is("ray", "transmitted"),
        "The transmitted ray begins, at level {level}: it passes the surface and goes the way T.",
        "Sinar bias dimulai, pada tingkat {level}: menembus permukaan ke arah T.",
        RAY,
    ),
    only(
        "Ray",
        When::Is("ray", "total_internal_reflection"),
        "Nothing passed the surface: this ray, at level {level}, is its total internal reflection.",
        "Tidak ada yang menembus permukaan: sinar ini, pada tingkat {level}, adalah pantulan internal totalnya.",
        RAY,
    ),
    entry(
        "Ray",
        "The primary ray begins at the eye O and goes through P_s, the point on the screen; u is its unit direction.",
        "Sinar primer mulai dari mata O melewati P_s, titik di layar; u arah satuannya.",
        &[is("{O}"), is("{u} = [P_s − O; |P_s − O|]")],
    ),
    only(
        "PixelColored",
        When::RecordedField("samples"),
        "The pixel takes the mean of what its rays brought back.",
        "Piksel mendapat rata-rata dari yang dibawa kembali sinar-sinarnya.",
        &[is("{pixel=color} = [{ΣI=+I}; {n=samples}^2]")],
    ),
    only(
        "PixelColored",
        When::RecordedField("y_P"),
        "The pixel takes what its ray brought back.",
        "Piksel mendapat yang dibawa kembali sinarnya.",
        &[is("{pixel=color} = {I=+I}")],
    ),
    // The nearest object
    entry(
        "Search",
        "The search begins: nothing is found yet, and {objects} objects are to be tested.",
        "Pencarian dimulai: belum ada yang ditemukan, {objects} objek akan diuji.",
        &[is("{NearestT}")],
    ),
    only(
        "ObjectTested",
        When::True("nearer"),
        "The ray meets object {object} nearer than all before: it is NearestObject now, and t is NearestT.",
        "Sinar mengenai objek {object} lebih dekat dari semua sebelumnya: kini NearestObject, dan t menjadi NearestT.",
        &[is("{t} < {NearestT}")],
    ),
    only(
        "ObjectTested",
        When::Finite("t"),
        "The ray meets object {object}, but not nearer than what was found before.",
        "Sinar mengenai objek {object}, tetapi tidak lebih dekat dari yang sudah ditemukan.",
        &[is("{t} ≥ {NearestT}")],
    ),
    entry(
        "ObjectTested",
        "The ray misses object {object}: NearestT stays.",
        "Sinar meleset dari objek {object}: NearestT tetap.",
        &[is("{t}")],
    ),
    only(
        "LightTested",
        When::True("nearer"),
        "The ray meets the ball of light {light} nearer than all objects.",
        "Sinar mengenai bola cahaya {light} lebih dekat dari semua objek.",
        &[is("{t} < {NearestT}")],
    ),
    only(
        "LightTested",
        When::Finite("t"),
        "The ball of light {light} lies behind what was found before.",
        "Bola cahaya {light} berada di balik yang sudah ditemukan.",
        &[is("{t} ≥ {NearestT}")],
    ),
    entry(
        "LightTested",
        "The ray misses the ball of light {light}.",
        "Sinar meleset dari bola cahaya {light}.",
        &[is("{t}")],
    ),
    only(
        "Found",
        When::Is("met", "object"),
        "The search is over: object {object} is the nearest.",
        "Pencarian selesai: objek {object} yang terdekat.",
        &[is("{NearestT}")],
    ),
    only(
        "Found",
        When::Is("met", "light"),
        "The search is over: light {light} itself is the nearest.",
        "Pencarian selesai: cahaya {light} sendiri yang terdekat.",
        &[is("{NearestT}")],
    ),
    entry(
        "Found",
        "The search is over: the ray meets nothing.",
        "Pencarian selesai: sinar tidak mengenai apa pun.",
        &[is("{NearestT}")],
    ),
    entry(
        "Background",
        "The ray leaves the scene: it takes the background colour.",
        "Sinar keluar dari adegan: mendapat warna latar belakang.",
        &[is("{I_{background}=color}")],
    ),
    entry(
        "LightMet",
        "The ray ends at light {light}: it takes the light's colour.",
        "Sinar berakhir di cahaya {light}: mendapat warna cahaya itu.",
        &[is("{I_{light}=color}")],
    ),
    // The surface
    entry(
        "SurfaceMet",
        "The point where the ray meets object {object}, and the normal that points out of it.",
        "Titik tempat sinar mengenai objek {object}, dan normal yang mengarah ke luar.",
        &[
            is("{P} = {O} + {t=NearestT} · {u}"),
            is("{N_{geometric}=N_geometric}"),
        ],
    ),
    only(
        "Faced",
        When::True("entering"),
        "The ray comes from outside, u · N < 0: the normal faces it already. θ_i is the angle of incidence.",
        "Sinar datang dari luar, u · N < 0: normal sudah menghadapnya. θ_i adalah sudut datang.",
        &[
            is("{N} = {N_{geometric}=N_geometric}"),
            is("{cos_theta_i} = −({u} · {N})"),
            is("{θ_i in °=theta_i_degrees} = arccos {cos_theta_i}"),
        ],
    ),
    entry(
        "Faced",
        "The ray comes from inside or from the back: the normal is turned toward it. θ_i is the angle of incidence.",
        "Sinar datang dari dalam atau dari belakang: normal dibalik ke arahnya. θ_i adalah sudut datang.",
        &[
            is("{N} = −{N_{geometric}=N_geometric}"),
            is("{cos_theta_i} = −({u} · {N})"),
            is("{θ_i in °=theta_i_degrees} = arccos {cos_theta_i}"),
        ],
    ),
    entry(
        "Textured",
        "The texture at this place; it multiplies k_d.",
        "Tekstur di tempat ini; dikalikan dengan k_d.",
        &[is("{u=u_texture}"), is("{v=v_texture}"), is("{texture}")],
    ),
    // Light that arrives
    only(
        "Viewer",
        When::RecordedField("u"),
        "The way back along the ray stands for the direction to the eye.",
        "Arah balik sepanjang sinar menggantikan arah ke mata.",
        &[is("{V} = −{u}")],
    ),
    only(
        "ShadowRay",
        When::Finite("d"),
        "A shadow ray goes to light {light}, at the distance d: is anything nearer?",
        "Sinar bayangan menuju cahaya {light}, pada jarak d: adakah yang lebih dekat?",
        &[
            is("{L} = [light − P; |light − P|]"),
            is("{d} = |light − P|"),
        ],
    ),
    entry(
        "ShadowRay",
        "A shadow ray goes to light {light}, which is infinitely far: does it meet anything?",
        "Sinar bayangan menuju cahaya {light} yang jauh tak berhingga: adakah yang dikenainya?",
        &[is("{L}"), is("{d}")],
    ),
    only(
        "BetweenTested",
        When::True("blocks"),
        "Object {object} lies between the surface and the light.",
        "Objek {object} berada di antara permukaan dan cahaya.",
        &[is("{t} < {d}")],
    ),
    only(
        "BetweenTested",
        When::Finite("t"),
        "Object {object} lies behind the light: it does not block it.",
        "Objek {object} berada di balik cahaya: tidak menghalangi.",
        &[is("{t} ≥ {d}")],
    ),
    entry(
        "BetweenTested",
        "The shadow ray misses object {object}.",
        "Sinar bayangan meleset dari objek {object}.",
        &[is("{t}")],
    ),
    entry(
        "Unshadowing",
        "Object {object} casts no shadow: it is passed over.",
        "Objek {object} tidak membuat bayangan: dilewati.",
        &[],
    ),
    only(
        "Shadow",
        When::True("blocked"),
        "In shadow: light {light} does not arrive. What blocks it lies at t < d.",
        "Dalam bayangan: cahaya {light} tidak sampai. Penghalangnya pada t < d.",
        &[is("{t} < {d}")],
    ),
    entry(
        "Shadow",
        "Nothing lies between: light {light} arrives.",
        "Tidak ada yang menghalangi: cahaya {light} sampai.",
        &[],
    ),
    only(
        "LightAdded",
        When::Untold("I_d"),
        "The light is blocked: it adds nothing.",
        "Cahaya terhalang: tidak menambah apa pun.",
        &[is("{I_d + I_s=I_added}")],
    ),
    only(
        "LightAdded",
        When::Untold("I_s"),
        "What light {light} adds; no surface of this scene has a highlight.",
        "Yang ditambahkan cahaya {light}; tidak ada permukaan dengan sorotan di adegan ini.",
        &[is("{I_d + I_s=I_added} = {I_d}")],
    ),
    entry(
        "Local",
        "The local term: the light that arrives, and what the surface gives off itself.",
        "Suku lokal: cahaya yang sampai, dan yang dipancarkan permukaan sendiri.",
        &[is("{I_local} = {I} + {emission}")],
    ),
    // Secondary rays
    entry(
        "Reflection",
        "The surface reflects: u is mirrored at N.",
        "Permukaan memantulkan: u dicerminkan pada N.",
        &[is("{R} = {u} − 2 ({u} · {N}) {N}"), is("{k_r}")],
    ),
    only(
        "Refraction",
        When::Negative("cos2_theta_r"),
        "The surface is transparent, but the radicand is negative: total internal reflection. θ_c is the critical angle.",
        "Permukaan tembus pandang, tetapi radikannya negatif: pantulan internal total. θ_c adalah sudut kritis.",
        &[
            is(COSINE),
            is("{θ_c in °=theta_c_degrees} = arcsin [{η_r=eta_r}; {η_i=eta_i}]"),
        ],
    ),
    only(
        "Refraction",
        When::RecordedField("theta_c_degrees"),
        "The surface is transparent, and the ray leaves the denser medium: it is bent away from the normal. θ_c is the critical angle.",
        "Permukaan tembus pandang, dan sinar keluar dari medium yang lebih rapat: dibiaskan menjauhi normal. θ_c adalah sudut kritis.",
        &[
            is(COSINE),
            is(ANGLE),
            is("{θ_c in °=theta_c_degrees} = arcsin [{η_r=eta_r}; {η_i=eta_i}]"),
        ],
    ),
    entry(
        "Refraction",
        "The surface is transparent: the direction of the ray beyond follows from Snell's law.",
        "Permukaan tembus pandang: arah sinar di baliknya mengikuti hukum Snellius.",
        &[is(COSINE), is(ANGLE)],
    ),
    entry(
        "Transmission",
        "The direction of the refracted ray.",
        "Arah sinar bias.",
        &[
            is(
                "{T} = [{η_i=eta_i}; {η_r=eta_r}] {u} − (√{cos2_theta_r} − [{η_i=eta_i}; {η_r=eta_r}] · {cos_theta_i}) {N}",
            ),
            is("{k_t}"),
        ],
    ),
    entry(
        "TotalInternalReflection",
        "Nothing passes: the coefficient k_t goes with a ray in the mirror direction.",
        "Tidak ada yang menembus: koefisien k_t ikut sinar ke arah cermin.",
        &[
            is("{cos2_theta_r} < 0"),
            is("{R} = {u} − 2 ({u} · {N}) {N}"),
            is("{k_t}"),
        ],
    ),
    only(
        "BranchEnded",
        When::Is("why", "depth"),
        "Level {level} is the last one: this ray is not traced, and contributes black.",
        "Tingkat {level} yang terakhir: sinar ini tidak dilacak, dan menyumbang hitam.",
        &[],
    ),
    only(
        "BranchEnded",
        When::Is("branch", "reflected"),
        "The surface does not reflect, k_r = 0: no reflected ray.",
        "Permukaan tidak memantulkan, k_r = 0: tanpa sinar pantul.",
        &[],
    ),
    entry(
        "BranchEnded",
        "The surface is not transparent, k_t = 0: no transmitted ray.",
        "Permukaan tidak tembus pandang, k_t = 0: tanpa sinar bias.",
        &[],
    ),
    // Light that comes back
    entry(
        "Attenuated",
        "The light of the secondary ray is weakened by the distance d to this surface.",
        "Cahaya sinar sekunder dilemahkan oleh jarak d ke permukaan ini.",
        &[
            is("{a=divisor} = {a_0} + {a_1} · {d} + {a_2} · {d}^2"),
            is("{I_{att}=carried} = [{I<}; {a=divisor}]"),
        ],
    ),
    only(
        "BranchAdded",
        When::Is("branch", "reflected"),
        "The light of the reflected ray is added.",
        "Cahaya sinar pantul ditambahkan.",
        &[is("{I=I_sum} = {I_{local}=I_sum<} + {k_r} · {I_R=carried}")],
    ),
    entry(
        "BranchAdded",
        "The light of the transmitted ray is added.",
        "Cahaya sinar bias ditambahkan.",
        &[is("{I=I_sum} = {I′=I_sum<} + {k_t} · {I_T=carried}")],
    ),
    entry(
        "Returned",
        "The light that comes back along the ray.",
        "Cahaya yang kembali sepanjang sinar.",
        &[is("{I}")],
    ),
];

const RAY: &[super::Formula] = &[is("{O}"), is("{u}")];
const COSINE: &str = "{cos2_theta_r} = 1 − ([{η_i=eta_i}; {η_r=eta_r}])^2 (1 − ({cos_theta_i})^2)";
const ANGLE: &str = "{θ_r in °=theta_r_degrees} = arccos √{cos2_theta_r}";
