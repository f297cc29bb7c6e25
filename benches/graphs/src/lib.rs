//! What sharing and stages are worth: operations and times of every surface of the zoo, compiled in three forms.

#![forbid(unsafe_code)]

pub mod entry;
pub mod polynomials;
pub mod surfaces;
pub mod table;
pub mod width;

/// The formulas in each form: the module's own macro `implicit` is the one that they use.
macro_rules! form {
    ($d:tt $($module:ident)*) => {
        $(
            /// Formulas of the zoo and of the paper's family, in this form.
            // The same files in every form: that is the comparison.
            #[allow(clippy::duplicate_mod)]
            #[path = "."]
            pub mod $module {
                macro_rules! implicit {
                    ($d($d formula:tt)*) => {
                        zeroset::__private::implicit! { zeroset @$module $d($d formula)* }
                    };
                }
                use implicit;

                pub mod family;
                // There it is imported, here it is in scope.
                #[allow(unused_imports)]
                #[path = "../../../tests/zoo/src/surfaces.rs"]
                pub mod zoo;
            }
        )*
    };
}
form!($ naive shared written staged);
