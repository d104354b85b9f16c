//! The values that are known at a step, as formulas refer to them.

use crate::record::{Fields, Value};
use crate::replay::{RecordedField, Run, Walk};
use crate::vocabulary::expression::{Equation, Key, Reference, Source, Term};
use crate::vocabulary::{Given, SceneValue};

/// Scopes that are looked through for a value, at each level around a step: enough for an edge table behind a polygon's
/// vertices, and never a whole run.
const MOST_SCOPES: usize = 64;

/// Steps of the same scope that are looked through for a value: enough for what a ray does, and never a whole frame.
const MOST_SIBLINGS: usize = 256;

/// Values of one sum, and steps back to an earlier value. A value beyond is not known.
const MOST_STEPS: usize = 1 << 14;

/// What is known at a step.
pub struct Known<'a> {
    walk: &'a dyn Walk,
    run: &'a Run,
    step: usize,
    own: Fields,
    recorded: Vec<RecordedField>,
    /// What the formulas before define.
    defined: Vec<(&'static str, Term)>,
}

impl<'a> Known<'a> {
    pub fn at(run: &'a Run, step: usize) -> Self {
        let walk = run.walk();
        Known {
            walk,
            run,
            step,
            own: walk.own_fields(step),
            recorded: walk.recorded(step),
            defined: Vec::new(),
        }
    }

    pub fn define(&mut self, name: &'static str, term: Term) {
        self.defined.push((name, term));
    }

    fn defined(&self, reference: &Reference) -> Option<Term> {
        let is_last = reference.source == Source::Last;
        let mut defined = self.defined.iter().filter(|_| is_last);
        let found = defined.find(|(own, _)| *own == reference.name);
        found.map(|(_, term)| *term)
    }

    /// The values that a formula refers to, with the rounding errors of those that the formulas before define.
    pub fn terms(&self, reference: &Reference) -> Option<Vec<Term>> {
        if let Some(term) = self.defined(reference) {
            return Some(vec![term]);
        }
        let values = self.values(reference)?.into_iter();
        values.map(|value| Term::try_from(value).ok()).collect()
    }

    /// The value of that name that formulas show: defined by one before, recorded, or of the scene.
    pub fn last(&self, name: &'static str) -> Option<Value> {
        let reference = Reference {
            other_symbol: None,
            name,
            source: Source::Last,
        };
        self.values(&reference)?.first().copied()
    }

    /// The value that is written so in a formula.
    pub fn referred(&self, text: &'static str) -> Option<Value> {
        self.values(Equation::of(text).subject()?)?.first().copied()
    }

    /// What the step itself recorded.
    #[cfg(test)]
    pub fn own(&self) -> &Fields {
        &self.own
    }

    /// The value recorded last under `name`: by the step and the headings around it, else earlier in the same scope.
    pub fn get(&self, name: &str) -> Option<RecordedField> {
        let mut recorded = self.recorded.iter().rev();
        let recorded = recorded
            .find(|recorded| recorded.field.name == name)
            .copied();
        recorded.or_else(|| self.before(name, None))
    }

    pub fn value(&self, name: &str) -> Option<Value> {
        self.get(name).map(|recorded| recorded.field.value)
    }

    /// The value recorded last under `name` by the steps before in the same scope, and by the ends of the scopes in it, back to
    /// a step of the kind `start`.
    fn before(&self, name: &str, start: Option<&str>) -> Option<RecordedField> {
        self.before_step(self.step, name, start)
    }

    /// The value recorded last under `name`, by the steps before in the same scope or in one around it.
    fn around(&self, name: &str) -> Option<RecordedField> {
        let outline = self.walk.outline();
        let mut steps = std::iter::once(self.step).chain(outline.scopes(self.step));
        steps.find_map(|step| self.before_step(step, name, None))
    }

    /// As [`Known::before`], for another step.
    fn before_step(&self, step: usize, name: &str, start: Option<&str>) -> Option<RecordedField> {
        self.backward(step)
            .take(MOST_SIBLINGS)
            .take_while(|&step| start != Some(self.walk.kind(step)))
            .find_map(|step| {
                let fields = self.walk.own_fields(step);
                let field = *fields.0.iter().rev().find(|field| field.name == name)?;
                Some(RecordedField { step, field })
            })
    }

    /// The steps before in the same scope, and the ends of the scopes in it, backward.
    fn backward(&self, step: usize) -> impl Iterator<Item = usize> + '_ {
        let outline = self.walk.outline();
        let scope = outline.parent(step);
        // Before a step in the scope stands a step of it, or the end of a scope in it.
        let opener = move |end: usize| {
            std::iter::successors(Some(end), |&step| outline.parent(step))
                .find(|&step| outline.parent(step) == scope)
        };
        let before = move |step: usize| Some(step - 1).filter(|&end| Some(end) > scope);
        let first = scope.and_then(|_| before(step));
        std::iter::successors(first, move |&end| before(opener(end)?))
    }

    /// What each part came to that a step of the kind began, the last part first.
    fn parts(&self, name: &str, kind: &str) -> Vec<Value> {
        let mut values = Vec::new();
        let mut is_done = false;
        for step in self.backward(self.step).take(MOST_STEPS) {
            if self.walk.kind(step) == kind {
                is_done = false;
            } else if let (false, Some(value)) = (is_done, self.walk.own_fields(step).get(name)) {
                values.push(value);
                is_done = true;
            }
        }
        values
    }

    /// The values that a formula refers to, one but for sums; none where they are not known.
    pub fn values(&self, reference: &Reference) -> Option<Vec<Value>> {
        let name = reference.name;
        let zero = |start: &Option<&str>| start.map(|_| Value::Number(0.0));
        let values: Vec<Value> = match &reference.source {
            Source::Last => {
                let defined = self.defined(reference).map(|term| term.value());
                match defined.or_else(|| self.value(name)) {
                    Some(value) => vec![value],
                    None => self.of_scene(name)?,
                }
            }
            Source::Before(start) => {
                let before = self.before(name, *start);
                vec![
                    before
                        .map(|recorded| recorded.field.value)
                        .or(zero(start))?,
                ]
            }
            Source::Around => vec![self.around(name)?.field.value],
            Source::All => self.so_far(name)?,
            Source::First => {
                let mut values = self.so_far(name)?.into_iter();
                let is_zero =
                    |value: &Value| matches!(value, Value::Vector(v) if v.length() == 0.0);
                vec![values.find(|value| !is_zero(value))?]
            }
            Source::Parts(kind) => self.parts(name, kind),
            Source::Inside => {
                let scope = self.walk.outline().parent(self.step)?;
                let ends = self
                    .scopes_in(scope, MOST_STEPS)
                    .map(|(_, end)| self.walk.own_fields(end));
                ends.filter_map(|fields| fields.get(name)).collect()
            }
            Source::Beside { key, by } => vec![self.beside(name, key, by)?],
            Source::Earlier {
                options,
                start,
                within,
            } => {
                vec![self.earlier(options, *start, within).or(zero(start))?]
            }
        };
        (!values.is_empty()).then_some(values)
    }

    fn of_scene(&self, name: &str) -> Option<Vec<Value>> {
        let given = Given {
            prepared: self.run.prepared(),
            enclosure: self.run.enclosure(),
            own: &self.own,
        };
        SceneValue::named(name)?.at(given, &|name| {
            let around = || Some(self.around(name)?.field.value);
            self.value(name).or_else(around)
        })
    }

    /// All values of the step's scope under `name`, up to the step.
    fn so_far(&self, name: &str) -> Option<Vec<Value>> {
        let scope = self.walk.outline().parent(self.step)?;
        if self.step - scope > MOST_STEPS {
            return None;
        }
        let fields = (scope + 1..=self.step).map(|step| self.walk.own_fields(step));
        Some(fields.filter_map(|fields| fields.get(name)).collect())
    }

    fn beside(&self, name: &str, key: &str, by: &'static str) -> Option<Value> {
        let word = by.strip_prefix('"').and_then(|by| by.strip_suffix('"'));
        let wanted = word.map(Value::Word).or_else(|| self.value(by));
        let right =
            |fields: &Fields| key.is_empty() || wanted.is_some() && fields.get(key) == wanted;
        let look = |step: usize| {
            let fields = self.walk.own_fields(step);
            fields.get(name).filter(|_| right(&fields))
        };
        let mut steps: Vec<usize> = self.recorded.iter().map(|recorded| recorded.step).collect();
        steps.dedup();
        let recorded = steps.into_iter().rev().find_map(look);
        let around = self.walk.outline().scopes(self.step);
        recorded.or_else(|| {
            around
                .flat_map(|scope| self.scopes_in(scope, MOST_SCOPES).collect::<Vec<_>>())
                .filter(|&(_, end)| end < self.step)
                .find_map(|(scope, end)| {
                    let heading = self.walk.heading(scope, end);
                    heading.chain([end]).find_map(look)
                })
        })
    }

    /// Goes back through this scope and those like it; a scope of another kind than the ones around the step is passed over.
    fn earlier(
        &self,
        options: &[(&'static str, Vec<Key>)],
        start: Option<&str>,
        within: &[&'static str],
    ) -> Option<Value> {
        let outline = self.walk.outline();
        let kinds = || outline.scopes(self.step).map(|scope| self.walk.kind(scope));
        let around: Vec<&str> = match within {
            [] => kinds().collect(),
            within => within.to_vec(),
        };
        let scope_ended_by = |step: usize| {
            outline
                .parent(step)
                .filter(|&scope| outline.last(scope) == step)
        };
        let mut step = scope_ended_by(self.step).unwrap_or(self.step);
        for _ in 0..MOST_STEPS {
            step = step.checked_sub(1)?;
            if start == Some(self.walk.kind(step)) {
                return None;
            }
            match scope_ended_by(step) {
                Some(scope) if !around.contains(&self.walk.kind(scope)) => step = scope,
                _ => {}
            }
            let own = self.walk.own_fields(step);
            let recorded = options.iter().find_map(|(name, keys)| {
                let value = own.get(name)?;
                self.agree(keys, step).then_some(value)
            });
            if recorded.is_some() {
                return recorded;
            }
        }
        None
    }

    /// Whether the values at `step` are those of the keys.
    fn agree(&self, keys: &[Key], step: usize) -> bool {
        if keys.is_empty() {
            return true;
        }
        let there = self.walk.fields(step);
        keys.iter()
            .all(|key| match (there.get(key.name), self.value(key.by)) {
                (Some(Value::Integer(a)), Some(Value::Integer(b))) => a == b + key.offset,
                (a, b) => a.is_some() && a == b,
            })
    }

    /// First and last step of the first scopes directly in `scope`, at most so many.
    fn scopes_in(&self, scope: usize, most: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let outline = self.walk.outline();
        let end = outline.last(scope);
        let first = (scope + 1 < end).then_some(scope + 1);
        std::iter::successors(first, move |&step| {
            Some(outline.last(step) + 1).filter(|&next| next < end)
        })
        .take(2 * most)
        .filter(move |&step| outline.opens(step))
        .take(most)
        .map(move |step| (step, outline.last(step)))
    }
}
