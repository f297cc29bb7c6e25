//! The surface stage: what depends on the fields only.

use super::block::block;
use super::enclosure::{Stage, Value};
use super::folds::enter_fields;
use super::stages::Compiled;
use crate::graph::{Id, Scope};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

impl Compiled<'_> {
    /// `prepare`: the surface stage, in scalars, and in twice the precision if that tells more.
    pub fn prepare(&self) -> TokenStream {
        let (body, top, rows) = self.surface_stage();
        let of = |numbers: TokenStream| {
            quote! {{
                let a = #numbers;
                let mut undefined = false;
                #body
                (#top, undefined, #(#rows,)*)
            }}
        };
        let coarse = of(quote!(__zeroset::scalar()));
        if !self.layout.twice {
            return quote!(fn prepare(&self) -> Self::Prepared { #coarse });
        }
        let fine = of(quote!(__zeroset::Fine));
        let fine_rows = (0..rows.len()).map(|k| format_ident!("fine{k}"));
        let fine_rows: Vec<Ident> = fine_rows.collect();
        quote! {
            fn prepare(&self) -> Self::Prepared {
                let (values, undefined, #(#rows,)*) = #coarse;
                let (fine, _, #(#fine_rows,)*) = #fine;
                (values, undefined, #(#rows,)* fine, #(#fine_rows,)*)
            }
        }
    }

    /// The code of the surface stage, the array of its values without loops, and the names of its rows.
    fn surface_stage(&self) -> (TokenStream, TokenStream, Vec<Ident>) {
        let mut body = TokenStream::new();
        let mut target = self.enclosure(Stage::Surface);
        let mut known = HashMap::new();
        let values = block(
            self.graph,
            &mut target,
            Scope::default(),
            &self.layout.top.values,
            &mut known,
            &mut body,
        );
        let mut rows = Vec::new();
        for (k, (scope, store)) in self.layout.rows.iter().enumerate() {
            let name = format_ident!("rows{k}");
            let code = self.prepared_rows(*scope, &store.values, &known);
            body.extend(quote!(let #name = #code;));
            rows.push(name);
        }
        body.extend(undefined(&values));
        let names = values.iter().map(|v| &v.name);
        (body, quote!([#(#names),*]), rows)
    }

    /// The rows of one scope: a `Vec` per loop.
    fn prepared_rows(
        &self,
        scope: Scope,
        values: &[Id],
        known: &HashMap<Id, Value>,
    ) -> TokenStream {
        let folds: Vec<usize> = scope.folds().collect();
        let mut target = self.enclosure(Stage::Surface);
        let mut known = known.clone();
        let mut body = TokenStream::new();
        let row = block(
            self.graph,
            &mut target,
            scope,
            values,
            &mut known,
            &mut body,
        );
        let (undefined, names) = (undefined(&row), row.iter().map(|v| &v.name));
        let mut code = quote!({ #body #undefined [#(#names),*] });
        for fold in folds.into_iter().rev() {
            let (header, start) = enter_fields(self.graph, self.fields, fold);
            code = quote! {{
                let mut rows = __zeroset::Vec::new();
                #header {
                    #start
                    let row = #code;
                    rows.push(row);
                }
                rows
            }};
        }
        code
    }
}

/// Notes whether any of these values of the surface stage may be undefined.
fn undefined(values: &[Value]) -> TokenStream {
    let flags = values.iter().filter_map(|v| v.flags.as_ref());
    quote!(#(undefined |= __zeroset::may_be_undefined(&#flags);)*)
}
