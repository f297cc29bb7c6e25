//! Code in the runtime's `Arithmetic`: interval packets, scalars, plain float vectors.

use super::block::{Declared, Instead, Target};
use super::choices::{Choices, Side, branches};
use super::folds::{Visit, accumulator, enter_fields, enter_fine_rows, enter_rows};
use super::layout::Layout;
use super::regions::alive;
use super::text::{flags, index, interval, number, variable};
use crate::form::Form;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope, Undecided};
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// Which stage the code is for: it decides what is ready, and how loops run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stage {
    /// From the fields, in scalars.
    Surface,
    /// Over a segment of a ray: surface values, leaves, active rows.
    Segment,
    /// At points of space: surface values, coordinates, all rows.
    Space,
    /// The same with the active rows, where these may be fewer, and those sides of choices that matter.
    Seen,
}

/// The target.
pub struct Enclosure<'a> {
    /// The graph.
    pub graph: &'a Graph,
    /// The storage.
    pub layout: &'a Layout,
    /// The stage.
    pub stage: Stage,
    /// Names of the fields; for tables in the surface stage.
    pub fields: &'a [Ident],
    /// Does code stand in a row, instead of region in region?
    pub flat: bool,
}

/// A variable, and the flags that its value may carry.
#[derive(Clone)]
pub struct Value {
    /// Its name.
    pub name: Ident,
    /// Its flags, if any part of it is partial or piecewise.
    pub flags: Option<Ident>,
}

/// Looks up the values of operands.
type Values<'v> = &'v dyn Fn(Id) -> Option<Value>;

impl Target for Enclosure<'_> {
    type Value = Value;

    fn ready(&self, id: Id) -> bool {
        self.is_prepared(id) || matches!(self.graph.op(id), Op::Leaf(..))
    }

    fn given(&mut self, id: Id, out: &mut TokenStream) -> Option<Value> {
        let expression = match self.graph.op(id) {
            Op::Literal(r) => number(r),
            Op::Coordinate(axis) => {
                let axis = Literal::usize_unsuffixed(*axis);
                quote!(point[#axis])
            }
            Op::Leaf(leaf, order, _) => {
                let (place, quadratic) = self.layout.leaf(*leaf)?;
                leaf_value(&self.place(place), quadratic, *order)
            }
            _ if self.is_prepared(id) => {
                let place = self.place(self.layout.value(id)?);
                match self.layout.fine_value(id) {
                    Some(fine) if self.stage == Stage::Space => quote!(a.stored(#place, &#fine)),
                    _ => quote!(a.constant(#place)),
                }
            }
            Op::Pi => quote!(a.literal(&__zeroset::PI)),
            Op::Field(field, indices) => {
                let (name, indices) = (self.fields.get(*field)?, indices.iter().map(index));
                quote!(a.constant(&__zeroset::point(self.#name #(#indices)*)))
            }
            Op::Row(fold, column) => {
                let row = format_ident!("r{fold}");
                let column = column.map(Literal::usize_unsuffixed).map(|c| quote!([#c]));
                quote!(a.constant(&__zeroset::point(#row #column)))
            }
            Op::Counter(fold) => {
                let counter = format_ident!("i{fold}");
                quote!(a.constant(&__zeroset::point(#counter as __zeroset::primitive::f64)))
            }
            _ => return None,
        };
        let name = variable(id);
        let known_sign = matches!(self.graph.op(id), Op::Leaf(..)) && self.graph.nonnegative(id);
        let expression = if known_sign {
            quote!(a.nonneg(#expression))
        } else {
            expression
        };
        out.extend(quote!(let #name = #expression;));
        Some(Value { name, flags: None })
    }

    fn operation(&mut self, id: Id, values: Values, out: &mut TokenStream) -> Value {
        let op = self.graph.op(id).clone();
        let name = variable(id);
        let own = flags(id);
        let mut expression = self.expression(&op, values);
        let made = self.made(id);
        if let (Some((yes, no)), Some([first, second])) = (&made, branches(&op)) {
            let (open, v) = (expression.code, |id: Id| values(id).map(|v| v.name));
            let (first, second) = (v(first), v(second));
            expression.code = quote! {
                match (#yes, #no) { (true, true) => #open, (true, _) => #first, _ => #second }
            };
        }
        let (pattern, flagged) = if expression.flagged {
            (quote!((#name, #own)), true)
        } else {
            (name.to_token_stream(), false)
        };
        let code = expression.code;
        out.extend(quote!(let #pattern = #code;));
        if self.graph.nonnegative(id) && !bounded_by_itself(&op) {
            out.extend(quote!(let #name = a.nonneg(#name);));
        }
        let flags = self.flags_of(id, &op, flagged, values, out);
        Value { name, flags }
    }

    fn sine_and_cosine(
        &mut self,
        ids: [Id; 2],
        values: Values,
        out: &mut TokenStream,
    ) -> Option<[Value; 2]> {
        let names = ids.map(variable);
        let Op::Unary(_, a) = self.graph.op(ids[0]) else {
            return None;
        };
        let a = values(*a)?;
        let operand = &a.name;
        out.extend(quote!(let [#(#names),*] = a.sin_cos(#operand);));
        for (id, name) in ids.iter().zip(&names) {
            if self.graph.nonnegative(*id) {
                out.extend(quote!(let #name = a.nonneg(#name);));
            }
        }
        Some(names.map(|name| Value {
            name,
            flags: a.flags.clone(),
        }))
    }

    fn guard(&self, id: Id) -> Option<Side> {
        match self.stage {
            Stage::Segment | Stage::Seen => match self.choices().passed(id) {
                Some((side, _)) => Some(side),
                None => self.choices().guard(id),
            },
            Stage::Surface | Stage::Space => None,
        }
    }

    fn step(&self, from: Option<Side>, guard: Side) -> Side {
        if self.flat {
            guard
        } else {
            self.choices().step(from, guard)
        }
    }

    fn passed(&self, id: Id) -> Option<Id> {
        match self.stage {
            Stage::Segment | Stage::Seen => self.choices().passed(id).map(|(_, operand)| operand),
            Stage::Surface | Stage::Space => None,
        }
    }

    fn declared(&self, id: Id, value: &Value, passed: Option<&Value>) -> Declared {
        let zero = interval(&crate::exact::Rational::from(0));
        let zero = quote!(a.constant(&#zero));
        let nothing = match self.graph.op(id) {
            Op::Less(..) | Op::LessOrEqual(..) | Op::Both(..) | Op::Either(..) => {
                quote!(a.less(#zero, #zero))
            }
            _ => zero,
        };
        let instead = |of: Option<&Ident>, nothing| {
            of.map_or(Instead::Code(nothing), |of| Instead::Variable(of.clone()))
        };
        let number = instead(passed.map(|v| &v.name), nothing);
        // Flags may be those of an operand, which were declared with it.
        let own = flags(id);
        let flags = value.flags.clone().filter(|f| *f == own);
        let none = instead(passed.and_then(|v| v.flags.as_ref()), quote!(a.clear()));
        std::iter::once((value.name.clone(), number))
            .chain(flags.map(|f| (f, none)))
            .collect()
    }

    fn names(&self, value: &Value) -> Vec<Ident> {
        let flags = value.flags.iter().cloned();
        flags.chain([value.name.clone()]).collect()
    }

    fn enter(&mut self, fold: usize, scope: Scope) -> (TokenStream, TokenStream) {
        match self.stage {
            Stage::Surface => enter_fields(self.graph, self.fields, fold),
            Stage::Segment => enter_rows(self.graph, self.layout, fold, scope, Visit::Bound),
            Stage::Space | Stage::Seen => {
                let thin = self.stage == Stage::Seen && self.layout.terms.thins_in_space(fold);
                let visit = if thin { Visit::Active } else { Visit::All };
                let (header, start) = enter_rows(self.graph, self.layout, fold, scope, visit);
                let fine = enter_fine_rows(self.layout, fold, scope);
                (header, quote!(#start #fine))
            }
        }
    }

    fn accumulate(
        &mut self,
        id: Id,
        fold: (FoldKind, usize),
        args: &[Value],
    ) -> (TokenStream, TokenStream, Value) {
        let name = variable(id);
        let names: Vec<&Ident> = args.iter().map(|v| &v.name).collect();
        let (mut declare, mut update) = accumulator(&name, fold.0, fold.1, &names);
        let terms = &self.layout.terms;
        let rest = match self.stage {
            Stage::Segment => terms.rest(id).map(|k| quote!(bound.2.rest(#k, t.rough()))),
            Stage::Seen => terms
                .rest_in_space(id)
                .map(|k| quote!(active.rest(#k, false))),
            Stage::Surface | Stage::Space => None,
        };
        if let Some(rest) = rest {
            declare = quote!(let mut #name = a.constant(#rest););
        }
        let choosing = matches!(fold.0, FoldKind::Minimum | FoldKind::Maximum) && args.len() > 1;
        let any = choosing || args.iter().any(|v| v.flags.is_some());
        let flags = any.then(|| flags(id));
        if let Some(flags) = &flags {
            declare.extend(quote!(let mut #flags = a.clear();));
            for of in args.iter().filter_map(|v| v.flags.as_ref()) {
                update.extend(quote!(#flags = a.join(#flags, #of);));
            }
            if choosing {
                let chosen = format_ident!("c{}", id.0);
                update.extend(quote!(#flags = a.join(#flags, #chosen);));
                declare = quote!(#declare let mut #chosen = a.clear(););
            }
        }
        (declare, update, Value { name, flags })
    }

    fn finish(&mut self, id: Id, value: Value, out: &mut TokenStream) -> Value {
        let name = &value.name;
        if self.graph.nonnegative(id) {
            out.extend(quote!(let #name = a.nonneg(#name);));
        }
        value
    }
}

/// The code of an operation; `flagged` if it yields `(value, flags)`.
struct Expression {
    code: TokenStream,
    flagged: bool,
}

impl Enclosure<'_> {
    /// Was the node computed by the surface stage?
    fn is_prepared(&self, id: Id) -> bool {
        self.stage != Stage::Surface && self.layout.form.ready(self.graph, id)
    }

    /// The sides of the choice that a node makes, if sides are told apart here.
    fn made(&self, id: Id) -> Option<(TokenStream, TokenStream)> {
        if matches!(self.stage, Stage::Surface | Stage::Space) {
            return None;
        }
        let choice = self.choices().made(self.graph, id)?;
        Some((alive(2 * choice), alive(2 * choice + 1)))
    }

    fn choices(&self) -> &Choices {
        match self.stage {
            Stage::Seen => &self.layout.choices_in_space,
            _ => &self.layout.choices,
        }
    }

    /// A reference to a stored value. In the naive form each use loads it again, lest rustc shares what the form does not.
    fn place(&self, place: TokenStream) -> TokenStream {
        match self.layout.form {
            Form::Naive => quote!(__zeroset::apart(&#place)),
            _ => quote!(&#place),
        }
    }

    fn expression(&self, op: &Op, values: Values) -> Expression {
        let v = |id: &Id| values(*id).map_or_else(|| quote!(()), |v| v.name.to_token_stream());
        let plain = |code| Expression {
            code,
            flagged: false,
        };
        // Where the operands cannot leave the domain, the flags are not set.
        let regular = self.graph.is_regular(op);
        let partial = |code: TokenStream| Expression {
            code: if regular { quote!(#code.0) } else { code },
            flagged: !regular,
        };
        match op {
            Op::Negate(a) => {
                let a = v(a);
                plain(quote!(a.neg(#a)))
            }
            Op::Add(a, b) => call("add", &[v(a), v(b)]),
            Op::Subtract(a, b) => call("sub", &[v(a), v(b)]),
            Op::Multiply(a, b) => match (self.graph.nonnegative(*a), self.graph.nonnegative(*b)) {
                (true, true) => call("mul_pos_pos", &[v(a), v(b)]),
                (true, false) => call("mul_pos", &[v(a), v(b)]),
                (false, true) => call("mul_pos", &[v(b), v(a)]),
                (false, false) => call("mul", &[v(a), v(b)]),
            },
            Op::Divide(a, b) if self.graph.is_one(*a) => {
                let b = v(b);
                partial(quote!(a.recip(#b)))
            }
            Op::Divide(a, b) => {
                let (a, b) = (v(a), v(b));
                partial(quote!(a.div(#a, #b)))
            }
            Op::Power(a, 2) => call("sqr", &[v(a)]),
            Op::Power(a, n) => {
                let (a, n) = (v(a), Literal::u32_unsuffixed(*n));
                plain(quote!(a.powi(#a, #n)))
            }
            Op::RealPower(a, b) => {
                let (a, b) = (v(a), v(b));
                partial(quote!(a.pow(#a, #b)))
            }
            Op::Unary(f, a) if f.entry().total => call(f.entry().name, &[v(a)]),
            Op::Binary(f, a, b) if f.entry().total => call(f.entry().name, &[v(a), v(b)]),
            Op::Unary(f, a) => partial(call(f.entry().name, &[v(a)]).code),
            Op::Binary(f, a, b) => partial(call(f.entry().name, &[v(a), v(b)]).code),
            Op::AbsSlope(a) => {
                let a = v(a);
                partial(quote!(a.abs_slope(#a)))
            }
            Op::Less(a, b) => call("less", &[v(a), v(b)]),
            Op::LessOrEqual(a, b) => call("less_or_equal", &[v(a), v(b)]),
            Op::Both(a, b) => call("both", &[v(a), v(b)]),
            Op::Either(a, b) => call("either", &[v(a), v(b)]),
            Op::Choose(c, a, b, _) => call("choose", &[v(c), v(a), v(b)]),
            // The rest are inputs and folds, which never come here.
            _ => plain(quote!(())),
        }
    }

    /// The flags of a node: its own, joined with those of its operands; a choice has those of the taken branch.
    fn flags_of(
        &self,
        id: Id,
        op: &Op,
        flagged: bool,
        values: Values,
        out: &mut TokenStream,
    ) -> Option<Ident> {
        let of = |id: Id| values(id).and_then(|v| v.flags);
        let result = flags(id);
        if let Op::Choose(c, a, b, undecided) = op {
            let condition = values(*c)?.name;
            let or_clear =
                |f: Option<Ident>| f.map_or_else(|| quote!(a.clear()), |f| f.to_token_stream());
            let (yes, no) = (or_clear(of(*a)), or_clear(of(*b)));
            let undecided = match undecided {
                Undecided::Kink => quote!(Kink),
                Undecided::Jump => quote!(Jump),
            };
            let mut open =
                quote!(a.branch(#condition, #yes, #no, __zeroset::Undecided::#undecided));
            if let Some(f) = of(*c) {
                open = quote!(a.join(#open, #f));
            }
            if let Some((first, second)) = self.made(id) {
                // What was not computed has no flags.
                open = quote!(if #first & #second { #open } else { a.join(#yes, #no) });
            }
            out.extend(quote!(let #result = #open;));
            return Some(result);
        }
        let mut all: Vec<Ident> = Vec::new();
        for f in crate::graph::operands(op).into_iter().filter_map(of) {
            if !all.contains(&f) {
                all.push(f);
            }
        }
        match (flagged, all.as_slice()) {
            (false, []) => None,
            (false, [one]) => Some(one.clone()),
            (true, _) => {
                for f in all {
                    out.extend(quote!(let #result = a.join(#result, #f);));
                }
                Some(result)
            }
            (false, [first, rest @ ..]) => {
                let joined = rest
                    .iter()
                    .fold(first.to_token_stream(), |sum, f| quote!(a.join(#sum, #f)));
                out.extend(quote!(let #result = #joined;));
                Some(result)
            }
        }
    }
}

fn call(name: &str, arguments: &[TokenStream]) -> Expression {
    let name = format_ident!("{name}");
    Expression {
        code: quote!(a.#name(#(#arguments),*)),
        flagged: false,
    }
}

/// Does the operation's inclusion keep the lower bound at 0 or above by itself?
fn bounded_by_itself(op: &Op) -> bool {
    match op {
        Op::Power(_, n) => n.is_multiple_of(2),
        Op::Unary(f, _) => matches!(f, Function::Abs | Function::Exp | Function::Sqrt),
        Op::Binary(f, ..) => matches!(f, Function::Hypot | Function::Min | Function::Max),
        _ => false,
    }
}

fn leaf_value(place: &TokenStream, quadratic: bool, order: u8) -> TokenStream {
    let kind = if quadratic { "quadratic" } else { "linear" };
    let name = match order {
        0 => format_ident!("{kind}"),
        1 => format_ident!("{kind}_slope"),
        _ => format_ident!("{kind}_curvature"),
    };
    quote!(t.#name(a, #place))
}
