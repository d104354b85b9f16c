use super::*;

#[test]
fn a_number_stands_where_its_places_say_and_a_colour_keeps_its_hue() {
    let path = Path::parse("a").unwrap();
    let place = |own: Value, times: f64, plus: f64| Place {
        path: path.clone(),
        times,
        plus,
        own,
    };
    let half = place(0.25.into(), -0.5, 0.5);
    assert_eq!(half.parameter(), Some(0.5));
    assert_eq!(half.written(1.0, false), Value::from(0.0));
    let red = place(serde_json::json!([0.8, 0.2, 0.2]), 1.0, 0.0);
    assert_eq!(red.parameter(), Some(0.8));
    assert_eq!(red.written(0.4, false), serde_json::json!([0.4, 0.1, 0.1]));
    let black = place(serde_json::json!([0, 0, 0]), 1.0, 0.0);
    assert_eq!(
        black.written(0.4, false),
        serde_json::json!([0.4, 0.4, 0.4])
    );
    assert_eq!(place(3.into(), 1.0, 0.0).written(4.6, true), Value::from(5));
    assert_eq!(place("word".into(), 1.0, 0.0).parameter(), None);
}

#[test]
fn a_path_leads_through_keys_and_indices() {
    let mut document = serde_json::json!({ "scene": { "objects": [{}, { "at": [1, 2.5] }] } });
    let path = Path::parse("scene.objects[1].at[1]").unwrap();
    assert_eq!(path.find(&mut document), Some(&mut Value::from(2.5)));
    let other = Path::parse("scene.objects[2].at[1]").unwrap();
    assert_eq!(other.find(&mut document), None);
    for wrong in ["", "a..b", "a[", "a[x]", "[1]"] {
        assert_eq!(Path::parse(wrong), None, "{wrong}");
    }
}
