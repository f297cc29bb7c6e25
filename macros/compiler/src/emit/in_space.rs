//! The choices of f along rays, where f is looked at in space: what is active there is active here.

use super::choices::{Choices, pair};
use crate::graph::{Graph, Id};
use crate::stage::Staged;
use std::collections::{HashMap, HashSet};

impl Choices {
    /// The same choices in space, of f and its gradient: under the same numbers.
    pub fn in_space(
        &self,
        graph: &Graph,
        staged: &Staged,
        roots: &[Id],
        ready: impl Fn(Id) -> bool,
    ) -> Choices {
        let nodes = graph.reachable(roots, &ready);
        let made = nodes.iter().filter_map(|id| pair(graph, *id));
        let image = |(a, b): (Id, Id)| Some((staged.image(a)?, staged.image(b)?));
        let same: HashMap<(Id, Id), (Id, Id)> =
            made.filter_map(|of| Some((image(of)?, of))).collect();
        // f is compared with nothing: that stands for a choice that is not made in space, but inside of a leaf.
        let (Some(&f), false) = (roots.first(), self.is_empty()) else {
            return Choices::default();
        };
        let mut choices = Choices::default();
        choices.pairs = self
            .pairs
            .iter()
            .map(|of| same.get(of).copied().unwrap_or((f, f)))
            .collect();
        if choices.guard_all(graph, &nodes, roots, &ready) {
            choices.around = choices.nested();
            choices
        } else {
            Choices::default()
        }
    }

    /// Is each choice that is decided by a sign made by one pair of numbers of f in space?
    pub fn signs_are(&self, graph: &Graph, staged: &Staged) -> bool {
        let root: Vec<Id> = staged.root.into_iter().collect();
        let made = graph.reachable(&root, |_| false);
        let made: HashSet<(Id, Id)> = made.iter().filter_map(|id| pair(graph, *id)).collect();
        let stands_for = |(a, b): (Id, Id), of: (Id, Id)| {
            staged.image(a) == Some(of.0) && staged.image(b) == Some(of.1)
        };
        let signs = self.pairs.iter().zip(&self.signs);
        signs
            .filter(|(_, sign)| sign.is_some())
            .all(|(of, _)| made.iter().filter(|p| stands_for(**p, *of)).count() == 1)
    }
}
