//! What is known about a ray.
//!
//! Every verdict is a statement about the exact real function f∘ray: the formula with the fields' `f64` values, along
//! the line through the `f64` origin with the `f64` direction. Parameters t are in units of that direction, which is
//! not normalised, and count from the ray's [`entry`](Answer::entry): a root lies at `entry + t`.

use crate::interval::Interval;

/// How wide a tangency may be, as a part of the ray up to the box's far side.
const CLOSE: f64 = 1e-6;
/// How wide a sign change may be.
const SHARP: f64 = 1e-12;

/// A statement about a piece of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// f has no root on the whole segment inside the domain.
    ///
    /// Proof: the segment is covered by pieces with 0 ∉ f(T), by steps that use a derivative where f is certainly
    /// defined and continuous, and by monotone pieces whose ends have the same certain sign.
    Miss,
    /// Exactly one root lies in `t`; if the verdict is an answer's first, no root lies before `t`.
    ///
    /// Proof: `t` lies in a piece on which f is continuous, with 0 ∉ f'(T) and opposite certain signs at its ends (or
    /// the Newton image of T inside T), and the signs at the ends of `t` itself, or a Newton image, place the root.
    Root {
        /// Where.
        t: Interval,
    },
    /// None, one or two roots lie in `t`, and there |f| reaches down to `residual` or less at its only critical point.
    /// `t` is at most a millionth of the ray up to the box's far side; if no more is known, that is
    /// [`Unresolved`](Self::Unresolved).
    ///
    /// Proof: 0 ∉ f''(T); a critical point is proved by opposite signs of f' and enclosed in C; with r = max |f(C)| and
    /// m = min |f''(T)|, any root in T lies within √(2r/m) of C.
    Tangent {
        /// All the roots, if there are any.
        t: Interval,
        /// An upper bound of |f| at the critical point.
        residual: f64,
    },
    /// At least one root lies in `t`, and nothing before it is a root if the verdict is an answer's first. `t` is at most
    /// 10⁻¹² of the ray up to the box's far side; if no more is known, that is [`Unresolved`](Self::Unresolved).
    ///
    /// Proof: f is continuous on `t` and has opposite certain signs before and behind it. How many roots there are was
    /// not decided: a root of odd multiplicity, a cluster, or a solver without derivatives.
    Crossing {
        /// Where f changes its sign.
        t: Interval,
    },
    /// Nothing is claimed about `t`: it covers all that was not decided.
    Unresolved {
        /// The undecided piece.
        t: Interval,
        /// What stopped the search.
        why: Why,
    },
}

/// Why a piece of a ray is undecided. The later ones leave more open: on the first three f is defined and continuous.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Why {
    /// Events of several operands of a [solid](crate::solid) overlap: in which order their roots come, or whether they
    /// coincide, is open, and the solid may have roots there or not.
    Order,
    /// Rounding hides the sign of f: a root of even multiplicity at a kink or where f is nearly constant, a cluster, or a
    /// root at the border of the domain. Or f is so small around a root of high order that to exclude all that holds none
    /// there would take the whole budget.
    Floor,
    /// f cannot be told from 0 on a long piece: the ray runs in the surface, or closer to it than rounding can see.
    Flat,
    /// f may be undefined or discontinuous there.
    Undefined,
    /// The ray's budget of evaluations was spent; `t` is the whole rest of the ray.
    Budget,
}

impl Verdict {
    /// Where the verdict speaks of; nothing for a miss.
    pub fn t(&self) -> Option<Interval> {
        match *self {
            Verdict::Miss => None,
            Verdict::Root { t }
            | Verdict::Tangent { t, .. }
            | Verdict::Crossing { t }
            | Verdict::Unresolved { t, .. } => Some(t),
        }
    }

    /// Does it prove at least one root?
    pub fn is_certain_hit(&self) -> bool {
        matches!(self, Verdict::Root { .. } | Verdict::Crossing { .. })
    }

    /// Does it leave open whether there is a root?
    pub fn is_open(&self) -> bool {
        matches!(self, Verdict::Tangent { .. } | Verdict::Unresolved { .. })
    }

    /// The same, or undecided if it does not say where: a sign change or a tangency that is wider than it may be on a ray
    /// that is searched up to `end`.
    pub(crate) fn unless_vague(self, end: f64) -> Verdict {
        let widest = match self {
            Verdict::Tangent { .. } => CLOSE,
            Verdict::Crossing { .. } => SHARP,
            _ => f64::INFINITY,
        };
        match self.t() {
            Some(t) if t.hi - t.lo > widest * end => {
                let why = Why::Floor;
                Verdict::Unresolved { t, why }
            }
            _ => self,
        }
    }

    /// Appends a verdict that lies behind the others.
    ///
    /// An undecided piece that touches the one before it becomes one with it, by their hull, and of two reasons the one
    /// that leaves more open is kept. A sign change that touches an undecided piece on which f is continuous becomes a
    /// sign change somewhere in both: f is continuous on the hull, and has opposite signs around a part of it.
    pub(crate) fn append(&self, events: &mut Vec<Verdict>) {
        if let (Some(last), Some(t)) = (events.last_mut(), self.t())
            && let Verdict::Unresolved { t: before, why } = *last
            && t.lo <= before.hi
        {
            let hull = before.hull(&t);
            match *self {
                Verdict::Unresolved { why: other, .. } => {
                    *last = Verdict::Unresolved {
                        t: hull,
                        why: why.max(other),
                    };
                    return;
                }
                Verdict::Crossing { .. } if why <= Why::Flat => {
                    *last = Verdict::Crossing { t: hull };
                    return;
                }
                _ => {}
            }
        }
        events.push(*self);
    }
}

/// What is known about one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The parameter from which all t count: a plain `f64`, exact by definition, at or before the entry into the box.
    pub entry: f64,
    /// The first event along the ray.
    pub first: Verdict,
    /// When the first event is open ([`Tangent`](Verdict::Tangent) or [`Unresolved`](Verdict::Unresolved)): the first
    /// root that is certain behind it. Other open pieces may lie between them, so it is never called the first root.
    pub behind: Option<Verdict>,
}

impl Answer {
    /// The answer for a ray that meets nothing.
    pub fn miss(entry: f64) -> Self {
        Answer {
            entry,
            first: Verdict::Miss,
            behind: None,
        }
    }

    /// The first and, if it is open, the first certain hit behind it, of events in ascending order.
    pub fn from_events(entry: f64, events: &[Verdict]) -> Self {
        let Some((&first, rest)) = events.split_first() else {
            return Answer::miss(entry);
        };
        let behind = if first.is_open() {
            rest.iter().copied().find(Verdict::is_certain_hit)
        } else {
            None
        };
        Answer {
            entry,
            first,
            behind,
        }
    }

    /// The root that a picture shows: a certain hit, first or behind an open piece, else the open piece if it is a
    /// tangency. Nothing for a miss, and nothing if all is unresolved.
    pub fn shown(&self) -> Option<Interval> {
        match self.first {
            Verdict::Root { t } | Verdict::Crossing { t } => Some(t),
            Verdict::Tangent { t, .. } => Some(t),
            Verdict::Unresolved { .. } => self.behind.and_then(|v| v.t()),
            Verdict::Miss => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open(lo: f64, hi: f64, why: Why) -> Verdict {
        Verdict::Unresolved {
            t: Interval { lo, hi },
            why,
        }
    }

    fn appended(verdicts: &[Verdict]) -> Vec<Verdict> {
        let mut events = Vec::new();
        for verdict in verdicts {
            verdict.append(&mut events);
        }
        events
    }

    #[test]
    fn touching_pieces_become_one() {
        let list = [
            open(1.0, 2.0, Why::Undefined),
            open(2.0, 3.0, Why::Floor),
            open(3.5, 4.0, Why::Floor),
        ];
        assert_eq!(
            appended(&list),
            [open(1.0, 3.0, Why::Undefined), open(3.5, 4.0, Why::Floor)]
        );
    }

    #[test]
    fn a_crossing_joins_only_what_is_continuous() {
        let crossing = Verdict::Crossing {
            t: Interval { lo: 2.0, hi: 3.0 },
        };
        let both = Verdict::Crossing {
            t: Interval { lo: 1.0, hi: 3.0 },
        };
        assert_eq!(appended(&[open(1.0, 2.0, Why::Floor), crossing]), [both]);
        let pole = open(1.0, 2.0, Why::Undefined);
        assert_eq!(appended(&[pole, crossing]), [pole, crossing]);
    }

    #[test]
    fn a_root_behind_an_open_piece_is_not_the_first() {
        let root = Verdict::Root {
            t: Interval { lo: 2.0, hi: 2.0 },
        };
        let answer = Answer::from_events(0.0, &[open(1.0, 2.0, Why::Floor), root]);
        assert_eq!(
            (answer.first, answer.behind),
            (open(1.0, 2.0, Why::Floor), Some(root))
        );
        assert_eq!(Answer::from_events(0.0, &[]), Answer::miss(0.0));
    }
}
