//! Enums whose values have names.

/// Declares an enum, each value with its name as on the command line and in files; and with that `ALL`, `name` and `from_name`.
macro_rules! named {
    (
        $(#[$meta:meta])*
        pub enum $type:ident { $($(#[$about:meta])* $variant:ident = $name:expr,)* }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $type {
            $($(#[$about])* $variant,)*
        }

        impl $type {
            pub const ALL: [$type; [$($type::$variant),*].len()] = [$($type::$variant),*];

            /// As on the command line and in files.
            pub fn name(self) -> &'static str {
                match self {
                    $($type::$variant => $name,)*
                }
            }

            pub fn from_name(name: &str) -> Option<Self> {
                $type::ALL.into_iter().find(|one| one.name() == name)
            }
        }
    };
}
