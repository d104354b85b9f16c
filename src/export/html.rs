//! Words and pictures as HTML.

use crate::picture::{Picture, Run, Script, Theme, braced, math, prose, svg_element};

/// What HTML cannot hold as it is.
pub fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

/// A text with symbols and code, as lessons write it. As in the window, one letter by itself may be a word, and is upright.
pub fn words(text: &str) -> String {
    let runs = prose(text);
    let set = |run: Run| {
        let text = escaped(&run.text).replace('\n', "<br>");
        let text = match run.code {
            true => format!("<code>{text}</code>"),
            false => text,
        };
        scripted(text, run.script)
    };
    runs.into_iter().map(set).collect()
}

/// A line of pseudocode.
pub fn code(line: &str) -> String {
    let runs = math(&braced(line)).into_iter();
    let set = runs.map(|run| scripted(escaped(&run.text), run.script));
    format!("<code>{}</code>", set.collect::<String>())
}

fn scripted(text: String, script: Script) -> String {
    match script {
        Script::Base => text,
        Script::Sub => format!("<sub>{text}</sub>"),
        Script::Super => format!("<sup>{text}</sup>"),
    }
}

/// A picture of that title, with ids of its own.
pub fn figure(picture: &Picture, title: &str, theme: Theme, class: &str, id: &str) -> String {
    let svg = svg_element(picture, title, theme, id);
    format!("<figure class=\"{class}\">{svg}</figure>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_and_code_are_set_and_nothing_is_markup() {
        assert_eq!(
            words("I_4 < 0.9^30 & `a_b`"),
            "I<sub>4</sub> &lt; 0.9<sup>30</sup> &amp; <code>a_b</code>"
        );
        assert_eq!(
            code("f_att ← 1 < 2"),
            "<code>f<sub>att</sub> ← 1 &lt; 2</code>"
        );
    }
}
