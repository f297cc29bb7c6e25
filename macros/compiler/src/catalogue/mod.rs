//! Every message of the front end: one constructor per message, and no message anywhere else.
//!
//! The style: lower case, no full stop, no question, and the way out in the help.

/// Defines constructors, and the list of their names for the test that every message has a fixture.
macro_rules! messages {
    ($(
        $(#[$doc:meta])*
        $name:ident($($argument:ident: $ty:ty),* $(,)?) $message:literal $(=> $help:literal)?;
    )*) => {
        $(
            $(#[$doc])*
            pub fn $name(place: Place $(, $argument: $ty)*) -> Diagnostic {
                Diagnostic {
                    code: stringify!($name),
                    place,
                    message: format!($message),
                    help: None$(.or(Some(format!($help))))?,
                }
            }
        )*
        /// The messages of this file, by name.
        pub const MESSAGES: &[&str] = &[$(stringify!($name)),*];
    };
}

pub mod constants;
pub mod head;
pub mod names;
pub mod shapes;
pub mod syntax;
pub mod tokens;

/// All messages, by name, file by file.
pub fn messages() -> Vec<&'static str> {
    [
        constants::MESSAGES,
        head::MESSAGES,
        names::MESSAGES,
        shapes::MESSAGES,
        syntax::MESSAGES,
        tokens::MESSAGES,
    ]
    .concat()
}
