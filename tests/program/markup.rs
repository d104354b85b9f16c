//! A reader of well-formed markup: SVG, and HTML as the program writes it.

/// Elements that HTML never closes.
const VOID: [&str; 2] = ["meta", "br"];

/// The names of all elements, in order. Every element is closed, in turn, and every ampersand begins an entity.
pub fn elements(text: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let mut open = Vec::new();
    for part in text.split('<').skip(1) {
        let (tag, words) = part
            .split_once('>')
            .unwrap_or_else(|| panic!("<{part} is not closed"));
        let quotes = tag.matches('"').count();
        assert!(
            quotes.is_multiple_of(2),
            "<{tag}> has a quotation mark by itself"
        );
        for entity in words.split('&').skip(1) {
            let known = ["amp;", "lt;", "gt;", "quot;"];
            assert!(
                known.iter().any(|name| entity.starts_with(name)),
                "&{entity}"
            );
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "</{name}> in {open:?}");
            continue;
        }
        if tag.starts_with('!') {
            continue;
        }
        let name = tag.split([' ', '/']).next().unwrap();
        names.push(name);
        if !tag.ends_with('/') && !VOID.contains(&name) {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?} are not closed");
    names
}
