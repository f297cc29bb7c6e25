//! What an oracle says about an answer.

use zeroset::camera::Ray;
use zeroset::interval::Interval;
use zeroset::verdict::{Answer, Verdict};

use crate::dyadic::{Dyadic, Rational};
use crate::segment::{Corners, clip, place};
use crate::sturm::{Poly, Sturm};

/// What an oracle says about an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// All that the answer claims is true.
    Right,
    /// Something that it claims is false.
    Wrong(String),
    /// The oracle cannot tell.
    Undecided(String),
}

/// An independent source of truth about a surface inside a box.
pub trait Oracle: Sync {
    /// Judges answers about one ray, for each path.
    fn judge(&self, ray: &Ray, corners: &Corners, answers: &[Answer]) -> Vec<Finding>;

    /// Judges a list of all events along a ray, in ascending order; an oracle that knows the first root only finds
    /// nothing wrong with it.
    fn judge_all(
        &self,
        _ray: &Ray,
        _corners: &Corners,
        _entry: f64,
        _events: &[Verdict],
    ) -> Result<(), String> {
        Ok(())
    }
}

/// Judges each answer that differs from the one before it.
pub fn judge_each(answers: &[Answer], mut judge: impl FnMut(&Answer) -> Finding) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::with_capacity(answers.len());
    for (i, answer) in answers.iter().enumerate() {
        let again = answers[..i].iter().position(|before| before == answer);
        findings.push(match again {
            Some(before) => findings[before].clone(),
            None => judge(answer),
        });
    }
    findings
}

/// A surface that is a polynomial along every ray.
pub struct Polynomial<F>(pub F);

impl<F: Fn(&Ray) -> Poly + Sync> Oracle for Polynomial<F> {
    fn judge(&self, ray: &Ray, corners: &Corners, answers: &[Answer]) -> Vec<Finding> {
        let roots = (self.0)(ray).sturm();
        let segment = clip(ray, corners);
        judge_each(answers, |answer| {
            let verdict = match &roots {
                None => in_the_surface(answer),
                Some(roots) => all_claims(roots, segment.as_ref(), answer),
            };
            verdict.map_or_else(Finding::Wrong, |()| Finding::Right)
        })
    }

    fn judge_all(
        &self,
        ray: &Ray,
        corners: &Corners,
        entry: f64,
        events: &[Verdict],
    ) -> Result<(), String> {
        let Some((near, far)) = clip(ray, corners) else {
            return Ok(());
        };
        match (self.0)(ray).sturm() {
            Some(roots) => complete(&roots, &near, &far, entry, events),
            None => Ok(()),
        }
    }
}

/// Every verdict is right, and the roots between the events are none.
fn complete(
    roots: &Sturm,
    near: &Rational,
    far: &Rational,
    entry: f64,
    events: &[Verdict],
) -> Result<(), String> {
    let mut searched = near.clone();
    for event in events {
        claim(roots, entry, event)?;
        let Some(t) = event.t() else { continue };
        let (lo, hi) = (place(entry, t.lo), place(entry, t.hi));
        // A root at the end of an event belongs to it.
        let between = roots.before(&searched, &lo);
        let shared = usize::from(roots.sign(&searched) == 0 && searched.compare(near).is_gt());
        if between > shared {
            return Err(format!("{between} roots between events"));
        }
        if hi.compare(&searched).is_gt() {
            searched = hi;
        }
    }
    let shared = usize::from(roots.sign(&searched) == 0 && searched.compare(near).is_gt());
    let behind = roots.closed(&searched, far);
    if behind > shared {
        return Err(format!("{behind} roots behind the last event"));
    }
    Ok(())
}

/// The whole ray lies in the surface: no root is the only one in an interval with a width, nor is there a miss.
fn in_the_surface(answer: &Answer) -> Result<(), String> {
    match answer.first {
        Verdict::Unresolved { .. } => Ok(()),
        other => Err(format!("f is 0 along the ray: {other:?}")),
    }
}

fn all_claims(
    roots: &Sturm,
    segment: Option<&(Rational, Rational)>,
    answer: &Answer,
) -> Result<(), String> {
    let Some(t) = answer.first.t() else {
        let count = segment.map_or(0, |(near, far)| roots.closed(near, far));
        return if count == 0 {
            Ok(())
        } else {
            Err(format!("called a miss, has {count} roots"))
        };
    };
    if let Some((near, _)) = segment {
        let entry = Rational::dyadic(&Dyadic::float(answer.entry));
        if entry.compare(near).is_gt() {
            return Err("the entry lies behind the box's face".into());
        }
        let before = roots.before(near, &place(answer.entry, t.lo));
        if before > 0 {
            return Err(format!("{before} roots before the first event"));
        }
    }
    claim(roots, answer.entry, &answer.first)?;
    match &answer.behind {
        Some(behind) => claim(roots, answer.entry, behind),
        None => Ok(()),
    }
}

/// What a verdict says about its own interval.
fn claim(roots: &Sturm, entry: f64, verdict: &Verdict) -> Result<(), String> {
    let Some(Interval { lo, hi }) = verdict.t() else {
        return Ok(());
    };
    let (lo, hi) = (place(entry, lo), place(entry, hi));
    let inside = roots.closed(&lo, &hi);
    let changes = roots.sign(&lo) * roots.sign(&hi) <= 0;
    match verdict {
        Verdict::Root { .. } if inside != 1 || !changes => Err(format!(
            "{inside} roots in the interval, change of sign: {changes}"
        )),
        Verdict::Crossing { .. } if inside == 0 || !changes => Err(format!(
            "{inside} roots at a crossing, change of sign: {changes}"
        )),
        Verdict::Tangent { .. } if inside > 2 => Err(format!("{inside} roots at a tangency")),
        _ => Ok(()),
    }
}
