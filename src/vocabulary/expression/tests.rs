use super::*;
use crate::color::Rgb;
use crate::record::Value;
use crate::vocabulary::FAMILIES;
use glam::DVec3;

/// Every formula that is declared.
fn declared() -> impl Iterator<Item = &'static str> {
    let entries = FAMILIES.into_iter().flatten().flat_map(|kind| kind.entries);
    entries
        .flat_map(|entry| entry.formulas)
        .map(|formula| formula.text)
}

/// An expression in the language that it was read from, with its symbols alone.
fn printed(expression: &Expression) -> String {
    match expression {
        Expression::Number(text, _) => text.to_string(),
        Expression::Value(reference) => reference.symbol().to_string(),
        Expression::Sum(reference) => format!("Σ{}", reference.symbol()),
        Expression::Notation(text) => text.to_string(),
        Expression::Parentheses(inner) => format!("({})", printed(inner)),
        Expression::Negative(inner) => format!("−{}", printed(inner)),
        Expression::Operation(a, operator, b) => {
            format!("{}{}{}", printed(a), operator.sign(), printed(b))
        }
        Expression::Fraction(a, b) => format!("[{}; {}]", printed(a), printed(b)),
        Expression::Power(a, b) => format!("{}^{}", printed(a), printed(b)),
        Expression::Call(function, arguments) => {
            let [before, after] = function.signs();
            let arguments: Vec<String> = arguments.iter().map(printed).collect();
            format!("{before}{}{after}", arguments.join(", "))
        }
    }
}

/// A formula with symbols in place of its names.
fn with_symbols(text: &str) -> String {
    let mut written = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let end = match c {
            '\'' => rest[1..].find('\'').expect("it is closed") + 2,
            '{' => {
                let mut depth = 0;
                rest.find(|c| {
                    depth += i32::from(c == '{') - i32::from(c == '}');
                    depth == 0
                })
                .expect("it is closed")
                    + 1
            }
            c if c.is_ascii_alphabetic() => rest
                .find(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                .unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        let (word, after) = rest.split_at(end);
        rest = after;
        let functions = [
            "max", "min", "arccos", "arcsin", "atan2", "sin", "cos", "tan",
        ];
        written.push_str(&match c {
            '\'' => word.trim_matches('\'').to_string(),
            '{' => match word[1..end - 1].rsplit_once('=') {
                Some((symbol, _)) => symbol.to_string(),
                None => {
                    let name = word[1..end - 1].trim_start_matches(['*', '+']);
                    let name_end = name.find(['<', '@', '!', '^', '/']).unwrap_or(name.len());
                    symbol(&name[..name_end])
                }
            },
            c if c.is_ascii_alphabetic() && !functions.contains(&word) => symbol(word),
            _ => word.to_string(),
        });
    }
    written
}

/// Whether a formula names a value so for those that follow it.
fn is_defined(name: &str) -> bool {
    let defines = |text: &str| {
        let name_of =
            |left: &str| left.trim_matches(['{', '}', ' ']).rsplit('=').next() == Some(name);
        text.split_once(":=").is_some_and(|(left, _)| name_of(left))
    };
    declared().any(defines)
}

fn symbol(name: &str) -> String {
    let recorded = find(name).map(|quantity| quantity.symbol);
    let of_scene = || SceneValue::named(name).map(|value| value.symbol);
    let defined = is_defined(name).then_some("");
    let known = recorded.or_else(of_scene).or(defined);
    known
        .unwrap_or_else(|| panic!("{name} is no value"))
        .to_string()
}

#[test]
fn every_formula_parses_and_prints_with_the_declared_symbols() {
    let mut count = 0;
    for text in declared() {
        let equation = Equation::parse(text).unwrap_or_else(|error| panic!("{error}"));
        let mut back = printed(&equation.left);
        if let Some((relation, right)) = &equation.right {
            back.push_str(&format!(" {} {}", relation.sign(), printed(right)));
        }
        let close = |text: &str| text.replace(' ', "");
        assert_eq!(
            close(&back),
            close(&with_symbols(text).replace(":=", "=")),
            "{text}"
        );
        for reference in equation.references() {
            symbol(reference.name);
        }
        count += 1;
    }
    assert!(count > 150, "only {count} formulas");
}

#[test]
fn what_is_no_formula_is_refused_with_its_place() {
    for (text, at) in [
        ("a +", "byte 3"),
        ("(a", "byte 2"),
        ("a = b c)", "byte 7"),
        ("[a; b", "byte 5"),
        ("{a", "byte 1"),
        ("α", "byte 0"),
    ] {
        let error = Equation::parse(text).expect_err(text);
        assert!(error.contains(at), "{error}");
    }
}

fn value(text: &'static str) -> Option<Vec<f64>> {
    let equation = Equation::parse(text).expect("it parses");
    let named = |reference: &Reference| {
        let value: Value = match reference.name {
            "a" => 3.0.into(),
            "n" => 4.0.into(),
            "u" => DVec3::new(1.0, 2.0, 2.0).into(),
            "N" => DVec3::new(0.0, 0.0, -1.0).into(),
            "k_d" => Rgb::new(0.5, 0.25, 1.0).into(),
            "N_k" => {
                let vectors = [DVec3::X, DVec3::Y, DVec3::X];
                return vectors
                    .map(|vector| Term::try_from(Value::from(vector)).ok())
                    .into_iter()
                    .collect();
            }
            "met" => Value::Word("nothing"),
            _ => return None,
        };
        Some(vec![Term::try_from(value).ok()?])
    };
    let term = evaluate(&equation.left, &named)?;
    Some(
        term.components()
            .iter()
            .map(|number| number.value)
            .collect(),
    )
}

#[test]
fn values_follow_the_rules_of_numbers_vectors_and_colours() {
    for (text, expected) in [
        ("1 + 2 · a^2", &[19.0][..]),
        ("2 (a − 1) / 4", &[1.0]),
        ("−a^2", &[-9.0]),
        ("[a; n] u", &[0.75, 1.5, 1.5]),
        ("u · N", &[-2.0]),
        ("u − 2 (u · N) N", &[1.0, 2.0, -2.0]),
        ("|u| + |−a|", &[6.0]),
        ("k_d · k_d · 2", &[0.5, 0.125, 2.0]),
        ("max(0, u · N)^n", &[0.0]),
        ("√n + ⌈[a; 2]⌉ + ⌊[a; 2]⌋", &[5.0]),
        ("min(a, 1, n)", &[1.0]),
        ("arccos 0", &[90.0]),
        ("atan2(−a, 0)", &[270.0]),
        ("atan2(a, −a)", &[135.0]),
        ("arcsin [a; 2]", &[90.0]),
        ("2π", &[std::f64::consts::TAU]),
        ("Σ{*N_k}", &[2.0, 1.0, 0.0]),
    ] {
        let found = value(text).unwrap_or_else(|| panic!("{text} has no value"));
        assert_eq!(found.len(), expected.len(), "{text}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{text}: {found}");
        }
    }
}

#[test]
fn what_does_not_go_together_has_no_value() {
    for text in [
        "a + u", "a / u", "k_d · u", "met", "b", "'x' + a", "√u", "|k_d|",
    ] {
        assert_eq!(value(text), None, "{text}");
    }
}

#[test]
fn the_cross_product_stands_across_both_vectors() {
    // (0, 0, −1) × (1, 0, 0) = (0, −1, 0)
    assert_eq!(value("N × {N_k!}"), Some(vec![0.0, -1.0, 0.0]));
    assert_eq!(value("a × N"), None);
}

#[test]
fn a_sine_and_a_cosine_are_those_of_degrees() {
    for (text, expected) in [("sin 30", 0.5), ("cos 60", 0.5), ("2 cos 180 sin 90", -2.0)] {
        let found = value(text).expect("a value")[0];
        assert!((found - expected).abs() < 1e-15, "{text}: {found}");
    }
}

#[test]
fn a_tangent_is_that_of_degrees() {
    let tan = value("tan 45").expect("a value")[0];
    assert!((tan - 1.0).abs() < 1e-15, "{tan}");
}

#[test]
fn the_error_bound_grows_where_digits_cancel() {
    let exact = |_: &Reference| Some(vec![Term::try_from(Value::Number(1e8)).ok()?]);
    let bound = |text: &'static str| {
        let equation = Equation::parse(text).expect("it parses");
        evaluate(&equation.left, &exact)
            .expect("a value")
            .components()[0]
            .error
    };
    // The sum is rounded at 10⁸, and what is left of it is 1.
    assert_eq!(bound("a + 1 − a"), 1e8 + 2.0);
    assert_eq!(bound("a − a + 1"), 1.0);
}
