//! Mathematical notation in plain text: `I_4`, `N_{v}`, `a^2`, and the names of event fields made readable.

/// Where a run stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Script {
    Base,
    Sub,
    Super,
}

/// A piece of a formula in one face and place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Run {
    pub text: String,
    pub script: Script,
    /// Variables are italic in formulas: letters that stand alone, and indices.
    pub italic: bool,
    /// What a user types, or a name of a file: set as such, and never as mathematics.
    pub code: bool,
}

/// The runs of a text for people: `f_att` and `x^30` are set as mathematics, what stands between back-ticks is code.
pub fn prose(text: &str) -> Vec<Run> {
    let mut runs = Vec::new();
    for (i, part) in text.split('`').enumerate() {
        if i % 2 == 1 {
            runs.push(Run {
                text: part.to_string(),
                script: Script::Base,
                italic: false,
                code: true,
            });
        } else {
            runs.extend(math(&braced(part)));
        }
    }
    runs
}

/// Splits `text` into runs. `_` and `^` lower or raise the next character, a whole number, or what stands in `{…}` or `(…)` after
/// them; with nothing after them they stand for themselves.
pub fn math(text: &str) -> Vec<Run> {
    let mut runs = Vec::new();
    let mut base = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        let script = match c {
            '_' => Script::Sub,
            '^' => Script::Super,
            _ => Script::Base,
        };
        let index = match script {
            Script::Base => None,
            _ => index(rest),
        };
        match index {
            Some((text, after)) => {
                push_base(&mut runs, &mut base);
                let italic = is_variable(text) || text.chars().all(|c| "ijkmn".contains(c));
                let mut text = text.to_string();
                rest = after;
                // An exponent’s own index: cos^n_s
                if let (Script::Super, Some(indexed)) = (script, rest.strip_prefix('_'))
                    && let Some((lowered, after)) = self::index(indexed)
                    && let Some(lowered) =
                        lowered.chars().map(subscript).collect::<Option<String>>()
                {
                    text.push_str(&lowered);
                    rest = after;
                }
                runs.push(Run {
                    text,
                    script,
                    italic,
                    code: false,
                });
            }
            None => base.push(c),
        }
    }
    push_base(&mut runs, &mut base);
    runs
}

/// A text for people where nothing can be set, as in the title of a window: indices are characters of their own where
/// Unicode has them.
pub fn plain(text: &str) -> String {
    let written = |run: Run| match run.script {
        Script::Sub => {
            let lowered = run.text.chars().map(subscript).collect();
            Option::<String>::unwrap_or_else(lowered, || format!("_{}", run.text))
        }
        Script::Super => format!("^{}", run.text),
        Script::Base => run.text,
    };
    prose(text).into_iter().map(written).collect()
}

/// The character that Unicode has for a lowered one.
fn subscript(character: char) -> Option<char> {
    const SUBSCRIPTS: [(&str, &str); 3] = [
        ("0123456789", "₀₁₂₃₄₅₆₇₈₉"),
        ("aehijklmno", "ₐₑₕᵢⱼₖₗₘₙₒ"),
        ("prstuvx", "ₚᵣₛₜᵤᵥₓ"),
    ];
    let pairs = SUBSCRIPTS
        .iter()
        .flat_map(|(from, to)| from.chars().zip(to.chars()));
    pairs
        .into_iter()
        .find(|(from, _)| *from == character)
        .map(|(_, to)| to)
}

/// What is lowered or raised at the start of `text`, and what follows it.
fn index(text: &str) -> Option<(&str, &str)> {
    let first = text.chars().next().filter(|c| *c != ' ')?;
    let closing = match first {
        '{' => Some('}'),
        '(' => Some(')'),
        _ => None,
    };
    if let Some(closing) = closing {
        let inside = &text[1..];
        return Some(inside.split_once(closing).unwrap_or((inside, "")));
    }
    let sign = if matches!(first, '−' | '-') {
        first.len_utf8()
    } else {
        0
    };
    let digits = |text: &str| {
        text.find(|c: char| !c.is_ascii_digit())
            .unwrap_or(text.len())
    };
    let mut end = sign + digits(&text[sign..]);
    if end == sign {
        return Some(text.split_at(first.len_utf8()));
    }
    // A decimal exponent, but not the end of a sentence
    if let Some(fraction) = text[end..].strip_prefix(['.', ',']) {
        end += match digits(fraction) {
            0 => 0,
            length => 1 + length,
        };
    }
    Some(text.split_at(end))
}

/// Subscripts of several letters in braces, as [`math`] reads them: `f_att` → `f_{att}`. For prose and code, where nobody writes braces.
pub fn braced(text: &str) -> String {
    let mut braced = String::with_capacity(text.len() + 8);
    let mut rest = text;
    while let Some(at) = rest.find('_') {
        let (before, index) = (&rest[..at], &rest[at + 1..]);
        let end = index
            .find(|c: char| !c.is_alphanumeric())
            .unwrap_or(index.len());
        braced.push_str(before);
        match end {
            0 => braced.push('_'),
            _ => braced.push_str(&format!("_{{{}}}", &index[..end])),
        }
        rest = &index[end..];
    }
    braced + rest
}

/// Splits text on the base line into upright and italic runs, and empties it.
fn push_base(runs: &mut Vec<Run>, base: &mut String) {
    let mut push = |text: &str, italic| {
        if !text.is_empty() {
            runs.push(Run {
                text: text.to_string(),
                script: Script::Base,
                italic,
                code: false,
            });
        }
    };
    let mut rest = base.as_str();
    let mut upright = 0;
    while let Some(start) = rest[upright..].find(is_letter).map(|at| at + upright) {
        let word = &rest[start..];
        let end = start + word.find(|c| !is_letter(c)).unwrap_or(word.len());
        if is_variable(&rest[start..end]) {
            push(&rest[..start], false);
            push(&rest[start..end], true);
            rest = &rest[end..];
            upright = 0;
        } else {
            upright = end;
        }
    }
    push(rest, false);
    base.clear();
}

/// Whether a word is one letter, and so a variable.
fn is_variable(word: &str) -> bool {
    let mut letters = word.chars();
    matches!((letters.next(), letters.next()), (Some(c), None) if is_letter(c))
}

/// Letters that variables are made of: Δ and Σ are operators.
fn is_letter(c: char) -> bool {
    c.is_alphabetic() && !matches!(c, 'Δ' | 'Σ' | 'Π') && !('ⁱ'..='ₜ').contains(&c)
}

const GREEK: [(&str, &str); 12] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "Δ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("lambda", "λ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("phi", "φ"),
    ("omega", "ω"),
];

/// A field's ASCII name in the notation that [`math`] reads: `I_4_incremental` → `I_4 incremental`, `N_dot_L` → `N·L`,
/// `dI_dy` → `ΔI/Δy`, `k_spec` → `k_{spec}`, `to_light` → `to light`.
pub fn symbol(name: &str) -> String {
    let parts: Vec<&str> = name.split('_').filter(|part| !part.is_empty()).collect();
    let (symbol, words) = match parts.as_slice() {
        [] => return name.to_string(),
        [a, "dot", b, words @ ..] => (format!("{}·{}", letter(a), letter(b)), words),
        ["one", "over", a, words @ ..] => (format!("1/{}", letter(a)), words),
        [a, "squared", words @ ..] => (format!("{}^2", letter(a)), words),
        ["cos", angle, index] => (format!("cos {}_{index}", letter(angle)), &[][..]),
        ["cos2", angle, index] => (format!("cos^2 {}_{index}", letter(angle)), &[][..]),
        [a, b, words @ ..] if is_difference(a) && is_difference(b) => {
            (format!("Δ{}/Δ{}", &a[1..], &b[1..]), words)
        }
        [a, words @ ..] if is_difference(a) => (format!("Δ{}", &a[1..]), words),
        [a, index, words @ ..] if is_variable(&letter(a)) => {
            let index = letter(index);
            let one = index.chars().count() == 1;
            let script = if one { index } else { format!("{{{index}}}") };
            (format!("{}_{script}", letter(a)), words)
        }
        [a, words @ ..] => (letter(a), words),
    };
    std::iter::once(symbol.as_str())
        .chain(words.iter().copied())
        .collect::<Vec<_>>()
        .join(" ")
}

/// The Greek letter of that name, or the name.
fn letter(name: &str) -> String {
    let greek = GREEK.iter().find(|(ascii, _)| *ascii == name);
    greek.map_or(name, |(_, letter)| letter).to_string()
}

/// Whether a name is a difference of one variable: `dI`, `dy`.
fn is_difference(name: &str) -> bool {
    matches!(name.as_bytes(), [b'd', letter] if letter.is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs written back: italics in slashes, scripts in brackets, code in angle brackets.
    fn written(runs: Vec<Run>) -> String {
        runs.into_iter()
            .map(|run| {
                let text = match run {
                    Run { italic: true, .. } => format!("/{}/", run.text),
                    Run { code: true, .. } => format!("<{}>", run.text),
                    _ => run.text,
                };
                match run.script {
                    Script::Base => text,
                    Script::Sub => format!("[{text}]"),
                    Script::Super => format!("[^{text}]"),
                }
            })
            .collect()
    }

    #[test]
    fn subscripts_of_several_letters_are_kept_together() {
        assert_eq!(braced("f_att ← 1/(a0)"), "f_{att} ← 1/(a0)");
        assert_eq!(braced("ΣN_k / |ΣN_k|"), "ΣN_{k} / |ΣN_{k}|");
        assert_eq!(
            braced("F_ij, N_{v} and _ alone"),
            "F_{ij}, N_{v} and _ alone"
        );
        assert_eq!(braced("for each polygon"), "for each polygon");
    }

    #[test]
    fn runs() {
        for (text, expected) in [
            ("I_4 = 0.514", "/I/[4] = 0.514"),
            ("N_{avg}", "/N/[avg]"),
            ("cos^2 θ_r", "cos[^2] /θ/[/r/]"),
            ("F_{ij}·A_i", "/F/[/ij/]·/A/[/i/]"),
            ("ΔI/Δy", "Δ/I//Δ/y/"),
            ("N·L a b", "/N/·/L/ /a/ /b/"),
            ("unshot_i", "unshot[/i/]"),
            ("x_i^2", "/x/[/i/][^2]"),
            ("a_", "/a/_"),
            ("a _ b", "/a/ _ /b/"),
            ("x_{12", "/x/[12]"),
            ("0.936^30 = 14 %", "0.936[^30] = 14 %"),
            ("x_10, 10^−12 and 2^2.", "/x/[10], 10[^−12] and 2[^2]."),
            ("0,99^12,5, then", "0,99[^12,5], then"),
            ("(R·V)^n_{s}", "(/R/·/V/)[^/nₛ/]"),
            ("e^(−a·d)).", "/e/[^−a·d])."),
            ("M^{−1} s", "/M/[^−1] /s/"),
            ("", ""),
        ] {
            assert_eq!(written(math(text)), expected, "{text}");
        }
    }

    #[test]
    fn prose_has_mathematics_and_code() {
        assert_eq!(
            written(prose("F_jj = 0 in `path_attenuation`; 0.936^30.")),
            "/F/[/jj/] = 0 in <path_attenuation>; 0.936[^30]."
        );
    }

    #[test]
    fn plain_text_has_indices_of_its_own() {
        assert_eq!(plain("F_jj = 0, N_v and f_att"), "Fⱼⱼ = 0, Nᵥ and fₐₜₜ");
        assert_eq!(plain("F_B"), "F_B");
    }

    #[test]
    fn names_of_fields() {
        for (name, expected) in [
            ("I_4", "I_4"),
            ("I_4_incremental", "I_4 incremental"),
            ("x_P", "x_P"),
            ("k_d", "k_d"),
            ("f_att", "f_{att}"),
            ("theta_r", "θ_r"),
            ("rho", "ρ"),
            ("N_dot_L", "N·L"),
            ("N_dot_H_clamped", "N·H clamped"),
            ("dI_dy", "ΔI/Δy"),
            ("dI", "ΔI"),
            ("one_over_w", "1/w"),
            ("d_squared", "d^2"),
            ("to_light", "to light"),
            ("cos_theta_i", "cos θ_i"),
            ("cos2_theta_r", "cos^2 θ_r"),
            ("theta_i_degrees", "θ_i degrees"),
            ("difference", "difference"),
            ("_", "_"),
        ] {
            assert_eq!(symbol(name), expected, "{name}");
        }
    }
}
