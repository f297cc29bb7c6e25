//! Chains of minima, or of maxima, as balanced trees.
//!
//! A union of many parts is written one part after the other: min(min(min(a, b), c), d). As a tree of least height, a side
//! that does not matter holds half of the parts, and few choices lie between f and each of them.

use super::Graph;
use crate::functions::Function;
use crate::graph::{Id, Op, Scope, operands, operands_mut};
use std::collections::{HashMap, HashSet};

impl Graph {
    /// The same value, with each chain of minima or maxima as a balanced tree; the order of what they compare stays.
    pub fn balanced(&mut self, root: Id) -> Id {
        if !self.rewrites() {
            return root;
        }
        let nodes = self.reachable(&[root], |_| false);
        let inner = self.inner(&nodes);
        let mut new: HashMap<Id, Id> = HashMap::new();
        for id in nodes {
            if inner.contains(&id) {
                continue;
            }
            let now = match self.chain_at(id) {
                Some(function) if self.goes_on(id, &inner) => {
                    let parts = self.parts(id, &inner);
                    let parts: Vec<Id> = parts
                        .into_iter()
                        .filter_map(|p| new.get(&p))
                        .copied()
                        .collect();
                    let tree = self.tree(function, &parts);
                    self.by("min(min(a, b), c) = min(a, min(b, c))", tree)
                }
                _ => self.with_operands(id, &new),
            };
            new.insert(id, now);
        }
        new.get(&root).copied().unwrap_or(root)
    }

    /// The function of a node that may be part of a chain.
    fn chain_at(&self, id: Id) -> Option<Function> {
        match self.op(id) {
            Op::Binary(function @ (Function::Min | Function::Max), ..)
                if self.varies(id) && self.info(id).scope == Scope::default() =>
            {
                Some(*function)
            }
            _ => None,
        }
    }

    /// The nodes inside of chains: those with one user, a node of the same function.
    fn inner(&self, nodes: &[Id]) -> HashSet<Id> {
        let mut users: HashMap<Id, Vec<Id>> = HashMap::new();
        for &id in nodes {
            for operand in operands(self.op(id)) {
                users.entry(operand).or_default().push(id);
            }
        }
        let same = |id: Id, user: Id| {
            let function = self.chain_at(id);
            function.is_some() && function == self.chain_at(user)
        };
        let only = |(id, users): (Id, Vec<Id>)| match *users {
            [user] if same(id, user) => Some(id),
            _ => None,
        };
        users.into_iter().filter_map(only).collect()
    }

    /// Does a chain begin here, of more than one node?
    fn goes_on(&self, id: Id, inner: &HashSet<Id>) -> bool {
        operands(self.op(id)).iter().any(|a| inner.contains(a))
    }

    /// What a chain compares, in the order in which it is written.
    fn parts(&self, of: Id, inner: &HashSet<Id>) -> Vec<Id> {
        let mut todo = vec![of];
        let mut parts = Vec::new();
        while let Some(id) = todo.pop() {
            if id == of || inner.contains(&id) {
                todo.extend(operands(self.op(id)).into_iter().rev());
            } else {
                parts.push(id);
            }
        }
        parts
    }

    fn tree(&mut self, function: Function, parts: &[Id]) -> Id {
        match parts {
            [] => self.integer(0),
            [part] => *part,
            _ => {
                let (first, second) = parts.split_at(parts.len().div_ceil(2));
                let (first, second) = (self.tree(function, first), self.tree(function, second));
                self.binary(function, first, second)
            }
        }
    }

    /// The same operation of other nodes with the same values.
    fn with_operands(&mut self, id: Id, new: &HashMap<Id, Id>) -> Id {
        let mut op = self.op(id).clone();
        for operand in operands_mut(&mut op) {
            *operand = new.get(operand).copied().unwrap_or(*operand);
        }
        let info = self.info(id).clone();
        self.intern(op, |_| info)
    }
}
