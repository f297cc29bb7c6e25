//! Leaves over beams hold what the rays in them have, as twice the precision tells.

use glam::DVec3;

use super::{Assemble, Direction, Frame, Grid, Group, QuadraticOver};
use crate::camera::{Camera, Sampling};
use crate::interval::{
    Arithmetic, Ball, Fine, Interval, Isa, Kernel, Linear, Packet, Parameter, Quadratic, Rebind,
};
use crate::solve::select;

const PICTURE: [u32; 2] = [61, 47];
const DOMAIN: [[f64; 3]; 2] = [[-1.1, -0.9, -1.3], [1.2, 1.0, 0.8]];

/// What is compared, and how often it was not enclosed.
#[derive(Default)]
struct Tally {
    compared: u64,
    outside: u64,
}

impl Tally {
    /// Is a value of the ball certainly outside?
    fn add(&mut self, enclosure: Interval, truth: Ball) {
        let truth = truth.interval();
        self.compared += 1;
        self.outside += u64::from(truth.hi < enclosure.lo || enclosure.hi < truth.lo);
    }
}

/// x·y along the lines of the frame.
fn product<P: Packet>(p: P, frame: &Frame) -> Quadratic<P> {
    let rays = frame.lines(p);
    let ([x, y, _], [dx, dy, _]) = (rays.origin, rays.direction);
    let c1 = p.add(p.mul(x, dy), p.mul(y, dx));
    Quadratic::new(p, p.mul(x, y), c1, p.mul(dx, dy))
}

struct Compare {
    camera: Camera,
    frame: Frame,
}

impl Compare {
    fn all<P: Packet>(&self, p: P, tally: &mut Tally) {
        let eight = p.eight();
        let rays = self.frame.lines(eight);
        let map = Assemble(p);
        let form = map.quadratic(&product(eight, &self.frame));
        let z = map.linear(&Linear::new(eight, rays.origin[2], rays.direction[2]));
        for (size, grid) in [
            (
                1,
                Grid {
                    columns: 4,
                    part: [1, 1],
                    whole: false,
                },
            ),
            (
                8,
                Grid {
                    columns: 4,
                    part: [8, 8],
                    whole: true,
                },
            ),
        ] {
            for corner in [[0, 0], [24, 16], [28, 30]] {
                let sampled = crate::camera::plane(corner, PICTURE, Sampling::Centre);
                let group = Group::new(p, &self.frame, [sampled[0], sampled[1]], &grid);
                let shift = group.shift(p);
                let (form, z) = (shift.quadratic(&form), shift.linear(&z));
                // The first and the last pixel of each beam.
                for pixel in [[0, 0], [size - 1, size - 1]] {
                    for part in [0.0, 0.3, 0.7, 1.0] {
                        let Frame { near, far, .. } = self.frame;
                        let t = near.max(0.0) + part * (far - near.max(0.0));
                        let at = Sample {
                            corner,
                            pixel,
                            size,
                            t,
                        };
                        self.one(p, &group, &at, (&form, &z), tally);
                    }
                }
            }
        }
    }

    fn one<P: Packet>(
        &self,
        p: P,
        group: &Group<P>,
        at: &Sample,
        (form, z): (&QuadraticOver<P>, &super::LinearOver<P>),
        tally: &mut Tally,
    ) {
        let Frame { near, slack, .. } = self.frame;
        let t = p.sub(p.point(p.splat(at.t)), p.point(p.splat(near)));
        let t = Interval {
            lo: p.max_f(p.sub_rd(t.lo, p.splat(slack)), p.splat(0.0)),
            hi: p.add_ru(t.hi, p.splat(slack)),
        };
        let slab = group.slab(p, &t);
        let along = group.towards(p, slab, Direction::Along);
        let enclosures = [
            slab.quadratic(p, form),
            slab.linear(p, z),
            along.quadratic_slope(p, form),
            along.linear_slope(p, z),
        ];
        for lane in 0..8 {
            let pixel = at.pixel_of(lane);
            if pixel[0] >= PICTURE[0] || pixel[1] >= PICTURE[1] {
                continue;
            }
            let ray = self
                .camera
                .ray(pixel[0], pixel[1], PICTURE[0], PICTURE[1], Sampling::Centre);
            let d = ray.direction.to_array();
            let [x, y, z] = [0, 1, 2].map(|k| Ball::sum(at.t, 0.0).along(ray.origin[k], d[k]));
            let number = |x: f64| Ball::sum(x, 0.0);
            let slope = Fine.add(Fine.mul(number(d[0]), y), Fine.mul(number(d[1]), x));
            let truths = [Fine.mul(x, y), z, slope, number(d[2])];
            for (enclosure, truth) in enclosures.iter().zip(truths) {
                let own = Interval {
                    lo: p.to_array(enclosure.lo)[lane],
                    hi: p.to_array(enclosure.hi)[lane],
                };
                tally.add(own, truth);
            }
        }
    }
}

/// A pixel of each beam of a grid of 4×2, and a parameter.
struct Sample {
    corner: [u32; 2],
    pixel: [u32; 2],
    size: u32,
    t: f64,
}

impl Sample {
    fn pixel_of(&self, lane: usize) -> [u32; 2] {
        let (x, y) = (lane as u32 % 4, lane as u32 / 4);
        [
            self.corner[0] + x * self.size + self.pixel[0],
            self.corner[1] + y * self.size + self.pixel[1],
        ]
    }
}

impl Kernel for &Compare {
    type Output = Tally;
    fn run<P: Packet>(self, p: P) -> Tally {
        let mut tally = Tally::default();
        self.all(p, &mut tally);
        tally
    }
}

fn cameras() -> Vec<Camera> {
    let at = DVec3::new(0.1, -0.05, 0.02);
    let mut cameras = Vec::new();
    for (distance, angle) in [(0.2, 100.0), (3.0, 40.0), (1e3, 0.15), (1e6, 1.5e-4)] {
        let from = at + distance * DVec3::new(0.48, 0.6, 0.64);
        cameras.push(Camera::perspective(from, at, DVec3::Y, angle).unwrap());
        cameras.push(Camera::orthographic(from, at, DVec3::Z, 2.2).unwrap());
    }
    cameras
}

#[test]
fn beams_enclose_their_rays() {
    for isa in Isa::available() {
        for camera in cameras() {
            let frame = camera.frame(PICTURE, &DOMAIN).expect("the box is in view");
            let tally = isa.run(&Compare { camera, frame });
            assert!(tally.compared > 1000);
            assert_eq!(tally.outside, 0, "{isa}, {camera:?}");
        }
    }
}

/// The negative control: rays are not where a frame without slack says, because their numbers were rounded.
#[test]
fn without_slack_some_rays_escape() {
    for isa in Isa::available() {
        let mut outside = 0;
        for camera in cameras() {
            let mut frame = camera.frame(PICTURE, &DOMAIN).expect("the box is in view");
            (frame.slack, frame.tilt) = (0.0, 0.0);
            outside += isa.run(&Compare { camera, frame }).outside;
        }
        println!("{isa}: {outside} values outside");
        assert!(outside > 20, "{isa}: {outside}");
    }
}

#[test]
fn a_beam_that_misses_the_box_has_no_span() {
    struct Spans(Frame);
    impl Kernel for Spans {
        type Output = [[f64; 8]; 2];
        fn run<P: Packet>(self, p: P) -> [[f64; 8]; 2] {
            let grid = Grid {
                columns: 4,
                part: [8, 8],
                whole: true,
            };
            let group = Group::new(p, &self.0, [-16.0, 8.0], &grid);
            let span = group.span(p, &DOMAIN);
            let away = Group::new(p, &self.0, [700.0, 8.0], &grid).span(p, &DOMAIN);
            let span = select(p, p.le(span.lo, span.hi), &span, &away);
            [
                p.to_array(p.sub_rn(span.hi, span.lo)),
                p.to_array(p.sub_rn(away.hi, away.lo)),
            ]
        }
    }
    let camera = cameras()[2];
    let frame = camera.frame(PICTURE, &DOMAIN).expect("the box is in view");
    for isa in Isa::available() {
        let [inside, away] = isa.run(Spans(frame));
        assert!(inside.iter().all(|&length| length > 0.5), "{inside:?}");
        assert!(away.iter().all(|&length| length < 0.0), "{away:?}");
    }
}
