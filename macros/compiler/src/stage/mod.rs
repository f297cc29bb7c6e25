//! Binding times: literal → surface → ray → segment.
//!
//! Literals were folded when the graph was built. What does not depend on the point is a value of the surface stage
//! (its degree is 0). Each maximal subexpression of degree 1 or 2 becomes a leaf of the ray stage. The rest, rebuilt on
//! the leaves, is the segment stage.

mod maximal;

use crate::form::Form;
use crate::graph::{Graph, Id, Info, Op, Scope, operands};
use crate::range::Range;
use maximal::Survey;
use std::collections::HashMap;

/// A leaf: its node in space, and whether it is quadratic.
#[derive(Clone, Copy, Debug)]
pub struct Leaf {
    /// The subexpression that it stands for.
    pub node: Id,
    /// Degree 2, or else 1.
    pub quadratic: bool,
}

/// The segment stage of a formula.
#[derive(Debug, Default)]
pub struct Staged {
    form: Form,
    survey: Survey,
    /// f in space.
    pub root: Option<Id>,
    /// The leaves of the ray stage.
    pub leaves: Vec<Leaf>,
    /// f, df/dt, d²f/dt² in terms of leaves and surface values.
    pub jet: [Option<Id>; 3],
    /// What stands in f for the nodes in space.
    images: HashMap<Id, Id>,
    /// Subexpressions of higher degree whose coefficients the ray stage computes too, with their degree.
    pub polynomials: Vec<(Id, u32)>,
    /// f, df/dt, d²f/dt² over a segment in terms of these, if there are any; at points `jet` is better.
    pub over: Option<[Id; 3]>,
}

impl Staged {
    /// f in each of its forms.
    pub fn values(&self) -> Vec<Id> {
        let over = self.over.map(|[value, ..]| value);
        self.jet[0].into_iter().chain(over).collect()
    }

    /// The node over segments that stands for one in space, if that is not inside of a leaf.
    pub fn image(&self, id: Id) -> Option<Id> {
        self.images.get(&id).copied()
    }

    /// Splits the formula `root` and differentiates it along the ray.
    pub fn new(graph: &mut Graph, root: Id) -> Staged {
        Staged::in_form(graph, root, Form::Staged)
    }

    /// The same in another form: if it is not staged, the coordinates are the only leaves.
    pub fn in_form(graph: &mut Graph, root: Id, form: Form) -> Staged {
        let mut staged = Staged {
            form,
            root: Some(root),
            ..Staged::default()
        };
        if form.in_stages() {
            // Polynomials as they are written first: points are evaluated so.
            staged.form = Form::Written;
            staged.survey = Survey::new(graph, root);
            // What the leaves are depends on how many there are alike: a first round counts them.
            staged.rebuild(graph, root, &mut HashMap::new());
            staged.survey.settle();
            staged.leaves.clear();
        }
        let mut images = HashMap::new();
        let value = staged.rebuild(graph, root, &mut images);
        staged.images = images;
        let mut jet = staged.jet_of(graph, value);
        if form == Form::Naive {
            jet = jet.map(|id| graph.unshared(id));
        }
        staged.jet = jet.map(Some);
        if form == Form::Staged {
            staged.form = form;
            let value = staged.rebuild(graph, root, &mut HashMap::new());
            if !staged.polynomials.is_empty() {
                staged.over = Some(staged.jet_of(graph, value));
            }
        }
        staged
    }

    fn jet_of(&self, graph: &mut Graph, value: Id) -> [Id; 3] {
        let leaf =
            |graph: &mut Graph, k: usize, order: u8| leaf_node(graph, &self.leaves, k, order);
        let mut memo = HashMap::new();
        let slope = graph.along(value, &mut memo, &leaf);
        let curvature = graph.along(slope, &mut memo, &leaf);
        [value, slope, curvature]
    }

    /// The node with its maximal subexpressions of degree 1 and 2 replaced by leaves.
    fn rebuild(&mut self, graph: &mut Graph, id: Id, memo: &mut HashMap<Id, Id>) -> Id {
        if let Some(&known) = memo.get(&id) {
            return known;
        }
        let staged = self.form.in_stages();
        let new = match graph.info(id).degree {
            Some(0) => id,
            Some(1) if staged => self.leaf(graph, id),
            Some(2) if staged => self.quadratic(graph, id, memo),
            Some(degree) if self.form == Form::Staged && pays(graph, id, degree) => {
                self.polynomial(graph, id, degree)
            }
            _ if staged => match graph.op(id) {
                Op::Add(..) | Op::Subtract(..) | Op::Negate(_) => self.sum(graph, id, memo),
                Op::Multiply(..) => self.product(graph, id, memo),
                _ => self.rebuild_operation(graph, id, memo),
            },
            _ if matches!(graph.op(id), Op::Coordinate(_)) => self.leaf(graph, id),
            _ => self.rebuild_operation(graph, id, memo),
        };
        memo.insert(id, new);
        new
    }

    /// A polynomial that stands for the node.
    fn polynomial(&mut self, graph: &mut Graph, id: Id, degree: u32) -> Id {
        let k = self.polynomials.len();
        self.polynomials.push((id, degree));
        let of = graph.info(id).clone();
        graph.polynomial(k, 0, id, of)
    }

    /// A leaf that stands for the node.
    fn leaf(&mut self, graph: &mut Graph, id: Id) -> Id {
        let same = |leaf: &Leaf| leaf.node == id;
        let k = self.leaves.iter().position(same).unwrap_or_else(|| {
            self.leaves.push(Leaf {
                node: id,
                quadratic: graph.info(id).degree == Some(2),
            });
            self.leaves.len() - 1
        });
        leaf_node(graph, &self.leaves, k, 0)
    }

    fn rebuild_operation(&mut self, graph: &mut Graph, id: Id, memo: &mut HashMap<Id, Id>) -> Id {
        let op = graph.op(id).clone();
        let args: Vec<Id> = operands(&op)
            .into_iter()
            .map(|a| self.rebuild(graph, a, memo))
            .collect();
        match (op, args.as_slice()) {
            (Op::Negate(_), &[a]) => graph.negate(a),
            (Op::Add(..), &[a, b]) => graph.add(a, b),
            (Op::Subtract(..), &[a, b]) => graph.subtract(a, b),
            (Op::Multiply(..), &[a, b]) => graph.multiply(a, b),
            (Op::Divide(..), &[a, b]) => graph.divide(a, b),
            (Op::Power(_, n), &[a]) => graph.power(a, n),
            (Op::RealPower(..), &[a, b]) => graph.real_power(a, b),
            (Op::Unary(f, _), &[a]) => graph.unary(f, a),
            (Op::Binary(f, ..), &[a, b]) => graph.binary(f, a, b),
            (Op::AbsSlope(_), &[a]) => graph.abs_slope(a),
            (Op::Less(..), &[a, b]) => graph.truth(Op::Less(a, b)),
            (Op::LessOrEqual(..), &[a, b]) => graph.truth(Op::LessOrEqual(a, b)),
            (Op::Both(..), &[a, b]) => graph.truth(Op::Both(a, b)),
            (Op::Either(..), &[a, b]) => graph.truth(Op::Either(a, b)),
            (Op::Choose(_, _, _, u), &[c, a, b]) => graph.choose(c, a, b, u),
            (Op::Fold(kind, fold, _), args) => graph.fold(kind, fold, args.to_vec()),
            _ => id,
        }
    }
}

/// The highest degree for which the runtime has polynomials.
const MOST: u32 = 12;

/// Is the polynomial cheaper from its coefficients than as written? What is written costs a leaf or an operation per
/// node, and coefficients a little less per degree, as `benches/graphs` measures for each surface of the zoo. What is
/// written in fewer operations, such as the power of a leaf, is also as narrow, or narrower. Constants that scale and shift
/// do not count: a leaf takes them in.
fn pays(graph: &Graph, id: Id, degree: u32) -> bool {
    let low = |id: Id| graph.info(id).degree.is_some_and(|d| d <= 2);
    let counts = |id: &Id| {
        let varying = operands(graph.op(*id))
            .into_iter()
            .filter(|a| graph.varies(*a));
        graph.varies(*id)
            && (low(*id) || matches!(graph.op(*id), Op::Power(..)) || varying.count() > 1)
    };
    let nodes = graph.reachable(&[id], low);
    let written = nodes.iter().filter(|id| counts(id)).count();
    degree <= MOST && graph.info(id).scope == Scope::default() && written >= degree as usize
}

/// The node of a leaf's value (order 0), slope or curvature. A linear leaf's slope and a quadratic leaf's curvature are
/// numbers of the ray stage too, and further derivatives are 0.
fn leaf_node(graph: &mut Graph, leaves: &[Leaf], k: usize, order: u8) -> Id {
    let Some(leaf) = leaves.get(k) else {
        return graph.integer(0);
    };
    if order > 1 + u8::from(leaf.quadratic) {
        return graph.integer(0);
    }
    let of = graph.info(leaf.node).clone();
    let range = if order == 0 { of.range } else { Range::LINE };
    graph.leaf(
        k,
        order,
        leaf.node,
        Info {
            degree: None,
            range,
            ..of
        },
    )
}
