//! What objects, lights and rays are called.

use super::message::labelled;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, Message, called};
use crate::methods::Method;
use crate::panels::said;
use crate::record::Value;
use crate::replay::{Run, Walk};
use crate::scene::Light;
use crate::vocabulary::expression::Reference;
use crate::vocabulary::{Kind, Quantity, SceneValue, counted, find};

/// A word that an event records, as people read it.
pub fn word(word: &'static str, language: Language) -> String {
    called("value", word, language).unwrap_or_else(|| word.to_string())
}

/// A kind of event, as people read it.
pub fn kind(kind: &str, language: Language) -> String {
    called("kind", kind, language).unwrap_or_else(|| kind.to_string())
}

/// The name of a recorded value in a sentence: as lessons and searches write it, unless it is a word.
pub fn field(name: &'static str, language: Language) -> String {
    called("quantity", name, language).unwrap_or_else(|| name.to_string())
}

/// A recorded quantity: its symbol, where it has one that is no word.
pub fn quantity(quantity: &Quantity, language: Language) -> String {
    called("quantity", quantity.name, language).unwrap_or_else(|| quantity.symbol.to_string())
}

/// What the value of that name says at a step, after its symbol; none where no step before recorded it.
pub fn meaning(walk: &dyn Walk, step: usize, name: &str, language: Language) -> Option<String> {
    let recorded = walk.recorded(step);
    let recorded = recorded.iter().rfind(|value| value.field.name == name)?;
    let kind = walk.declared(recorded.step);
    let symbol = quantity(kind.quantity(name)?, language);
    let meaning = kind.meaning(name, language)?;
    Some(labelled(&symbol, &meaning, language))
}

/// The same, with what the step says that recorded the value, where it is another one.
pub fn meaning_and_origin(
    run: &Run,
    step: usize,
    name: &str,
    language: Language,
) -> Option<String> {
    let walk = run.walk();
    let meaning = meaning(walk, step, name, language)?;
    let recorded = walk.recorded(step);
    let origin = recorded
        .iter()
        .rfind(|value| value.field.name == name)?
        .step;
    if origin == step {
        return Some(meaning);
    }
    let arguments = [
        ("meaning", &*meaning),
        ("step", &origin.to_string()),
        ("sentence", &said(run, origin, language)),
    ];
    Some(Message("names-meaning-and-origin").format(language, &arguments))
}

/// What a formula writes for a value: the quantity's own symbol, in words where it is one, or the symbol chosen there.
pub fn symbol(reference: &Reference, language: Language) -> String {
    let symbol = reference.symbol();
    if let Some(of_scene) = SceneValue::named(reference.name).filter(|own| own.symbol == symbol) {
        let called = called("quantity", reference.name, language);
        return called.unwrap_or_else(|| of_scene.symbol.to_string());
    }
    match find(reference.name).filter(|quantity| quantity.symbol == symbol) {
        Some(own) => quantity(&own, language),
        // A value before this step.
        None => symbol.replace(
            ",old}",
            &format!(",{}}}", Message("symbol-old").text(language)),
        ),
    }
}

/// The object of that number.
pub fn object(prepared: &PreparedScene, number: u32, language: Language) -> &str {
    let object = prepared.scene.objects.get(number as usize);
    object.map_or("", |object| prepared.scene.called(&object.name, language))
}

/// A method, as people read it.
pub fn method(method: Method, language: Language) -> String {
    called("method", method.name(), language).unwrap_or_else(|| method.name().to_string())
}

/// A patch of the room: its object, and its cell where there is more than one.
pub fn patch(
    prepared: &PreparedScene,
    room: &Enclosure,
    number: usize,
    language: Language,
) -> String {
    let patch = &room.patches[number];
    let name = object(prepared, patch.object, language);
    let [nu, nv] = room.patches.surfaces[patch.object as usize].grid;
    match patch.cell {
        _ if nu * nv == 1 => name.to_string(),
        [i, _] if nv == 1 => format!("{name} {i}"),
        [i, j] => format!("{name} ({i}, {j})"),
    }
}

/// The light of that number: lights have no names.
pub fn light(number: u32, language: Language) -> String {
    Message("names-light").format(language, &[("number", &number.to_string())])
}

/// A scope by its kind and number: `Iteration 3`.
pub fn numbered(kind: &str, number: &str, language: Language) -> String {
    Message("names-numbered").format(language, &[("kind", kind), ("number", number)])
}

/// What the number recorded under a field's name stands for, where it stands for a thing of the scene.
pub fn of_field<'a>(
    prepared: &'a PreparedScene,
    field: &str,
    value: Value,
    language: Language,
) -> Option<&'a str> {
    let Value::Integer(number) = value else {
        return None;
    };
    let number = u32::try_from(number).ok()?;
    match field {
        "object" | "blocker" => {
            Some(object(prepared, number, language)).filter(|name| !name.is_empty())
        }
        "light" => Some(match prepared.scene.lights.get(number as usize)? {
            Light::Point { .. } => Message("names-point-light").text(language),
            Light::Directional { .. } => Message("names-directional-light").text(language),
        }),
        _ => None,
    }
}

/// A kind of ray in words, and the letters that stand for it in drawings.
pub fn ray_kind(name: &'static str, language: Language) -> (String, &'static str) {
    let letters = match name {
        "reflected" => "R",
        "transmitted" => "T",
        "total_internal_reflection" => "TIR",
        _ => "P",
    };
    (word(name, language), letters)
}

/// What the scope is called that an event of `kind` opens.
pub fn scope_kind(kind: &Kind, language: Language) -> String {
    match kind.scope {
        Some(scope) => scope.text(language).to_string(),
        None => self::kind(kind.name, language),
    }
}

/// What the scope is called that `step` opens, as far as it is known at the step `now`, from the longest form to the shortest: of a
/// ray, its kind and what it meets; of others, their kind with their number, and the number alone.
pub fn scope_known_at(run: &Run, step: usize, now: usize, language: Language) -> Vec<String> {
    let walk = run.walk();
    if let Some(ray) = ray(run, step, now, language) {
        return ray.to_vec();
    }
    let kind = scope_kind(walk.declared(step), language);
    match scope_number(walk, step, language) {
        Some(number) => vec![numbered(&kind, &number, language), number],
        None => vec![kind],
    }
}

/// The iteration that `step` closes, with its number.
pub fn iteration_ended(walk: &dyn Walk, step: usize, language: Language) -> Option<String> {
    let scope = walk.outline().parent(step)?;
    if walk.kind(step) != "IterationDone" {
        return None;
    }
    let kind = scope_kind(walk.declared(scope), language);
    let number = scope_number(walk, scope, language)?;
    Some(numbered(&kind, &number, language))
}

/// What distinguishes a scope from others of its kind, by the declaration of the kind: a number, a word, or two numbers.
pub fn scope_number(walk: &dyn Walk, scope: usize, language: Language) -> Option<String> {
    let own = walk.own_fields(scope);
    let number = |&name: &&str| match counted(name, own.get(name)?) {
        Value::Integer(number) => Some(number.to_string()),
        Value::Word(value) => Some(word(value, language)),
        _ => None,
    };
    let numbers: Vec<String> = walk
        .declared(scope)
        .numbers
        .iter()
        .filter_map(number)
        .collect();
    match &numbers[..] {
        [] => None,
        [number] => Some(number.clone()),
        [first, last] if walk.declared(scope).numbers == ["first", "last"] => {
            Some(format!("{first}–{last}"))
        }
        _ => Some(format!("({})", numbers.join(", "))),
    }
}

/// What the ray is called that `scope` opens, from the longest form to the shortest: its kind and what it meets, its kind,
/// its letters. Of several rays of a pixel each has its number.
fn ray(run: &Run, scope: usize, now: usize, language: Language) -> Option<[String; 3]> {
    let walk = run.walk();
    // A ray of the Monte Carlo method is no scope.
    if walk.kind(scope) != "Ray" || !walk.outline().opens(scope) {
        return None;
    }
    // Ray casting follows primary rays alone, and does not say so of each.
    let (kind, letters) = match walk.own_fields(scope).get("ray") {
        Some(Value::Word(kind)) => ray_kind(kind, language),
        _ => ray_kind("primary", language),
    };
    let sample = scope
        .checked_sub(1)
        .filter(|&step| walk.kind(step) == "Through");
    let sample = sample.and_then(|step| walk.own_fields(step).get("sample"));
    let (kind, letters) = match sample {
        Some(Value::Integer(sample)) => {
            let number = sample.to_string();
            (
                numbered(&kind, &number, language),
                format!("{letters}{number}"),
            )
        }
        _ => (kind, letters.to_string()),
    };
    let goes = match goal(run, scope, now, language) {
        Some(goal) => {
            Message("names-ray-meets").format(language, &[("ray", &kind), ("thing", &goal)])
        }
        None => kind.clone(),
    };
    Some([goes, kind, letters])
}

/// What the ray meets that `scope` opens: its search says so at its end.
fn goal(run: &Run, scope: usize, now: usize, language: Language) -> Option<String> {
    let walk = run.walk();
    let search = Some(scope + 1).filter(|&step| step < walk.len())?;
    let found = walk.outline().last(search);
    if walk.kind(search) != "Search" || found > now {
        return None;
    }
    let found = walk.own_fields(found);
    let number = |name| match found.get(name) {
        Some(Value::Integer(number)) => u32::try_from(number).ok(),
        _ => None,
    };
    match found.get("met")? {
        Value::Word("object") => {
            Some(object(run.prepared(), number("object")?, language).to_string())
        }
        Value::Word("light") => Some(light(number("light")?, language)),
        _ => Some(Message("names-background").text(language).to_string()),
    }
}
