//! Which rows of a table can be left out: `terms` tells them over a piece of a beam, and each sum starts with what the rows
//! that were left out add.

use super::block::block;
use super::enclosure::{Enclosure, Value};
use super::regions::alive;
use super::signs::Signs;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, Scope};
use crate::stage::Staged;
use crate::tree::FoldKind;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// The folds of the segment stage that may visit fewer rows than there are.
#[derive(Debug, Default)]
pub struct Terms {
    /// Their places are those of `Active::rest`.
    sums: Vec<Sum>,
    extremes: Vec<Extreme>,
    /// The folds, among the outermost.
    lists: Vec<usize>,
    /// Those of them that may visit fewer rows in space, too.
    in_space: Vec<usize>,
}

#[derive(Debug)]
struct Sum {
    id: Id,
    /// The same sum in space, if it is one of f.
    in_space: Option<Id>,
    fold: usize,
    term: Id,
}

/// What minima and maxima choose from.
#[derive(Debug)]
struct Extreme {
    fold: usize,
    number: Id,
    greatest: bool,
    /// Does its sign do?
    sign: bool,
}

impl Extreme {
    /// Is it this one, or a derivative of it, which chooses alike?
    fn is(&self, graph: &Graph, id: Id) -> bool {
        let Op::Fold(kind, fold, arguments) = graph.op(id) else {
            return false;
        };
        let of = (*fold, arguments.first() == Some(&self.number));
        let greatest = *kind == FoldKind::Maximum;
        of == (self.fold, true) && greatest == self.greatest && *kind != FoldKind::Sum
    }
}

impl Terms {
    /// Those of a formula. Products need all of their rows; so does a fold whose body stands in other loops.
    pub fn new(
        graph: &Graph,
        staged: &Staged,
        (outermost, signs): (&[usize], &Signs),
        ready: impl Fn(Id) -> bool,
    ) -> Terms {
        let along = staged.jet.iter().flatten();
        let along: Vec<Id> = along.chain(staged.over.iter().flatten()).copied().collect();
        let root: Vec<Id> = staged.root.into_iter().collect();
        let [all, in_space] = [along, root].map(|roots| folds(graph, &roots, &ready));
        let mut terms = Terms::default();
        for &fold in outermost {
            let [here, there] = [&all, &in_space].map(|folds| {
                let same = folds.iter().filter(|id| over(graph, **id, fold));
                same.copied().collect::<Vec<Id>>()
            });
            if !here.is_empty() && here.iter().all(|id| may_leave_out(graph, *id)) {
                terms.lists.push(fold);
                here.iter().for_each(|id| terms.add(graph, *id));
                // A sum that is inside of a leaf along rays needs all rows, where others of the same loop do not.
                let images = there.iter().map(|id| staged.image(*id));
                if images
                    .clone()
                    .all(|image| image.is_some_and(|id| here.contains(&id)))
                {
                    terms.in_space.push(fold);
                }
                for (id, image) in there.iter().zip(images) {
                    let mut sums = terms.sums.iter_mut();
                    if let Some(sum) = sums.find(|sum| Some(sum.id) == image) {
                        sum.in_space = Some(*id);
                    }
                }
            }
        }
        for extreme in &mut terms.extremes {
            let of_f = all.iter().filter(|id| signs.uses(**id));
            let mut same = of_f.filter(|id| extreme.is(graph, **id));
            extreme.sign = same.all(|id| signs.suffices(*id));
        }
        terms
    }

    fn add(&mut self, graph: &Graph, id: Id) {
        let Op::Fold(kind, fold, arguments) = graph.op(id) else {
            return;
        };
        let fold = *fold;
        let Some(&term) = arguments.first() else {
            return;
        };
        if *kind == FoldKind::Sum {
            self.sums.push(Sum {
                id,
                in_space: None,
                fold,
                term,
            });
        } else if !self.extremes.iter().any(|known| known.is(graph, id)) {
            self.extremes.push(Extreme {
                fold,
                number: term,
                greatest: *kind == FoldKind::Maximum,
                sign: false,
            });
        }
    }

    /// Do all folds visit all of their rows?
    pub fn is_empty(&self) -> bool {
        self.lists.is_empty()
    }

    /// May loops in space leave out the rows that are left out by their sign?
    pub fn signs_are_in_space(&self) -> bool {
        let signed = self.extremes.iter().filter(|e| e.sign);
        signed.map(|e| e.fold).all(|fold| self.thins_in_space(fold))
    }

    /// How many sums may leave out rows.
    pub fn rests(&self) -> usize {
        self.sums.len()
    }

    /// A sum's place in `Active::rest`.
    pub fn rest(&self, id: Id) -> Option<Literal> {
        let place = self.sums.iter().position(|s| s.id == id);
        place.map(Literal::usize_unsuffixed)
    }

    /// The same for a sum in space.
    pub fn rest_in_space(&self, id: Id) -> Option<Literal> {
        let of = |s: &Sum| s.in_space == Some(id) && self.in_space.contains(&s.fold);
        let place = self.sums.iter().position(of);
        place.map(Literal::usize_unsuffixed)
    }

    /// May a loop visit fewer rows in space?
    pub fn thins_in_space(&self, fold: usize) -> bool {
        self.in_space.contains(&fold)
    }

    /// The body of the function `terms`: a loop for each of the folds, and the choices that are open.
    pub fn body(&self, graph: &Graph, target: &mut Enclosure) -> TokenStream {
        let loops = self.lists.iter();
        let mut body: TokenStream = loops.map(|&fold| self.rows(graph, target, fold)).collect();
        let mut known = HashMap::new();
        for (choice, (first, second)) in target.layout.choices.all() {
            let scope = Scope::default();
            let numbers = block(
                graph,
                target,
                scope,
                &[first, second],
                &mut known,
                &mut body,
            );
            let [first, second] = numbers.as_slice() else {
                continue;
            };
            let flags = [first, second].map(|v| told(v.flags.as_ref()));
            let (first, second) = (&first.name, &second.name);
            let [f, g] = flags;
            let (yes, no) = (alive(2 * choice), alive(2 * choice + 1));
            let number = Literal::usize_unsuffixed(choice);
            let by_sign = match target.layout.choices.sign(choice) {
                Some(Function::Min) => quote!([a.less(zero, #second), a.less(zero, #first)]),
                Some(_) => quote!([a.less(#first, zero), a.less(#second, zero)]),
                None => TokenStream::new(),
            };
            let by_sign = (!by_sign.is_empty()).then(|| {
                quote! {
                    let zero = a.constant(&__zeroset::point(0.0));
                    to.by_sign(#number, #by_sign, flags);
                }
            });
            body.extend(quote! {
                if #yes & #no {
                    let less = [a.less(#first, #second), a.less(#second, #first)];
                    let flags = a.join(#f, #g);
                    to.choice(#number, less, flags);
                    #by_sign
                }
            });
        }
        body
    }

    fn rows(&self, graph: &Graph, target: &mut Enclosure, fold: usize) -> TokenStream {
        let scope = graph.chain(fold);
        let (header, start) = super::block::Target::enter(target, fold, scope);
        let mut known: HashMap<Id, Value> = HashMap::new();
        let (mut body, mut tell) = (TokenStream::new(), TokenStream::new());
        let mut compute = |id: Id| block(graph, target, scope, &[id], &mut known, &mut body).pop();
        for (place, sum) in self.sums.iter().enumerate().filter(|(_, s)| s.fold == fold) {
            let Some(Value { name, flags }) = compute(sum.term) else {
                continue;
            };
            let place = Literal::usize_unsuffixed(place);
            let flags = told(flags.as_ref());
            tell.extend(quote!(to.term(row, #place, #name, #flags);));
        }
        for (place, extreme) in self
            .extremes
            .iter()
            .enumerate()
            .filter(|(_, e)| e.fold == fold)
        {
            let Some(Value { name, flags }) = compute(extreme.number) else {
                continue;
            };
            let place = Literal::usize_unsuffixed(place);
            let number = if extreme.greatest {
                quote!(a.neg(#name))
            } else {
                quote!(#name)
            };
            let flags = told(flags.as_ref());
            let sign = extreme.sign;
            tell.extend(quote!(to.candidate(row, #place, #number, #flags, #sign);));
        }
        let (at, list) = (format_ident!("j{fold}"), target.layout.active(fold));
        quote! { #header { #start #body let row = __zeroset::ActiveRow { list: #list, at: #at }; #tell } }
    }
}

/// The flags that the runtime is told.
fn told(flags: Option<&Ident>) -> TokenStream {
    flags.map_or_else(|| quote!(a.clear()), |f| quote!(#f))
}

fn over(graph: &Graph, id: Id, fold: usize) -> bool {
    matches!(graph.op(id), Op::Fold(_, of, _) if *of == fold)
}

fn may_leave_out(graph: &Graph, id: Id) -> bool {
    !matches!(graph.op(id), Op::Fold(FoldKind::Product, ..))
        && graph.info(id).scope == Scope::default()
}

/// All folds that the code for these nodes runs.
fn folds(graph: &Graph, roots: &[Id], ready: &impl Fn(Id) -> bool) -> Vec<Id> {
    let mut all = graph.reachable(roots, ready);
    all.retain(|id| !ready(*id) && matches!(graph.op(*id), Op::Fold(..)));
    all
}
