//! Generated code is not disturbed by the names around it, nor by those of fields.

#![forbid(unsafe_code)]
#![allow(dead_code, unused_macros)]

use ::zeroset as surfaces;

mod std {}
mod core {}
mod zeroset {}
struct Vec;
struct Option;
struct Some;
struct None;
struct Result;
struct Ok;
struct Err;
struct Default;
struct Clone;
struct Copy;
struct String;
struct Box;
struct Surface;
struct Packet;
struct Interval;
fn sqrt() {}
fn drop() {}
macro_rules! vec { () => {} }
macro_rules! format { () => {} }

surfaces::implicit! {
    pub struct Hostile {
        pub value: f64 = 1,
        pub slope: f64 = 2,
        pub curvature: f64 = 3,
        pub point: f64 = 4,
        pub rays: f64 = 5,
        pub prepared: f64 = 6,
        pub bound: f64 = 7,
        pub segment: f64 = 8,
        pub active: f64 = 9,
        pub p: f64 = 10,
        pub t: [f64; 2] = [11, 12],
        pub i: f64 = 13,
        pub r#type: f64 = 14,
        pub rows: [[f64; 2]] = [[15, 16]],
        pub check: f64 = 17,
        pub f: f64 = 18,
        pub e: f64 = 19,
        pub out: f64 = 20,
    }
    let v0 = x*value + slope + curvature + point;
    let v1 = rays + prepared + bound + segment + active + p*y;
    let domain = t[0] + t[1] + i + r#type + check + f + e + out;
    v0 + v1 + domain + sum([a, b] in rows) { a*b*z } + sum(self_ in 0..2) { self_*x }
}

fn main() {
    use surfaces::surface::Surface as _;
    let surface = Hostile::default().with_point(5.0).with_type(0.0);
    assert_eq!(surface.at([1.0, 0.0, 0.0]), 1.0 + 2.0 + 3.0 + 5.0 + 35.0 + 110.0 + 1.0);
    let (prepared, f, point) = (1.0, 2.0, 3.0);
    let captured = surfaces::implicit!(x*prepared + f*y + point);
    assert_eq!(captured.at([1.0, 1.0, 0.0]), 6.0);
}
