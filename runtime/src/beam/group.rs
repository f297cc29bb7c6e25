//! Eight beams side by side, in the lanes of a packet.

use super::{Direction, Frame, Shift, Slab, Towards};
use crate::interval::{Interval, Packet};

/// How a rectangle of pixels is divided into eight: columns and rows of equal parts, and a part's size in pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    pub columns: u32,
    pub part: [u32; 2],
    /// Do the beams hold the whole pixels' rays, or only those through the places where they are sampled?
    pub whole: bool,
}

/// Eight beams.
#[derive(Clone, Copy)]
pub(crate) struct Group<'a, P: Packet> {
    frame: &'a Frame,
    /// The middles of the beams, in pixels to the right and up from the middle of the picture.
    pub pixels: [P::F; 2],
    /// The middles of the beams on the picture plane, and half their sizes.
    middle: [P::F; 2],
    half: [P::F; 2],
}

impl<'a, P: Packet> Group<'a, P> {
    /// The beams of a grid whose upper left pixel is sampled at `corner`, or has its middle there if the beams hold whole
    /// pixels; in pixels to the right and up from the middle of the picture.
    #[inline(always)]
    pub fn new(p: P, frame: &'a Frame, corner: [f64; 2], grid: &Grid) -> Self {
        let [width, height] = grid.part;
        Self::of(p, frame, grid.part, grid.whole, |lane| {
            let (column, row) = (lane as u32 % grid.columns, lane as u32 / grid.columns);
            let [right, down] = [column * width, row * height].map(f64::from);
            [corner[0] + right, corner[1] - down]
        })
    }

    /// The beam of a rectangle of pixels, through the places where they are sampled, in all lanes.
    #[inline(always)]
    pub fn alone(p: P, frame: &'a Frame, corner: [f64; 2], size: [u32; 2]) -> Self {
        Self::of(p, frame, size, false, |_| corner)
    }

    /// Beams of this size, of which the upper left pixels are told.
    #[inline(always)]
    fn of(
        p: P,
        frame: &'a Frame,
        size: [u32; 2],
        whole: bool,
        corner: impl Fn(usize) -> [f64; 2],
    ) -> Self {
        let size = size.map(f64::from);
        let (mut x, mut y) = ([0.0; 8], [0.0; 8]);
        for lane in p.own() {
            let corner = corner(lane);
            x[lane] = corner[0] + 0.5 * (size[0] - 1.0);
            y[lane] = corner[1] - 0.5 * (size[1] - 1.0);
        }
        // Pixels are exact numbers here; the size of a pixel times one is rounded, and so is the middle.
        let pixel = p.splat(frame.pixel);
        let pixels = [p.lanes(x), p.lanes(y)];
        let middle = pixels.map(|x| p.mul_rn(x, pixel));
        let mut half = middle;
        for (k, size) in size.into_iter().enumerate() {
            let reach = if whole { size } else { size - 1.0 };
            let round = p.mul_ru(p.abs_f(middle[k]), p.splat(f64::EPSILON));
            half[k] = p.add_ru(round, p.mul_ru(p.splat(0.5 * reach), pixel));
        }
        Group {
            frame,
            pixels,
            middle,
            half,
        }
    }

    /// From the picture's leaves to these beams'.
    #[inline(always)]
    pub fn shift(&self, p: P) -> Shift<P> {
        let zero = p.splat(0.0);
        if !self.frame.perspective {
            return Shift {
                p,
                at: self.middle,
                turn: [zero; 2],
            };
        }
        let near = p.splat(self.frame.near);
        Shift {
            p,
            at: [
                p.mul_rn(self.middle[0], near),
                p.mul_rn(self.middle[1], near),
            ],
            turn: self.middle,
        }
    }

    /// The beams over `t`, which counts from the frame's `near`.
    #[inline(always)]
    pub fn slab(&self, p: P, t: &Interval<P::F>) -> Slab<P::F> {
        let slack = p.splat(self.frame.slack);
        let mut half = self.half;
        if self.frame.perspective {
            let far = p.add_ru(p.splat(self.frame.near), t.hi);
            let far = p.max_f(far, p.splat(0.0));
            for h in &mut half {
                *h = p.mul_ru(*h, far);
            }
        }
        Slab {
            t: *t,
            half: [p.add_ru(half[0], slack), p.add_ru(half[1], slack)],
        }
    }

    /// All directions over a piece and a little more: the rays' own t differs by the frame's slack.
    #[inline(always)]
    pub fn around(&self, p: P, front: P::F, back: P::F) -> Towards<P::F> {
        let slack = p.splat(8.0 * self.slack());
        let t = Interval {
            lo: p.max_f(p.sub_rd(front, slack), p.splat(0.0)),
            hi: p.add_ru(back, slack),
        };
        self.towards(p, self.slab(p, &t), Direction::Any)
    }

    /// A direction over `over`.
    #[inline(always)]
    pub fn towards(&self, p: P, over: Slab<P::F>, direction: Direction) -> Towards<P::F> {
        let tilt = p.splat(self.frame.tilt);
        let mut turn = [tilt; 2];
        if self.frame.perspective {
            turn = [p.add_ru(self.half[0], tilt), p.add_ru(self.half[1], tilt)];
        }
        Towards {
            over,
            direction,
            tilt,
            turn,
        }
    }

    /// Where the beams may be inside a box: bounds of t, which counts from the frame's `near`; crossed where they
    /// certainly are outside. On each axis the beam's box [m − r, m + r], linear in t, must reach the box's two faces.
    #[inline(always)]
    pub fn span(&self, p: P, domain: &[[f64; 3]; 2]) -> Interval<P::F> {
        let zero = p.splat(0.0);
        let frame = self.frame;
        let start = self.slab(p, &p.point(zero)).half;
        let Shift { at, turn, .. } = self.shift(p);
        let mut span = Interval {
            lo: zero,
            hi: p.splat(frame.far - frame.near),
        };
        for axis in 0..3 {
            let [forward, right, up] = frame.axes.map(|v| p.splat(v[axis]));
            let origin = p.recentre(p.splat(frame.near), forward, p.splat(frame.from[axis]));
            let (side, above) = (p.point(right), p.point(up));
            let m = p.add(p.mul(side, p.point(at[0])), p.mul(above, p.point(at[1])));
            let m = p.add(origin, m);
            let d = p.add(
                p.mul(side, p.point(turn[0])),
                p.mul(above, p.point(turn[1])),
            );
            let d = p.add(p.point(forward), d);
            let (side, above) = (p.abs_f(right), p.abs_f(up));
            let r = p.add_ru(p.mul_ru(side, start[0]), p.mul_ru(above, start[1]));
            let mut grows = zero;
            if frame.perspective {
                grows = p.add_ru(p.mul_ru(side, self.half[0]), p.mul_ru(above, self.half[1]));
            }
            // m + r ≥ low and m − r ≤ high.
            let low = p.sub_ru(p.add_ru(m.hi, r), p.splat(domain[0][axis]));
            let high = p.sub_ru(p.splat(domain[1][axis]), p.sub_rd(m.lo, r));
            reach(p, low, p.add_ru(d.hi, grows), &mut span);
            reach(p, high, p.sub_ru(grows, d.lo), &mut span);
        }
        span
    }

    /// Are the beams over `t` inside a box? They are convex: their corners tell.
    #[inline(always)]
    pub fn inside(&self, p: P, t: &Interval<P::F>, domain: &[[f64; 3]; 2]) -> P::M {
        let frame = self.frame;
        let slab = self.slab(p, t);
        let Shift { at, turn, .. } = self.shift(p);
        let side = |k: usize| {
            let middle = p.add(p.point(at[k]), p.mul(p.point(turn[k]), *t));
            Interval {
                lo: p.sub_rd(middle.lo, slab.half[k]),
                hi: p.add_ru(middle.hi, slab.half[k]),
            }
        };
        let (x, y) = (side(0), side(1));
        let mut inside = p.not(p.none());
        for axis in 0..3 {
            let [forward, right, up] = frame.axes.map(|v| p.point(p.splat(v[axis])));
            let origin = p.recentre(p.splat(frame.near), forward.lo, p.splat(frame.from[axis]));
            let along = p.add(origin, p.mul(forward, *t));
            let place = p.add(along, p.add(p.mul(right, x), p.mul(up, y)));
            let [low, high] = domain.map(|corner| p.splat(corner[axis]));
            inside = p.and(inside, p.and(p.le(low, place.lo), p.le(place.hi, high)));
        }
        inside
    }

    /// The size of a pixel in x and y at t.
    #[inline(always)]
    pub fn pixel(&self, p: P, t: P::F) -> P::F {
        let pixel = p.splat(self.frame.pixel);
        if self.frame.perspective {
            p.mul_rn(pixel, p.add_rn(p.splat(self.frame.near), t))
        } else {
            pixel
        }
    }

    /// See [`Frame`].
    #[inline(always)]
    pub fn slack(&self) -> f64 {
        self.frame.slack
    }

    /// The width of the beams at t, measured along them.
    #[inline(always)]
    pub fn width(&self, p: P, t: P::F) -> P::F {
        let slab = self.slab(p, &Interval { lo: t, hi: t });
        let [x, y] = [0, 1].map(|k| p.mul_rn(slab.half[k], p.splat(2.0 * self.frame.aspect[k])));
        p.max_f(x, y)
    }
}

/// Cuts `span` down to where a + bt ≥ 0, for all a and b up to these.
#[inline(always)]
fn reach<P: Packet>(p: P, a: P::F, b: P::F, span: &mut Interval<P::F>) {
    let zero = p.splat(0.0);
    let never = p.splat(f64::INFINITY);
    let negative = p.lt(a, zero);
    let from = p.select(p.lt(zero, b), p.div_rd(p.neg_f(a), b), never);
    span.lo = p.select(negative, p.max_f(from, span.lo), span.lo);
    let to = p.div_ru(a, p.neg_f(b));
    let falls = p.and_not(p.lt(b, zero), negative);
    span.hi = p.select(falls, p.min_f(to, span.hi), span.hi);
}
