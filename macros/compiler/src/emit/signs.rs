//! Of which values only the sign matters.
//!
//! f is looked at for its zeros. A minimum keeps its sign, and so its zeros, where a number that is certainly positive is left
//! out of several; a maximum where a negative one is. Where f's sign depends on a value's sign alone, that is enough.

use crate::exact::Rational;
use crate::functions::Function;
use crate::graph::{Graph, Id, Op, operands};
use crate::tree::FoldKind;
use std::collections::HashMap;

/// The nodes that f is computed from; true of those of which only the sign matters.
pub struct Signs(HashMap<Id, bool>);

impl Signs {
    /// Of f in each of its forms. Users come after what they use, so each node's uses are known before it is looked at.
    pub fn new(graph: &Graph, forms: &[Id], ready: impl Fn(Id) -> bool) -> Signs {
        let mut alone: HashMap<Id, bool> = forms.iter().map(|id| (*id, true)).collect();
        for id in graph.reachable(forms, &ready).into_iter().rev() {
            let own = alone.get(&id).copied().unwrap_or(false);
            if ready(id) {
                continue;
            }
            for operand in operands(graph.op(id)) {
                let passes = own && passes(graph, id, operand);
                let known = alone.entry(operand).or_insert(true);
                *known = *known && passes;
            }
        }
        Signs(alone)
    }

    /// Is f computed from the node?
    pub fn uses(&self, id: Id) -> bool {
        self.0.contains_key(&id)
    }

    /// Does f's sign depend on the node's sign alone?
    pub fn suffices(&self, id: Id) -> bool {
        self.0.get(&id).copied().unwrap_or(false)
    }
}

/// Does the sign of an operand do for the sign of the node?
fn passes(graph: &Graph, id: Id, operand: Id) -> bool {
    let factor = |id: &Id| graph.literal(*id).is_some_and(|n| !Rational::is_zero(n));
    match graph.op(id) {
        Op::Negate(_) | Op::Binary(Function::Min | Function::Max, ..) => true,
        Op::Fold(FoldKind::Minimum | FoldKind::Maximum, _, numbers) => numbers.len() == 1,
        Op::Multiply(a, b) => operand == *a && factor(b) || operand == *b && factor(a),
        Op::Divide(a, b) => operand == *a && factor(b),
        _ => false,
    }
}
