//! The shapes: each formula three times, as a scene, as fidget's tree, and by hand in plain `f64`, for the truth.
//!
//! All are solids f < 0 inside of the cube [−1, 1]³, since fidget renders solids.

use crate::models::{Model, Model1, Model2, Shared};
use fidget::context::Tree;
use zeroset::contract::{Auto, Contractor};
use zeroset::{Scene, Surface, implicit};

/// A shape in every form.
pub struct Shape {
    pub name: String,
    pub scene: Scene,
    /// The scene for back-ends without rounding.
    #[cfg(feature = "unrounded")]
    pub unrounded: Scene,
    pub tree: Tree,
    /// f by hand.
    pub at: Box<dyn Fn([f64; 3]) -> f64 + Sync>,
    /// For POV-Ray, where the shape is compared with it.
    pub isosurface: Option<Isosurface>,
    #[cfg(feature = "limit")]
    pub limit: crate::limit::Maker,
}

/// What POV-Ray is told about a shape.
pub struct Isosurface {
    /// f in its language.
    pub formula: String,
    /// The bound of |∇f| that its user has to guess.
    pub gradient: f64,
    /// A ball that contains the surface, in place of the cube.
    pub ball: Option<f64>,
}

implicit! { #[derive(Clone)] struct Sphere; x^2 + y^2 + z^2 = 0.64 }

implicit! { #[derive(Clone)] struct Torus; (sqrt(x^2 + y^2) - 0.6)^2 + z^2 = 0.0625 }

implicit! { #[derive(Clone)] struct Quartic; (x^2 + y^2 + z^2 + 0.2975)^2 = 1.44*(x^2 + y^2) }

implicit! {
    #[derive(Clone)]
    struct Barth;
    let phi = (1 + sqrt(5)) / 2;
    let p = 1.9*x;
    let q = 1.9*y;
    let r = 1.9*z;
    let g = 4*(phi^2*p^2 - q^2)*(phi^2*q^2 - r^2)*(phi^2*r^2 - p^2) - (1 + 2*phi)*(p^2 + q^2 + r^2 - 1)^2;
    max(-g, x^2 + y^2 + z^2 - 0.9025) = 0
}

implicit! {
    #[derive(Clone)]
    struct Gyroid;
    let g = sin(10*x)*cos(10*y) + sin(10*y)*cos(10*z) + sin(10*z)*cos(10*x);
    max(g, x^2 + y^2 + z^2 - 0.81) = 0
}

implicit! {
    #[derive(Clone)]
    struct ThinGyroid;
    let g = sin(10*x)*cos(10*y) + sin(10*y)*cos(10*z) + sin(10*z)*cos(10*x);
    max(abs(g) - 0.2, x^2 + y^2 + z^2 - 0.81) = 0
}

implicit! {
    #[derive(Clone)]
    struct Exponentials { rows: [[f64; 9]] }
    0.5 = sum([cx, cy, cz, a, b, c, d, e, f] in rows) {
        exp(-((a*(x - cx) + b*(y - cy) + c*(z - cz))^2 + (d*(y - cy) + e*(z - cz))^2 + (f*(z - cz))^2))
    }
}

implicit! {
    #[derive(Clone)]
    struct Spheres { rows: [[f64; 4]] }
    min([cx, cy, cz, r] in rows) { (x - cx)^2 + (y - cy)^2 + (z - cz)^2 - r^2 }
}

implicit! {
    #[derive(Clone)]
    struct Shell { thickness: f64 }
    max(x^2 + y^2 + z^2 - 0.64, (0.8 - thickness)^2 - (x^2 + y^2 + z^2)) = 0
}

/// All shapes.
pub fn all() -> Vec<Shape> {
    vec![
        sphere(),
        torus(),
        quartic(),
        barth(),
        gyroid(),
        thin_gyroid(),
        exponentials(rows("expsum8")),
        exponentials(rows("expsum64")),
        spheres(rows("spheres64")),
        shell(1e-3),
        model::<Model1>("121 operations"),
        model::<Model2>("498 operations"),
        model::<crate::models::Temple>("temple, 478 operations"),
        #[cfg(feature = "large")]
        model::<crate::models::Model3>("841 operations"),
    ]
}

/// The rows of a table of the data.
pub fn rows<const N: usize>(table: &str) -> Vec<[f64; N]> {
    let text = include_str!("../data/shapes.txt");
    let lines = text
        .lines()
        .skip_while(|l| *l != format!("[{table}]"))
        .skip(1);
    let rows: Vec<[f64; N]> = lines
        .take_while(|l| !l.starts_with('['))
        .filter(|l| !l.is_empty())
        .map(|line| {
            let numbers: Vec<f64> = line
                .split(' ')
                .map(|n| n.parse().expect("a number"))
                .collect();
            numbers.try_into().expect("a row of the right length")
        })
        .collect();
    assert!(!rows.is_empty(), "no table `{table}`");
    rows
}

/// Where all shapes are.
pub const CUBE: [[f64; 3]; 2] = [[-1.0; 3], [1.0; 3]];

fn within<C: Contractor, S: Surface + 'static>(surface: S) -> Scene {
    Scene::new()
        .with_solver::<C, _>(surface)
        .within(CUBE[0], CUBE[1])
}

fn shape<S: Surface + Clone + 'static>(
    name: &str,
    surface: S,
    tree: Tree,
    at: impl Fn([f64; 3]) -> f64 + Sync + 'static,
) -> Shape {
    Shape {
        name: name.to_owned(),
        #[cfg(feature = "limit")]
        limit: crate::limit::maker(surface.clone()),
        #[cfg(feature = "unrounded")]
        unrounded: within::<zeroset::contract::unsound::Unrounded, S>(surface.clone()),
        scene: within::<Auto, S>(surface),
        tree,
        at: Box::new(at),
        isosurface: None,
    }
}

impl Shape {
    fn with_isosurface(
        mut self,
        formula: impl Into<String>,
        gradient: f64,
        ball: Option<f64>,
    ) -> Self {
        let formula = formula.into();
        self.isosurface = Some(Isosurface {
            formula,
            gradient,
            ball,
        });
        self
    }
}

/// x² + y² + z² − c.
fn ball(c: f32) -> Tree {
    let (x, y, z) = Tree::axes();
    x.square() + y.square() + z.square() - c
}

fn norm2(p: [f64; 3]) -> f64 {
    p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
}

fn sphere() -> Shape {
    shape("sphere", Sphere, ball(0.64), |p| norm2(p) - 0.64).with_isosurface(
        "x*x + y*y + z*z - 0.64",
        4.0,
        None,
    )
}

fn torus() -> Shape {
    let (x, y, z) = Tree::axes();
    let tree = ((x.square() + y.square()).sqrt() - 0.6).square() + z.square() - 0.0625;
    shape("torus", Torus, tree, |[x, y, z]| {
        let ring = (x * x + y * y).sqrt() - 0.6;
        ring * ring + z * z - 0.0625
    })
    .with_isosurface("pow(sqrt(x*x + y*y) - 0.6, 2) + z*z - 0.0625", 3.0, None)
}

fn quartic() -> Shape {
    let (x, y, _) = Tree::axes();
    let tree = ball(-0.2975).square() - 1.44 * (x.square() + y.square());
    shape("torus, quartic", Quartic, tree, |[x, y, z]| {
        let s = norm2([x, y, z]) + 0.2975;
        s * s - 1.44 * (x * x + y * y)
    })
}

fn barth() -> Shape {
    let phi = 0.5 * (1.0 + 5f64.sqrt());
    let (x, y, z) = Tree::axes();
    let [p, q, r] = [x, y, z].map(|t| (1.9 * t).square());
    let k = (phi * phi) as f32;
    let product = 4.0
        * (k * p.clone() - q.clone())
        * (k * q.clone() - r.clone())
        * (k * r.clone() - p.clone());
    let g = product - (1.0 + 2.0 * phi) as f32 * (p + q + r - 1.0).square();
    shape("Barth sextic", Barth, g.neg().max(ball(0.9025)), move |v| {
        let [p, q, r] = v.map(|t| 1.9 * t * 1.9 * t);
        let k = phi * phi;
        let s = p + q + r - 1.0;
        let g = 4.0 * (k * p - q) * (k * q - r) * (k * r - p) - (1.0 + 2.0 * phi) * s * s;
        (-g).max(norm2(v) - 0.9025)
    })
    .with_isosurface(
        format!(
            "{c}*pow({u}*(x*x + y*y + z*z) - 1, 2) - 4*({k}*x*x - y*y)*({k}*y*y - z*z)*({k}*z*z - x*x)*pow({u}, 3)",
            c = 1.0 + 2.0 * phi,
            k = phi * phi,
            u = 3.61
        ),
        300.0,
        Some(0.95),
    )
}

fn waves() -> Tree {
    let (x, y, z) = Tree::axes();
    let [x, y, z] = [x, y, z].map(|t| 10.0 * t);
    x.sin() * y.cos() + y.sin() * z.cos() + z.sin() * x.cos()
}

fn waves_at(p: [f64; 3]) -> f64 {
    let [(sx, cx), (sy, cy), (sz, cz)] = p.map(|t| (10.0 * t).sin_cos());
    sx * cy + sy * cz + sz * cx
}

fn gyroid() -> Shape {
    shape("gyroid", Gyroid, waves().max(ball(0.81)), |p| {
        waves_at(p).max(norm2(p) - 0.81)
    })
}

fn thin_gyroid() -> Shape {
    let tree = (waves().abs() - 0.2).max(ball(0.81));
    shape("gyroid, thin", ThinGyroid, tree, |p| {
        (waves_at(p).abs() - 0.2).max(norm2(p) - 0.81)
    })
}

pub fn shell(thickness: f64) -> Shape {
    let inner = (0.8 - thickness) * (0.8 - thickness);
    let tree = ball(0.64).max(ball(inner as f32).neg());
    let name = format!("shell, {thickness} thick");
    shape(&name, Shell { thickness }, tree, move |p| {
        (norm2(p) - 0.64).max(inner - norm2(p))
    })
}

/// A constructive model.
fn model<M: Model>(name: &str) -> Shape {
    let (x, y, z) = Tree::axes();
    let axes = [x, y, z].map(Shared::new);
    shape(name, M::default(), M::tree(axes).tree(), M::by_hand)
}

/// The union of balls.
pub fn spheres(rows: Vec<[f64; 4]>) -> Shape {
    let (x, y, z) = Tree::axes();
    let balls = rows.iter().map(|&row| {
        let [a, b, c, r] = row.map(|v| v as f32);
        (x.clone() - a).square() + (y.clone() - b).square() + (z.clone() - c).square() - r * r
    });
    let tree = halves(balls.collect(), &|a, b| a.min(b));
    let name = format!("{} spheres", rows.len());
    let table = rows.clone();
    shape(&name, Spheres { rows }, tree, move |[x, y, z]| {
        table.iter().fold(f64::INFINITY, |least, [a, b, c, r]| {
            least.min(norm2([x - a, y - b, z - c]) - r * r)
        })
    })
}

/// A sum of exponentials of quadrics, given by their centres and triangular factors.
pub fn exponentials(rows: Vec<[f64; 9]>) -> Shape {
    let (x, y, z) = Tree::axes();
    let terms = rows.iter().map(|&row| {
        let [cx, cy, cz, a, b, c, d, e, f] = row.map(|v| v as f32);
        let (x, y, z) = (x.clone() - cx, y.clone() - cy, z.clone() - cz);
        let u = a * x + b * y.clone() + c * z.clone();
        let v = d * y + e * z.clone();
        (u.square() + v.square() + (f * z).square()).neg().exp()
    });
    let tree = 0.5 - halves(terms.collect(), &|a, b| a + b);
    let name = format!("{} exponentials", rows.len());
    let formula = rows.iter().fold("0.5".to_owned(), |sum, [cx, cy, cz, a, b, c, d, e, f]| {
        let [x, y, z] = [("x", cx), ("y", cy), ("z", cz)].map(|(n, c)| format!("({n} - ({c}))"));
        format!(
            "{sum} - exp(-(pow(({a})*{x} + ({b})*{y} + ({c})*{z}, 2) + pow(({d})*{y} + ({e})*{z}, 2) + pow(({f})*{z}, 2)))"
        )
    });
    let few = rows.len() <= 8;
    let table = rows.clone();
    let shape = shape(&name, Exponentials { rows }, tree, move |p| {
        let term = |[cx, cy, cz, a, b, c, d, e, f]: &[f64; 9]| {
            let [x, y, z] = [p[0] - cx, p[1] - cy, p[2] - cz];
            let q = [a * x + b * y + c * z, d * y + e * z, f * z];
            (-norm2(q)).exp()
        };
        0.5 - table.iter().map(term).sum::<f64>()
    });
    if few {
        shape.with_isosurface(formula, 10.0, None)
    } else {
        shape
    }
}

/// Joins trees in pairs: a chain as long as the list would be as deep.
fn halves(mut trees: Vec<Tree>, join: &dyn Fn(Tree, Tree) -> Tree) -> Tree {
    while trees.len() > 1 {
        let mut pairs = trees.into_iter();
        trees = std::iter::from_fn(|| {
            let first = pairs.next()?;
            Some(match pairs.next() {
                Some(second) => join(first, second),
                None => first,
            })
        })
        .collect();
    }
    trees.pop().unwrap_or_else(|| Tree::constant(0.0))
}
