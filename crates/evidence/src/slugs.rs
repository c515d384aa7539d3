//! Enums whose values have names in data.

/// Gives an enum the names it has in data, and shows it by them.
macro_rules! slugs {
    ($type:ident { $($variant:ident = $slug:literal),+ $(,)? }) => {
        impl $type {
            /// All values.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The name used in data.
            pub fn slug(self) -> &'static str {
                match self { $(Self::$variant => $slug),+ }
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.slug())
            }
        }
    };
}

pub(crate) use slugs;
