//! From the trails of the operands along one ray to the faces of the solid.

use super::tree::{Node, Side};
use crate::interval::Interval;
use crate::trace::{Mark, Trails};
use crate::verdict::{Verdict, Why};

/// One operand along one ray.
pub(super) struct Operand<'a> {
    /// Its trails, if it was traced.
    pub trails: Option<&'a Trails>,
    /// Where it was traced; empty if it was not.
    pub searched: Interval,
    pub marks: &'a [Mark],
    /// Its side in the gap that was reached, where it was traced.
    pub side: Side,
    /// Its side where it was not, by pieces of the ray.
    pub survey: &'a [Side; 8],
}

/// An event of the solid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub verdict: Verdict,
    /// The operand that it belongs to.
    pub leaf: usize,
    /// Other operands have an event in the same place.
    pub tied: bool,
}

/// A mark of an operand.
#[derive(Clone, Copy)]
struct Item<'a> {
    leaf: usize,
    mark: &'a Mark,
}

/// Up to so many operands that meet in one place are looked at in every order.
const ORDERS: usize = 8;

/// One ray after the other.
pub(super) struct Sweep<'a> {
    pub node: &'a Node,
    /// The pieces of a survey.
    pub pieces: [Interval; 8],
    /// The operands along the ray.
    pub operands: Vec<Operand<'a>>,
    /// Is the first certain hit enough?
    pub first_only: bool,
    pub faces: Vec<Face>,
}

impl<'a> Sweep<'a> {
    /// Goes along the ray. Marks that overlap form a cluster. Between clusters each operand has one certain side, and so
    /// has the solid.
    pub fn run(&mut self, over: Interval) {
        self.faces.clear();
        let mut items: Vec<Item<'a>> = Vec::new();
        for (leaf, operand) in self.operands.iter().enumerate() {
            items.extend(operand.marks.iter().map(|mark| Item { leaf, mark }));
        }
        items.sort_by(|a, b| a.mark.reach.lo.total_cmp(&b.mark.reach.lo));
        let mut from = over.lo;
        for cluster in clusters(&items) {
            let reach = reach(cluster);
            self.gap(from, reach.lo);
            self.cluster(cluster);
            from = reach.hi;
            if self.first_only && self.faces.iter().any(|f| f.verdict.is_certain_hit()) {
                return;
            }
        }
        self.gap(from, over.hi);
    }

    /// What is not known in a gap is reported. Where operands were traced or surveyed piece by piece, so is the gap looked
    /// at: an operand that was not traced on a piece does not matter there.
    fn gap(&mut self, lo: f64, hi: f64) {
        if lo >= hi || self.is_known(Interval { lo, hi }) {
            return;
        }
        let searched = self.operands.iter().map(|operand| operand.searched);
        let mut cuts: Vec<f64> = searched
            .chain(self.pieces)
            .flat_map(|piece| [piece.lo, piece.hi])
            .filter(|cut| lo < *cut && *cut < hi)
            .collect();
        cuts.push(hi);
        cuts.sort_by(f64::total_cmp);
        let (mut from, mut open): (f64, Option<f64>) = (lo, None);
        for cut in cuts {
            let t = Interval { lo: from, hi: cut };
            if from < cut && !self.is_known(t) {
                open.get_or_insert(from);
            } else if let Some(lo) = open.take() {
                self.unknown(Interval { lo, hi: from }, 0);
            }
            from = cut;
        }
        if let Some(lo) = open {
            self.unknown(Interval { lo, hi }, 0);
        }
    }

    fn is_known(&self, t: Interval) -> bool {
        self.node.side(&|leaf| self.side_over(leaf, t)) != Side::Unknown
    }

    /// Where an operand that matters is on no certain side.
    fn unknown(&mut self, t: Interval, leaf: usize) {
        let why = Why::Floor;
        self.put(Verdict::Unresolved { t, why }, leaf, true);
    }

    fn put(&mut self, verdict: Verdict, leaf: usize, tied: bool) {
        self.faces.push(Face {
            verdict,
            leaf,
            tied,
        });
    }

    /// The side of an operand over a piece in which it has no mark: as traced, and as surveyed where it was not.
    fn side_over(&self, leaf: usize, t: Interval) -> Side {
        let Operand {
            searched,
            side,
            survey,
            ..
        } = &self.operands[leaf];
        if searched.lo <= t.lo && t.hi <= searched.hi {
            return *side;
        }
        if searched.lo > searched.hi && survey.iter().all(|side| *side == survey[0]) {
            return survey[0];
        }
        let inside = t.intersect(searched).map(|_| *side);
        let before = Interval {
            lo: t.lo,
            hi: t.hi.min(searched.lo),
        };
        let behind = Interval {
            lo: t.lo.max(searched.hi),
            hi: t.hi,
        };
        let outside = [before, behind]
            .into_iter()
            .filter(|t| t.lo < t.hi || inside.is_none() && t.lo == t.hi);
        let surveyed = outside.flat_map(|t| {
            // Pieces that only touch it say nothing of it.
            let met = move |(piece, _): &(&Interval, &Side)| {
                piece.lo < t.hi && t.lo < piece.hi || t.lo == t.hi && piece.contains(t.lo)
            };
            let sides = self.pieces.iter().zip(survey.iter()).filter(met);
            sides.map(|(_, side)| *side)
        });
        let sides = inside.into_iter().chain(surveyed);
        sides.reduce(Side::joined).unwrap_or(Side::Unknown)
    }

    /// Marks that overlap, in ascending order. Operands that cannot matter here are left out; if that breaks the cluster,
    /// each part is looked at by itself.
    fn cluster(&mut self, items: &[Item]) {
        let t = reach(items);
        let mut sides: Vec<Side> = (0..self.operands.len())
            .map(|leaf| self.side_over(leaf, t))
            .collect();
        for item in items {
            sides[item.leaf] = Side::Unknown;
        }
        self.matter(items, &sides);
        for item in items {
            self.operands[item.leaf].side = item.mark.after;
        }
    }

    fn matter(&mut self, items: &[Item], sides: &[Side]) {
        let side = |leaf: usize| sides[leaf];
        if self.node.side(&side) != Side::Unknown {
            return;
        }
        let mut matters = vec![false; sides.len()];
        self.node.relevant(&side, &mut |leaf| matters[leaf] = true);
        let member = |leaf: usize| items.iter().any(|item| item.leaf == leaf);
        let unseen =
            |(leaf, side): (usize, &Side)| matters[leaf] && *side == Side::Unknown && !member(leaf);
        if sides.iter().enumerate().any(unseen) {
            self.unknown(reach(items), items[0].leaf);
            return;
        }
        let kept: Vec<Item> = items.iter().filter(|i| matters[i.leaf]).copied().collect();
        let parts: Vec<&[Item]> = clusters(&kept).collect();
        if parts.len() == 1 && kept.len() == items.len() {
            self.together(items, sides);
            return;
        }
        for part in parts {
            let mut sides = sides.to_vec();
            for item in &kept {
                sides[item.leaf] = self.operands[item.leaf].side;
            }
            for item in part {
                sides[item.leaf] = Side::Unknown;
            }
            self.matter(part, &sides);
            for item in part {
                self.operands[item.leaf].side = item.mark.after;
            }
        }
    }

    /// Marks that overlap, all of operands that matter.
    ///
    /// One operand alone: all others are on certain sides, so f of the solid, by min and max, is the operand's f up to its
    /// sign, cut off above and below at values of other signs: it has the same roots, and the operand's verdicts hold.
    fn together(&mut self, items: &[Item], sides: &[Side]) {
        let leaf = items[0].leaf;
        if items.iter().all(|item| item.leaf == leaf) {
            let trails = self.operands[leaf].trails;
            for verdict in items
                .iter()
                .flat_map(|i| trails.map(|t| t.verdicts(i.mark)))
                .flatten()
            {
                self.put(*verdict, leaf, false);
            }
            return;
        }
        let t = reach(items);
        let verdict = match self.one_root(items, sides) {
            Some(t) => Verdict::Root { t },
            None => self.sign_change(items, sides, t),
        };
        self.put(verdict, leaf, true);
    }

    /// Each of a few operands has one root and changes its side there. If the solid changes its side once, in whatever
    /// order they do, then its f has exactly one root.
    ///
    /// Proof. Let the sides of the solid be a function of the set of operands that have changed theirs. If from the one
    /// side no further change leads back, then any order has one change, and it comes with a time that grows with each
    /// operand's root: its bounds are those for the lower and for the upper bounds of the roots. Where several operands
    /// have their roots at one time, f is between its values for all their signs, so it is 0 only if the solid changes.
    fn one_root(&self, items: &[Item], sides: &[Side]) -> Option<Interval> {
        if items.len() > ORDERS {
            return None;
        }
        let mut roots = Vec::with_capacity(items.len());
        for (k, item) in items.iter().enumerate() {
            let trails = self.operands[item.leaf].trails?;
            let [Verdict::Root { t }] = trails.verdicts(item.mark) else {
                return None;
            };
            let (before, after) = (self.operands[item.leaf].side, item.mark.after);
            let twice = items[..k].iter().any(|other| other.leaf == item.leaf);
            if twice || before == Side::Unknown || after != before.opposite() {
                return None;
            }
            roots.push(*t);
        }
        let mut sides = sides.to_vec();
        let wholes: Vec<Side> = (0..1usize << items.len())
            .map(|changed| {
                for (k, item) in items.iter().enumerate() {
                    let before = self.operands[item.leaf].side;
                    let has = changed >> k & 1 != 0;
                    sides[item.leaf] = if has { before.opposite() } else { before };
                }
                self.node.side(&|leaf: usize| sides[leaf])
            })
            .collect();
        let after = wholes[wholes.len() - 1];
        let stays = |changed: usize| {
            wholes[changed] != after || (0..items.len()).all(|k| wholes[changed | 1 << k] == after)
        };
        let one = wholes[0] == after.opposite() && !wholes.contains(&Side::Unknown);
        if !one || !(0..wholes.len()).all(stays) {
            return None;
        }
        let time = |at: fn(&Interval) -> f64| {
            let mut order: Vec<usize> = (0..items.len()).collect();
            order.sort_by(|&i, &k| at(&roots[i]).total_cmp(&at(&roots[k])));
            let mut changed = 0;
            order.into_iter().find(|k| {
                changed |= 1 << k;
                wholes[changed] == after
            })
        };
        let (lo, hi) = (time(|t| t.lo)?, time(|t| t.hi)?);
        Some(Interval {
            lo: roots[lo].lo,
            hi: roots[hi].hi,
        })
    }

    /// A change of sides, if both are certain and f is continuous; else it is open.
    fn sign_change(&self, items: &[Item], sides: &[Side], t: Interval) -> Verdict {
        let mut sides = sides.to_vec();
        for item in items.iter().rev() {
            sides[item.leaf] = item.mark.before;
        }
        let before = self.node.side(&|leaf: usize| sides[leaf]);
        for item in items {
            sides[item.leaf] = item.mark.after;
        }
        let after = self.node.side(&|leaf: usize| sides[leaf]);
        let mut why = Why::Order;
        for item in items {
            let trails = self.operands[item.leaf].trails;
            for verdict in trails.map_or(&[][..], |trails| trails.verdicts(item.mark)) {
                if let Verdict::Unresolved { why: other, .. } = verdict {
                    why = why.max(*other);
                }
            }
        }
        let change = before != Side::Unknown && after == before.opposite();
        if change && why <= Why::Flat {
            Verdict::Crossing { t }
        } else {
            Verdict::Unresolved { t, why }
        }
    }
}

/// The hull of the reaches of marks, which are in ascending order.
fn reach(items: &[Item]) -> Interval {
    let hi = items.iter().map(|item| item.mark.reach.hi);
    Interval {
        lo: items[0].mark.reach.lo,
        hi: hi.fold(f64::NEG_INFINITY, f64::max),
    }
}

/// Splits marks into runs that overlap.
fn clusters<'s, 'a>(items: &'s [Item<'a>]) -> impl Iterator<Item = &'s [Item<'a>]> {
    let mut rest = items;
    std::iter::from_fn(move || {
        let mut hi = rest.first()?.mark.reach.hi;
        let mut count = 1;
        while let Some(next) = rest.get(count).filter(|next| next.mark.reach.lo <= hi) {
            hi = hi.max(next.mark.reach.hi);
            count += 1;
        }
        let (cluster, behind) = rest.split_at(count);
        rest = behind;
        Some(cluster)
    })
}
