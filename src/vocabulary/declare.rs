//! The macro that declares the kinds of an event type, and what follows from the declaration.

use super::kind::Kind;
use crate::algorithms::scan_line::{Named, Names};
use crate::color::Rgb;
use crate::record::{Fields, Value};
use glam::DVec3;

/// An event whose kind is declared.
pub trait Declared: Copy {
    /// Its kind, and the label of the line of pseudocode that it carries out; its values are appended to `fields`, if any.
    fn declaration(&self, fields: Option<&mut Fields>) -> (&'static Kind, &'static str);

    fn kind(&self) -> &'static Kind {
        self.declaration(None).0
    }

    fn label(&self) -> &'static str {
        self.declaration(None).1
    }

    fn push_fields(&self, fields: &mut Fields) {
        self.declaration(Some(fields));
    }
}

/// What an event gives under the name of a quantity.
pub trait Recorded {
    fn push(self, name: &'static str, fields: &mut Fields);
}

macro_rules! recorded {
    ($($type:ty),*) => {
        $(impl Recorded for $type {
            fn push(self, name: &'static str, fields: &mut Fields) {
                fields.push(name, Value::from(self));
            }
        })*
    };
}
recorded!(f64, u32, u16, Rgb, DVec3, bool, &'static str);

/// A value that only some events of the kind have.
impl<T: Recorded> Recorded for Option<T> {
    fn push(self, name: &'static str, fields: &mut Fields) {
        if let Some(value) = self {
            value.push(name, fields);
        }
    }
}

/// An interpolated value, under the name that its method gives it.
pub struct Interpolated<A>(pub A, pub fn(&Names) -> &'static str);

impl<A: Named> Recorded for Interpolated<A> {
    fn push(self, _: &'static str, fields: &mut Fields) {
        if let (Some(names), Some(value)) = (A::NAMES, self.0.value()) {
            fields.push(self.1(names), value);
        }
    }
}

/// Declares the kinds of an event type:
///
/// ```text
/// pattern => "Name" at "label" [or "label" if condition,]… [number "field", …] [scope "key of its name"]
///     { "quantity" = value, … }
///     [ entry, … ];
/// ```
///
/// Where several quantities stand before a value (`"I_4" | "N_4"`), the value chooses its name. Events that wrap others
/// delegate to them.
macro_rules! vocabulary {
    (@kind $name:literal, $label:literal, [$($other:literal)*], [$($number:literal)*], [$($scope:expr)?],
        [$($field:literal)*], [$($entry:expr),*]
    ) => {
        $crate::vocabulary::Kind {
            name: $name,
            quantities: &[$($crate::vocabulary::quantity($field)),*],
            labels: &[$label $(, $other)*],
            scope: vocabulary!(@option $($scope)?),
            numbers: &[$($number),*],
            entries: &[$($entry),*],
        }
    };
    (@option) => { None };
    (@option $some:expr) => { Some($some) };
    (@label $label:literal) => { $label };
    (@label $label:literal or $other:literal if $condition:expr $(, or $more:literal if $further:expr)*) => {
        if $condition { $other } else { vocabulary!(@label $label $(or $more if $further),*) }
    };
    (
        [$($generics:tt)*] $event:ty { $($outer:pat => $inner:ident,)* };
        $(
            $pattern:pat $(if $guard:expr)? => $name:literal at $label:literal $(or $other:literal if $condition:expr,)*
                $(number $($number:literal),+)? $(scope $scope:literal)?
                { $($($field:literal)|+ = $value:expr),* $(,)? }
                [ $($entry:expr),* $(,)? ];
        )*
    ) => {
        /// All kinds that are declared here.
        pub const KINDS: &[$crate::vocabulary::Kind] = &[$(
            vocabulary!(@kind $name, $label, [$($other)*], [$($($number)+)?],
                [$($crate::language::Message($scope))?], [$($($field)+)*], [$($entry),*])
        ),*];

        impl<$($generics)*> $crate::vocabulary::Declared for $event {
            fn declaration(
                &self,
                fields: Option<&mut $crate::record::Fields>,
            ) -> (&'static $crate::vocabulary::Kind, &'static str) {
                match *self {
                    $($outer => $inner.declaration(fields),)*
                    $($pattern $(if $guard)? => {
                        const KIND: $crate::vocabulary::Kind =
                            vocabulary!(@kind $name, $label, [$($other)*], [$($($number)+)?],
                                [$($crate::language::Message($scope))?], [$($($field)+)*], [$($entry),*]);
                        if let Some(fields) = fields {
                            $($crate::vocabulary::declare::Recorded::push($value, [$($field),+][0], fields);)*
                            // A kind without values leaves it untouched.
                            let _ = fields;
                        }
                        (&KIND, vocabulary!(@label $label $(or $other if $condition),*))
                    })*
                }
            }
        }
    };
}
