use super::*;
use proptest::prelude::*;

fn condition(field: &str, comparison: Comparison, value: Operand) -> Condition {
    Condition {
        field: field.to_owned(),
        comparison,
        value,
    }
}

#[test]
fn what_a_user_types() {
    let parse = |text: &str| text.parse::<Query>().expect(text);
    let edge = parse("EdgeInterpolated y=15 I_4>0.5");
    assert_eq!(edge.kind.as_deref(), Some("EdgeInterpolated"));
    assert_eq!(
        edge.conditions,
        [
            condition("y", Comparison::Equal, Operand::Number(15.0)),
            condition("I_4", Comparison::Above, Operand::Number(0.5)),
        ]
    );
    assert_eq!(
        parse("DepthTested nearer=false").conditions,
        [condition(
            "nearer",
            Comparison::Equal,
            Operand::Truth(false)
        )]
    );
    assert_eq!(
        parse("  y ==  15  N.z<=-1e-3 why!=\"no coefficient\""),
        Query {
            kind: None,
            conditions: vec![
                condition("y", Comparison::Equal, Operand::Number(15.0)),
                condition("N.z", Comparison::AtMost, Operand::Number(-1e-3)),
                condition(
                    "why",
                    Comparison::NotEqual,
                    Operand::Word("no coefficient".to_owned())
                ),
            ],
        }
    );
    assert_eq!(parse("y=15"), parse(" y = 15 "));
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    let cases = [
        (
            "",
            "column 1: expected a kind of event or a condition, such as y=15, found the end",
        ),
        (
            "  ",
            "column 3: expected a kind of event or a condition, such as y=15, found the end",
        ),
        (
            "15",
            "column 1: expected a kind of event or a condition, such as y=15, found `15`",
        ),
        (
            "Ray Hit",
            "column 8: expected a comparison: =, !=, <, <=, > or >=, found the end",
        ),
        (
            "Ray y 15",
            "column 7: expected a comparison: =, !=, <, <=, > or >=, found `15`",
        ),
        (
            "y=15 Ray",
            "column 9: expected a comparison: =, !=, <, <=, > or >=, found the end",
        ),
        (
            "Ray ! y",
            "column 5: expected a condition, such as y=15, found `!`",
        ),
        (
            "y=",
            "column 3: expected a number, true, false or a word, found the end",
        ),
        (
            "y=1e400",
            "column 3: expected a number, true, false or a word, found `1e400`",
        ),
        (
            "y=+inf",
            "column 3: expected a number, true, false or a word, found `+inf`",
        ),
        (
            "y=1.2.3",
            "column 3: expected a number, true, false or a word, found `1.2.3`",
        ),
        (
            "Ray y>high",
            "column 7: expected a number after <, <=, > or >=, found `high`",
        ),
        (
            "I>2*",
            "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*`",
        ),
        (
            "I>2*I@3",
            "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*I@3`",
        ),
        (
            "I>2*I@(Ray I>1*I@(Ray))",
            "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*I@(Ray`",
        ),
        (
            "why=\"no",
            "column 8: expected a closing quotation mark, found the end",
        ),
        (
            "N.w=1",
            "column 1: expected .r, .g or .b of a colour, .x, .y or .z of a vector, found `N.w`",
        ),
        (
            "µ=é",
            "column 1: expected the name of a field, such as I_4, found `µ`",
        ),
        (
            "=3",
            "column 1: expected the name of a field, such as I_4, found `=3`",
        ),
    ];
    for (text, message) in cases {
        let error = text.parse::<Query>().expect_err(text);
        assert_eq!(error.to_string(), message, "{text}");
    }
}

proptest! {
    #[test]
    fn what_is_shown_can_be_typed(
        kind in prop::option::of("[A-Za-z_][A-Za-z0-9_]{0,9}"),
        conditions in prop::collection::vec(("[a-zA-Z_]{1,4}(\\.[rgbxyz])?", 0..6_usize, operand()), 1..4),
    ) {
        let comparisons = SIGNS[1..].iter().map(|&(_, comparison)| comparison);
        let equal_only = |value: &Operand| matches!(value, Operand::Truth(_) | Operand::Word(_));
        let conditions = conditions.into_iter().map(|(field, index, value)| Condition {
            comparison: if equal_only(&value) { Comparison::NotEqual } else { comparisons.clone().nth(index).expect("six") },
            field,
            value,
        });
        let query = Query { kind, conditions: conditions.collect() };
        prop_assert_eq!(query.to_string().parse(), Ok(query));
    }

    #[test]
    fn no_text_makes_it_panic(text in "\\PC{0,20}|[a-z.=<>! \"0-9µ]{0,20}") {
        if let Err(error) = text.parse::<Query>() {
            prop_assert!(error.column <= text.chars().count() + 1);
        }
    }
}

fn operand() -> impl Strategy<Value = Operand> {
    prop_oneof![
        prop::num::f64::NORMAL.prop_map(Operand::Number),
        any::<bool>().prop_map(Operand::Truth),
        "[^\"]{0,8}".prop_map(Operand::Word),
        prop::collection::vec(multiple(), 1..3).prop_map(Operand::Multiples),
    ]
}

fn multiple() -> impl Strategy<Value = Multiple> {
    let at = prop::option::of("[A-Z]{1,4}( [a-z]{1,4}(=|>=)[0-9])?");
    (prop::num::f64::NORMAL, "[a-z_]{1,4}(\\.[rgb])?", at).prop_map(|(factor, field, at)| {
        let at = at.map(|at| at.parse().expect(&at));
        Multiple { factor, field, at }
    })
}
