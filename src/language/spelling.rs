//! Which name was probably meant where one is not known.

/// The known name that is like what was written: a few letters are other, missing, doubled or exchanged; or it begins with that.
pub fn meant<'a>(written: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = written.chars().count();
    let apart = |name: &str| match letters >= 3 && name.starts_with(written) {
        true => 1,
        false => strsim::osa_distance(written, name),
    };
    let named = known.into_iter().map(|name| (apart(name), name));
    let near = named.filter(|&(apart, _)| apart <= 1.max(letters / 3));
    near.min_by_key(|&(apart, _)| apart).map(|(_, name)| name)
}

/// " (did you mean …?)", or nothing.
pub fn suggestion<'a>(written: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let name = meant(written, known);
    name.map_or_else(String::new, |name| format!(" (did you mean {name}?)"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_seen_through_and_another_word_is_none() {
        let known = ["gouraud-triangle", "gouraud-teapot", "steps", "say"];
        for (written, name) in [
            ("gouraud-triangel", Some("gouraud-triangle")),
            ("gouraud-trangle", Some("gouraud-triangle")),
            ("gouraud-tea", Some("gouraud-teapot")),
            ("stpes", Some("steps")),
            ("sya", Some("say")),
            ("lamp", None),
            ("", None),
            ("x", None),
        ] {
            assert_eq!(meant(written, known), name, "{written}");
        }
        assert_eq!(suggestion("stpes", known), " (did you mean steps?)");
        assert_eq!(suggestion("lamp", known), "");
    }
}
