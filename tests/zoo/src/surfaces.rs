//! The surfaces. Irrational coefficients are fields, so that both sides use the same `f64`s.

// Each is described by its formula; their names are those of the literature.
#![allow(missing_docs)]

use super::implicit;

implicit! { #[derive(Clone)] pub struct Sphere; x^2 + y^2 + z^2 = 0.64 }
implicit! { #[derive(Clone)] pub struct Ellipsoid; x^2 + 2*y^2 + 3*z^2 + x*y = 1 }
implicit! { #[derive(Clone)] pub struct Cylinder; x^2 + y^2 = 0.25 }
implicit! { #[derive(Clone)] pub struct Cone; x^2 + y^2 = z^2 }
implicit! { #[derive(Clone)] pub struct Hyperboloid; x^2 + y^2 - z^2 = 0.25 }
implicit! { #[derive(Clone)] pub struct Torus;
(x^2 + y^2 + z^2 + 0.36 - 0.0625)^2 = 4*0.36*(x^2 + y^2) }
implicit! { #[derive(Clone)] pub struct TorusRoot; (sqrt(x^2 + y^2) - 0.6)^2 + z^2 = 0.0625 }
implicit! { #[derive(Clone)] pub struct Cayley; 4*(x^2 + y^2 + z^2) + 16*x*y*z = 1 }
implicit! { #[derive(Clone)] pub struct Clebsch;
81*(x^3 + y^3 + z^3) - 189*(x^2*(y + z) + y^2*(x + z) + z^2*(x + y)) + 54*x*y*z + 126*(x*y + x*z + y*z)
    - 9*(x^2 + y^2 + z^2) - 9*(x + y + z) + 1 }
implicit! { #[derive(Clone)] pub struct Kummer { pub root: f64 = 1.4142135623730951 }
let m = 1.69;
let factor = (3*m - 1) / (3 - m);
(x^2 + y^2 + z^2 - m)^2
    - factor*(1 - z - root*x)*(1 - z + root*x)*(1 + z + root*y)*(1 + z - root*y) }
implicit! { #[derive(Clone)] pub struct Tangle; x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8 }
implicit! { #[derive(Clone)] pub struct Mitchell;
let q = y^2 + z^2;
4*(x^4 + q^2 + 17*x^2*q) - 20*(x^2 + q) + 17 }
implicit! { #[derive(Clone)] pub struct Steiner; x^2*y^2 + y^2*z^2 + z^2*x^2 + x*y*z }
implicit! { #[derive(Clone)] pub struct Klein;
let r = x^2 + y^2 + z^2;
let inner = r - 2*y - 1;
(r + 2*y - 1)*(inner^2 - 8*z^2) + 16*x*z*inner }
implicit! { #[derive(Clone)] pub struct Heart;
(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3 }
implicit! { #[derive(Clone)] pub struct Teardrop; 0.5*x^5 + 0.5*x^4 - y^2 - z^2 }
implicit! { #[derive(Clone)] pub struct BarthSextic { pub phi: f64 = 1.618033988749895 }
4*(phi^2*x^2 - y^2)*(phi^2*y^2 - z^2)*(phi^2*z^2 - x^2) = (1 + 2*phi)*(x^2 + y^2 + z^2 - 1)^2 }
implicit! { #[derive(Clone)] pub struct BarthDecic { pub phi: f64 = 1.618033988749895 }
let r = x^2 + y^2 + z^2;
8*(x^2 - phi^4*y^2)*(y^2 - phi^4*z^2)*(z^2 - phi^4*x^2)
    *(x^4 + y^4 + z^4 - 2*(x^2*y^2 + y^2*z^2 + z^2*x^2))
    + (3 + 5*phi)*(r - 1)^2*(r - (2 - phi))^2 }
implicit! { #[derive(Clone)] pub struct Chmutov6;
32*x^6 - 48*x^4 + 18*x^2 + 32*y^6 - 48*y^4 + 18*y^2 + 32*z^6 - 48*z^4 + 18*z^2 - 2 }
implicit! { #[derive(Clone)] pub struct Chmutov8;
128*x^8 - 256*x^6 + 160*x^4 - 32*x^2 + 128*y^8 - 256*y^6 + 160*y^4 - 32*y^2
    + 128*z^8 - 256*z^6 + 160*z^4 - 32*z^2 + 4 }
implicit! { #[derive(Clone)] pub struct Bretzel;
(x^2*(1 - x^2)^2*(4 - x^2)^3 - 20*y^2)^2 + 80*z^2 - 22 }
implicit! { #[derive(Clone)] pub struct Decocube;
((x^2 + y^2 - 0.64)^2 + (z^2 - 1)^2)*((y^2 + z^2 - 0.64)^2 + (x^2 - 1)^2)
    *((z^2 + x^2 - 0.64)^2 + (y^2 - 1)^2) - 0.02 }
implicit! { #[derive(Clone)] pub struct Icosahedral { pub phi: f64 = 1.618033988749895 }
2 - (cos(x + phi*y) + cos(x - phi*y) + cos(y + phi*z) + cos(y - phi*z) + cos(z + phi*x) + cos(z - phi*x)) }
implicit! { #[derive(Clone)] pub struct Superquadric; abs(x)^500 + 0.5*abs(y)^35 + 0.5*z^4 = 1 }
implicit! { #[derive(Clone)] pub struct Gyroid; sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) }
implicit! { #[derive(Clone)] pub struct SchwarzP; cos(x) + cos(y) + cos(z) }
implicit! { #[derive(Clone)] pub struct SchwarzD;
sin(x)*sin(y)*sin(z) + sin(x)*cos(y)*cos(z) + cos(x)*sin(y)*cos(z) + cos(x)*cos(y)*sin(z) }
implicit! { #[derive(Clone)] pub struct Blobby; x^2 + y^2 + z^2 + sin(4*x) - cos(4*y) + sin(4*z) - 1 }
implicit! { #[derive(Clone)] pub struct Scherk; exp(z)*cos(y) - cos(x) }
implicit! { #[derive(Clone)] pub struct Exponentials { pub blobs: [[f64; 4]; 6] }
0.5 = sum([a, b, c, s] in blobs) { exp(-s*((x - a)^2 + (y - b)^2 + (z - c)^2)) } }
implicit! { #[derive(Clone)] pub struct Zitrus; x^2 + z^2 - y^3*(1 - y)^3 }
implicit! { #[derive(Clone)] pub struct DingDong; x^2 + y^2 + z^3 - z^2 }
implicit! { #[derive(Clone)] pub struct Calypso; x^2 + y^2*z - z^2 }
implicit! { #[derive(Clone)] pub struct Whitney; x^2 - y^2*z }
implicit! { #[derive(Clone)] pub struct Himmel; x^2 - y^2*z^2 }
implicit! { #[derive(Clone)] pub struct Limao; x^2 - y^3*z^3 }
implicit! { #[derive(Clone)] pub struct DoubledSphere; (x^2 + y^2 + z^2 - 0.64)^2 }
implicit! { #[derive(Clone)] pub struct IsolatedPoint; x^2 + y^2 + z^2 }
implicit! { #[derive(Clone)] pub struct ThinShell { pub thickness: f64 = 2^-40 }
let r = x^2 + y^2 + z^2;
max(r - 0.64, (0.8 - thickness)^2 - r) }

/// Centres and sharpness.
pub const BLOBS: [[f64; 4]; 6] = [
    [0.25, 0.125, -0.375, 6.0],
    [-0.5, 0.25, 0.125, 9.0],
    [0.125, -0.5, 0.25, 7.5],
    [-0.125, 0.375, 0.5, 11.0],
    [0.5, -0.25, -0.125, 8.0],
    [-0.375, -0.375, -0.25, 12.5],
];
