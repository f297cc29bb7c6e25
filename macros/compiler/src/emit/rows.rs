//! How many rows of its tables a formula needs: indices must exist, and a minimum or maximum needs a row.

use crate::graph::{Graph, Id, Op, Over};
use crate::tree::{FoldKind, Index};

/// The rows that the formula `root` needs of a field, dimension by dimension.
pub fn needed(graph: &Graph, root: Id, field: usize) -> Vec<usize> {
    let mut rows = Vec::new();
    let mut need = |depth: usize, n: usize| {
        if rows.len() <= depth {
            rows.resize(depth + 1, 0);
        }
        rows[depth] = n.max(rows[depth]);
    };
    let mut indices = |list: &[Index]| {
        for (depth, index) in list.iter().enumerate() {
            need(depth, length(graph, index));
        }
    };
    let nodes = graph.reachable(&[root], |_| false);
    for &id in &nodes {
        if let Op::Field(f, list) = graph.op(id)
            && *f == field
        {
            indices(list);
        }
    }
    for fold in &graph.folds {
        if let Over::Table(f, list) = &fold.over
            && *f == field
        {
            indices(list);
        }
    }
    for &id in &nodes {
        if let Op::Fold(FoldKind::Minimum | FoldKind::Maximum, fold, _) = graph.op(id)
            && let Some(Over::Table(f, list)) = graph.folds.get(*fold).map(|f| &f.over)
            && *f == field
        {
            need(list.len(), 1);
        }
    }
    rows
}

/// Does the formula read a field?
pub fn uses(graph: &Graph, root: Id, field: usize) -> bool {
    graph
        .reachable(&[root], |_| false)
        .iter()
        .any(|id| match graph.op(*id) {
            Op::Field(f, _) => *f == field,
            Op::Fold(_, fold, _) | Op::Row(fold, _) => graph
                .folds
                .get(*fold)
                .is_some_and(|f| matches!(f.over, Over::Table(f, _) if f == field)),
            _ => false,
        })
}

/// The length that makes an index valid.
fn length(graph: &Graph, index: &Index) -> usize {
    match index {
        Index::Constant(k) => k + 1,
        Index::Counter(fold, shift) => match graph.folds.get(*fold).map(|f| &f.over) {
            Some(Over::Range(_, end)) => usize::try_from(end + shift).unwrap_or(0),
            _ => 0,
        },
    }
}
