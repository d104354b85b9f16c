//! Every computed value has a formula; what a step takes rather than computes is listed.

use super::*;

/// Values that a step takes rather than computes, by kind.
const TAKEN: &[(&str, &[&str])] = &[
    // The scene states them.
    ("Ambient", &["k_a"]),
    ("Attenuated", &["a_0", "a_1", "a_2"]),
    ("Background", &["color"]),
    ("CornerTextured", &["u_k", "v_k"]),
    ("Diffuse", &["k_d"]),
    ("FileNormal", &["N_v"]),
    ("Frame", &["A"]),
    ("Gathering", &["E_i", "rho_i"]),
    ("Halfway", &["n_s"]),
    ("LeafLit", &["E_p"]),
    ("Light", &["I_light"]),
    ("LightMet", &["color"]),
    ("LinksGathering", &["rho_p"]),
    ("Local", &["emission"]),
    ("Mirrored", &["n_s"]),
    ("Pass", &["BFA_eps", "F_eps"]),
    ("Received", &["rho_j"]),
    ("Reflection", &["k_r"]),
    ("Refraction", &["eta_i", "eta_r"]),
    ("Specular", &["k_s"]),
    ("TotalInternalReflection", &["k_t"]),
    ("Transmission", &["k_t"]),
    ("Vertex", &["P_v"]),
    // A step before computed them.
    ("Attenuated", &["d"]),
    ("BetweenTested", &["d"]),
    ("ChildPulled", &["B_c"]),
    ("CornerPlaced", &["I", "N"]),
    ("DepthTested", &["nearest"]),
    ("Exchanged", &["B_j"]),
    ("Found", &["NearestT"]),
    ("Gathering", &["B_old"]),
    ("LightTested", &["NearestT"]),
    ("LinkGathered", &["B_q", "F_link"]),
    ("ObjectTested", &["NearestT"]),
    ("PushedDown", &["B_down", "B_g"]),
    ("Received", &["B_j"]),
    ("Refraction", &["cos_theta_i"]),
    ("Shooting", &["unshot_i"]),
    ("Span", &["x_4", "x_5", "z_4", "z_5"]),
    ("SpanEnds", &["I_4", "I_5", "N_4", "N_5"]),
    ("SpanTextured", &["u_4", "u_5", "v_4", "v_5"]),
    ("Started", &["B_i", "unshot_i"]),
    ("TextureApplied", &["I_d"]),
    ("TriangleCorner", &["N_1", "N_2", "N_3"]),
    ("Updated", &["B_old"]),
    // The step that follows uses them, with the formula.
    ("Light", &["slide_factor"]),
    ("Local", &["I_sum"]),
    // Samples, and what is measured of a piece of a patch.
    ("ChildPulled", &["share"]),
    ("Edge", &["R_k", "R_next"]),
    ("EdgePair", &["e_dot_f"]),
    ("Element", &["w", "x"]),
    ("Hemicube", &["x"]),
    ("Linked", &["V_pq"]),
    ("Pair", &["w_x", "w_y"]),
    ("Points", &["x", "y"]),
    ("Ray", &["direction", "x"]),
    ("Refining", &["A_p", "A_q", "F_pq", "rho_B"]),
    ("Reference", &["F_exact"]),
    ("Seen", &["F_visible", "F_x", "x"]),
    ("Sight", &["x", "y"]),
    ("SightsTaken", &["share"]),
    ("Visible", &["share"]),
];

/// The values of a step, finite ones, that none of its formulas is about with two sides.
fn without_formula(
    entry: &'static Entry,
    known: &mut Known,
    own: &Fields,
) -> impl Iterator<Item = &'static str> + use<> {
    let formulas = formulas(entry, known);
    let explained: HashSet<&str> = formulas
        .iter()
        .map(|formula| formula.equation())
        .filter(|equation| matches!(equation.right, Some((Relation::Equal, _))))
        .flat_map(|equation| equation.left.references())
        .map(|reference| reference.name)
        .collect();
    let is_computed = |value: Value| match value {
        Value::Number(number) => number.is_finite(),
        Value::Rgb(_) | Value::Vector(_) => true,
        Value::Integer(_) | Value::Truth(_) | Value::Word(_) => false,
    };
    let missing = own.iter().filter(|field| is_computed(field.value));
    let missing = missing
        .map(|field| field.name)
        .filter(|name| !explained.contains(name));
    missing.collect::<Vec<_>>().into_iter()
}

#[test]
fn every_computed_value_has_a_formula_or_is_listed() {
    let mut missing: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    each_step(|kind, known, _| {
        let entry = entry(kind, known).expect("every step has one");
        let own = known.own().clone();
        missing
            .entry(kind.name)
            .or_default()
            .extend(without_formula(entry, known, &own));
    });
    for (kind, values) in TAKEN {
        for value in *values {
            let missing = missing
                .get_mut(kind)
                .is_some_and(|missing| missing.remove(value));
            assert!(missing, "{kind} computes {value}, or has none");
        }
    }
    missing.retain(|_, values| !values.is_empty());
    assert_eq!(missing, BTreeMap::new());
}
