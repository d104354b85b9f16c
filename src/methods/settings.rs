//! The settings of the methods: each type of settings is declared where it is used.

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

/// Settings of one or several methods, at most one value of each type.
#[derive(Clone, Debug, Default)]
pub struct Settings(Vec<Arc<dyn AnySettings>>);

/// A value of some type of settings.
trait AnySettings: Any + Debug + Send + Sync {
    fn equals(&self, other: &dyn Any) -> bool;
}

impl<S: Any + Debug + PartialEq + Send + Sync> AnySettings for S {
    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

/// Where one has no value of a type, the other has none.
impl PartialEq for Settings {
    fn eq(&self, other: &Self) -> bool {
        let has = |value: &Arc<dyn AnySettings>| other.0.iter().any(|one| value.equals(&**one));
        self.0.len() == other.0.len() && self.0.iter().all(has)
    }
}

impl Settings {
    /// The settings of type `S`: its defaults, where there is no value of it.
    pub fn get<S: Copy + Default + 'static>(&self) -> S {
        let mut values = self.0.iter().map(|value| &**value as &dyn Any);
        values
            .find_map(|value| value.downcast_ref().copied())
            .unwrap_or_default()
    }

    /// The same with `value` in place of what there was of its type.
    pub fn with<S: Copy + Debug + PartialEq + Send + Sync + 'static>(mut self, value: S) -> Self {
        self.0.retain(|old| !(&**old as &dyn Any).is::<S>());
        self.0.push(Arc::new(value));
        self
    }
}

impl<S: Copy + Debug + PartialEq + Send + Sync + 'static> From<S> for Settings {
    fn from(value: S) -> Self {
        Settings::default().with(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    struct Taylor(u32);

    #[test]
    fn each_type_of_settings_has_one_value_or_its_default() {
        let settings = Settings::from(Taylor(2)).with(0.5).with(Taylor(3));
        assert_eq!(settings.get::<Taylor>(), Taylor(3));
        assert_eq!(settings.get::<f64>(), 0.5);
        assert_eq!(Settings::default().get::<Taylor>(), Taylor(0));
        assert_eq!(settings, Settings::from(0.5).with(Taylor(3)));
        assert_ne!(settings, Settings::from(0.5).with(Taylor(2)));
        assert_ne!(settings, Settings::from(0.5));
    }
}
