//! How operands are put together, and what their sides say about the whole.

/// Where a piece of space or of a ray is: certainly outside, certainly inside, or not known. The order makes an
/// intersection the least of its operands and a union the greatest (Kleene's logic).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Side {
    Out,
    #[default]
    Unknown,
    In,
}

impl Side {
    /// By two certainties, of which at most one holds.
    pub fn of(inside: bool, outside: bool) -> Side {
        match (inside, outside) {
            (true, false) => Side::In,
            (false, true) => Side::Out,
            _ => Side::Unknown,
        }
    }

    pub fn opposite(self) -> Side {
        match self {
            Side::Out => Side::In,
            Side::Unknown => Side::Unknown,
            Side::In => Side::Out,
        }
    }

    /// Of two pieces together.
    pub fn joined(self, other: Side) -> Side {
        if self == other { self } else { Side::Unknown }
    }
}

/// Operands by number, each once.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    Leaf(usize),
    Not(Box<Node>),
    /// An intersection.
    Both(Vec<Node>),
    /// A union.
    Either(Vec<Node>),
}

impl Node {
    /// The complement.
    pub fn negated(self) -> Node {
        match self {
            Node::Not(inner) => *inner,
            node => Node::Not(Box::new(node)),
        }
    }

    /// a ∩ b; a chain of them is one node.
    pub fn and(self, other: Node) -> Node {
        let mut parts = match self {
            Node::Both(parts) => parts,
            node => vec![node],
        };
        match other {
            Node::Both(more) => parts.extend(more),
            node => parts.push(node),
        }
        Node::Both(parts)
    }

    /// a ∪ b; a chain of them is one node.
    pub fn or(self, other: Node) -> Node {
        let mut parts = match self {
            Node::Either(parts) => parts,
            node => vec![node],
        };
        match other {
            Node::Either(more) => parts.extend(more),
            node => parts.push(node),
        }
        Node::Either(parts)
    }

    /// Gives each operand a number that is larger by `by`.
    pub fn shift(&mut self, by: usize) {
        match self {
            Node::Leaf(index) => *index += by,
            Node::Not(inner) => inner.shift(by),
            Node::Both(parts) | Node::Either(parts) => {
                parts.iter_mut().for_each(|part| part.shift(by));
            }
        }
    }

    /// Sorts operands so that the cheap ones, which may spare the others, come first.
    pub fn sort(&mut self, cost: &impl Fn(usize) -> u64) -> u64 {
        match self {
            Node::Leaf(index) => cost(*index),
            Node::Not(inner) => inner.sort(cost),
            Node::Both(parts) | Node::Either(parts) => {
                let mut priced: Vec<(u64, Node)> = parts
                    .drain(..)
                    .map(|mut part| (part.sort(cost), part))
                    .collect();
                priced.sort_by_key(|(price, _)| *price);
                let total = priced.iter().map(|(price, _)| *price).sum();
                parts.extend(priced.into_iter().map(|(_, part)| part));
                total
            }
        }
    }

    /// The side of the whole, where operand i is on `sides(i)`. As each operand stands here once, this is certain exactly if
    /// the unknown sides do not matter.
    pub fn side(&self, sides: &impl Fn(usize) -> Side) -> Side {
        match self {
            Node::Leaf(index) => sides(*index),
            Node::Not(inner) => inner.side(sides).opposite(),
            Node::Both(parts) => {
                let mut least = Side::In;
                for part in parts {
                    least = least.min(part.side(sides));
                    if least == Side::Out {
                        break;
                    }
                }
                least
            }
            Node::Either(parts) => {
                let mut greatest = Side::Out;
                for part in parts {
                    greatest = greatest.max(part.side(sides));
                    if greatest == Side::In {
                        break;
                    }
                }
                greatest
            }
        }
    }

    /// The sides of eight pieces. An operand is asked only if those before it leave one of them open.
    pub fn sides<F: FnMut(usize) -> [Side; 8]>(&self, ask: &mut F) -> [Side; 8] {
        let (parts, dominant) = match self {
            Node::Leaf(index) => return ask(*index),
            Node::Not(inner) => return inner.sides(ask).map(Side::opposite),
            Node::Both(parts) => (parts, Side::Out),
            Node::Either(parts) => (parts, Side::In),
        };
        let mut all = [dominant.opposite(); 8];
        for part in parts {
            if all == [dominant; 8] {
                break;
            }
            for (side, other) in all.iter_mut().zip(part.sides(ask)) {
                *side = match dominant {
                    Side::Out => (*side).min(other),
                    _ => (*side).max(other),
                };
            }
        }
        all
    }

    /// What is left of it where operand i is on `sides(i)`: those on no certain side, as far as they matter; or the side
    /// of the whole. Both have the same sign wherever these sides hold.
    pub fn given(&self, sides: &impl Fn(usize) -> Side) -> Result<Node, Side> {
        let (parts, dominant, join): (_, _, fn(Vec<Node>) -> Node) = match self {
            Node::Leaf(index) => {
                return match sides(*index) {
                    Side::Unknown => Ok(self.clone()),
                    side => Err(side),
                };
            }
            Node::Not(inner) => {
                let open = inner.given(sides);
                return open.map(Node::negated).map_err(Side::opposite);
            }
            Node::Both(parts) => (parts, Side::Out, Node::Both),
            Node::Either(parts) => (parts, Side::In, Node::Either),
        };
        let mut open = Vec::with_capacity(parts.len());
        for part in parts {
            match part.given(sides) {
                Ok(node) => open.push(node),
                Err(side) if side == dominant => return Err(side),
                Err(_) => {}
            }
        }
        match open.pop() {
            None => Err(dominant.opposite()),
            Some(only) if open.is_empty() => Ok(only),
            Some(last) => {
                open.push(last);
                Ok(join(open))
            }
        }
    }

    /// Visits its operands.
    pub fn leaves(&self, visit: &mut impl FnMut(usize)) {
        match self {
            Node::Leaf(index) => visit(*index),
            Node::Not(inner) => inner.leaves(visit),
            Node::Both(parts) | Node::Either(parts) => {
                parts.iter().for_each(|part| part.leaves(visit));
            }
        }
    }

    /// Visits the operands that can matter, where operand i is on `sides(i)`: no other operand of an intersection that
    /// they are in is certainly outside, and none of a union certainly inside.
    pub fn relevant(&self, sides: &impl Fn(usize) -> Side, visit: &mut impl FnMut(usize)) {
        match self {
            Node::Leaf(index) => visit(*index),
            Node::Not(inner) => inner.relevant(sides, visit),
            Node::Both(parts) => among(parts, Side::Out, sides, visit),
            Node::Either(parts) => among(parts, Side::In, sides, visit),
        }
    }
}

fn among(
    parts: &[Node],
    dominant: Side,
    sides: &impl Fn(usize) -> Side,
    visit: &mut impl FnMut(usize),
) {
    let mut dominating = (0..parts.len()).filter(|&k| parts[k].side(sides) == dominant);
    match (dominating.next(), dominating.next()) {
        (None, _) => parts.iter().for_each(|part| part.relevant(sides, visit)),
        (Some(only), None) => parts[only].relevant(sides, visit),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::Side::{In, Out, Unknown};
    use super::*;

    /// (0 ∪ 1) ∩ ¬2
    fn drilled() -> Node {
        Node::Leaf(0).or(Node::Leaf(1)).and(Node::Leaf(2).negated())
    }

    #[test]
    fn sides_follow_kleene() {
        let node = drilled();
        for (sides, whole) in [
            ([In, Unknown, Out], In),
            ([Unknown, Unknown, In], Out),
            ([Out, Out, Unknown], Out),
            ([In, Out, Unknown], Unknown),
            ([Unknown, Out, Out], Unknown),
        ] {
            assert_eq!(node.side(&|i: usize| sides[i]), whole, "{sides:?}");
        }
    }

    #[test]
    fn what_a_sibling_decides_does_not_matter() {
        let node = drilled();
        let matters = |sides: [Side; 3]| {
            let mut matters = [false; 3];
            node.relevant(&|i: usize| sides[i], &mut |i| matters[i] = true);
            matters
        };
        assert_eq!(matters([Unknown, Unknown, Unknown]), [true; 3]);
        assert_eq!(matters([Unknown, Unknown, In]), [false, false, true]);
        assert_eq!(matters([In, Unknown, Unknown]), [true, false, true]);
        assert_eq!(matters([In, In, Unknown]), [false, false, true]);
        assert_eq!(matters([Out, Out, In]), [false; 3]);
    }

    #[test]
    fn what_is_left_has_the_side_of_the_whole() {
        let node = drilled();
        let digits = |n: usize| [n % 3, n / 3 % 3, n / 9].map(|k| [Out, Unknown, In][k]);
        let mut left = 0;
        for (known, all) in (0..27).flat_map(|i| (0..27).map(move |k| (digits(i), digits(k)))) {
            let agree = known.iter().zip(&all).all(|(a, b)| *a == Unknown || a == b);
            if !agree || all.contains(&Unknown) {
                continue;
            }
            let side = match node.given(&|i: usize| known[i]) {
                Ok(open) => {
                    left += 1;
                    open.leaves(&mut |i| assert_eq!(known[i], Unknown));
                    open.side(&|i: usize| all[i])
                }
                Err(side) => side,
            };
            assert_eq!(side, node.side(&|i: usize| all[i]), "{known:?}, {all:?}");
        }
        assert!(left > 20, "{left}");
    }

    #[test]
    fn chains_are_one_node() {
        let node = (0..1000).map(Node::Leaf).reduce(Node::or).expect("some");
        assert!(matches!(&node, Node::Either(parts) if parts.len() == 1000));
    }
}
