//! What a ray must be answered.

use std::fmt;

use zeroset::render::Trail;
use zeroset::verdict::{Verdict, Why};

/// An event at a parameter of the ray, as near as `f64`s tell.
#[derive(Clone, Debug)]
pub enum Expected {
    /// A root, in an interval of two units in the last place or so.
    Root(f64),
    /// A tangency, no wider than 1e-6.
    Tangent(f64),
    /// A change of sign, no wider than 1e-12.
    Crossing(f64),
    /// Undecided from about here to about there.
    Open(Why, f64, f64),
    /// Undecided around here, in an interval that may be this wide.
    Near(Why, f64, f64),
    /// A root or a change of sign, in an interval that may be this wide: what f64 can tell of f is not more.
    Hit(f64, f64),
    /// Any number of events that end no search.
    Noise,
    /// What is true is finer than some processor path can tell.
    Or(Box<Expected>, Box<Expected>),
    /// This, or nothing.
    Maybe(Box<Expected>),
}

impl Expected {
    /// This, or else that.
    #[must_use]
    pub fn or(self, other: Expected) -> Expected {
        Expected::Or(Box::new(self), Box::new(other))
    }

    /// A root in an interval that may be this wide, or undecided there: a change of sign that is wider than a crossing may be.
    #[must_use]
    pub fn wide(at: f64, width: f64) -> Expected {
        Expected::Hit(at, width).or(Expected::Near(Why::Floor, at, width))
    }

    /// This, or nothing.
    #[must_use]
    pub fn or_nothing(self) -> Expected {
        Expected::Maybe(Box::new(self))
    }

    fn is_met(&self, entry: f64, event: &Verdict) -> bool {
        let Some(t) = event.t() else {
            return false;
        };
        let (lo, hi) = (entry + t.lo, entry + t.hi);
        let around = |at: f64, width: f64| {
            let slack = 1e-12 * at.abs().max(1.0);
            lo - slack <= at && at <= hi + slack && hi - lo <= width * at.abs().max(1.0)
        };
        match (self, event) {
            (Expected::Root(at), Verdict::Root { .. }) => around(*at, 1e-15),
            (Expected::Tangent(at), Verdict::Tangent { .. }) => around(*at, 1e-6),
            (Expected::Crossing(at), Verdict::Crossing { .. }) => around(*at, 1e-12),
            (Expected::Open(why, from, to), Verdict::Unresolved { why: w, .. }) => {
                let near = |a: f64, b: f64| (a - b).abs() <= 0.1 * (to - from);
                why == w && near(lo, *from) && near(hi, *to)
            }
            (Expected::Hit(at, width), Verdict::Root { .. } | Verdict::Crossing { .. }) => {
                around(*at, *width)
            }
            (Expected::Noise, Verdict::Unresolved { why, .. }) => *why != Why::Budget,
            (Expected::Noise, _) => true,
            (Expected::Near(why, at, width), Verdict::Unresolved { why: w, .. }) => {
                why == w && around(*at, *width)
            }
            (Expected::Or(one, other), _) => one.is_met(entry, event) || other.is_met(entry, event),
            (Expected::Maybe(some), _) => some.is_met(entry, event),
            _ => false,
        }
    }
}

/// Why the events are not the expected ones, if they are not.
pub(crate) fn complaint(expected: &[Expected], trail: &Trail) -> Option<String> {
    let mut events = trail.events.iter().peekable();
    for one in expected {
        let mut meet = || events.next_if(|event| one.is_met(trail.entry, event));
        let met = meet().is_some();
        while matches!(one, Expected::Noise) && meet().is_some() {}
        if !met && !matches!(one, Expected::Maybe(_) | Expected::Noise) {
            return Some(format!(
                "no {one:?} in {:?} from {}",
                trail.events, trail.entry
            ));
        }
    }
    let more = events.next()?;
    Some(format!("{more:?} from {} was not expected", trail.entry))
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Expected::Root(at) => write!(f, "Root {at:.6}"),
            Expected::Tangent(at) => write!(f, "Tangent {at:.6}"),
            Expected::Crossing(at) => write!(f, "Crossing {at:.6}"),
            Expected::Open(why, from, to) => write!(f, "Unresolved ({why:?}) {from:.6} to {to:.6}"),
            Expected::Near(why, at, width) => {
                write!(f, "Unresolved ({why:?}) {at:.6}, at most {width:.0e} wide")
            }
            Expected::Hit(at, width) => {
                write!(f, "Root or Crossing {at:.6}, at most {width:.0e} wide")
            }
            Expected::Noise => write!(f, "[Unresolved, Crossing, …]"),
            Expected::Or(one, other) => write!(f, "{one} or {other}"),
            Expected::Maybe(some) => write!(f, "[{some}]"),
        }
    }
}
