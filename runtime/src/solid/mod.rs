//! Solids: intersections, unions, differences and complements of surfaces, by the certain roots of each.
//!
//! A point is inside a surface where f < 0. `a & b` is inside both, `a | b` inside one at least, `a - b` inside a and not
//! b, and `!a` is the complement; they nest at will. A [`Solid`] goes into a [`Scene`] like a surface.
//!
//! ```
//! use zeroset::glam::{DAffine3, DVec3, Vec3, dvec3};
//! use zeroset::{Camera, Operand, Options, Scene, Shading, implicit, render};
//!
//! implicit! { struct Ball { radius: f64 = 1 } x^2 + y^2 + z^2 = radius^2 }
//! implicit! { struct Tube; x^2 + y^2 = 0.16 }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let lying = DAffine3::from_rotation_x(1.57);
//! let drilled = (Ball::default() - Tube - Tube.placed(lying).coloured(Vec3::new(0.8, 0.1, 0.1)))
//!     & Ball::default().placed(DAffine3::from_translation(dvec3(0.4, 0.3, 0.0)));
//! let scene = Scene::new().with(drilled).within([-1.5; 3], [1.5; 3]);
//! let camera = Camera::perspective(dvec3(3.0, 2.0, 1.0), DVec3::ZERO, DVec3::Z, 40.0)?;
//! let picture = render(&scene, &camera, &Options::new(64, 64))?;
//! assert_eq!(picture.statistics().unresolved, 0);
//! # Ok(())
//! # }
//! ```
//!
//! # What is proved
//!
//! The solid's f is that of the formula with `max(a, b)` for `a & b`, `min(a, b)` for `a | b` and `-a` for `!a`, and the
//! [verdicts](crate::verdict) speak of it. Each operand is traced for itself, wherever it can matter. Between
//! its events it has no root, and one certain sign, found by an enclosure, tells on which side the ray is; the number of
//! roots is never counted. Where the side of each operand that matters is certain, so is that of the solid. A root of one
//! operand, where all others are on certain sides, is one of the solid or none. Where events of several operands overlap,
//! the order of their roots is open: if every order gives the solid one root, it is a `Root`; if the solid is on different
//! sides before and behind, a `Crossing`; else `Unresolved`, because of [`Why::Order`](crate::verdict::Why::Order).
//!
//! A point where f of an operand is not defined is on no side of it: if that matters, the ray is
//! `Unresolved` there.
//!
//! A surface's `#[domain]` says where it is searched, not where it ends. A solid is searched in a box of its own:
//! intersections in the common part of the operands' boxes, unions in the box around them, `a - b` in that of a, all
//! within the scene's box if an operand has none.

mod cells;
mod leaf;
mod over;
mod placed;
mod sweep;
mod tile;
mod trace;
mod tree;
mod volume;

pub(crate) use tree::Side;
pub use volume::Volume;

use std::ops::{BitAnd, BitOr, Not, Sub};

use glam::{DAffine3, Vec3};

use crate::scene::Scene;
use crate::surface::Surface;
use leaf::Leaf;
use placed::Placed;
use tree::Node;

/// A set of points, put together from surfaces by `&`, `|`, `-` and `!`. See the [module](self).
pub struct Solid {
    node: Node,
    parts: Vec<Part>,
}

/// An operand and its material.
struct Part {
    leaf: Box<dyn Leaf>,
    colour: Option<Vec3>,
}

/// What a solid is made of: a surface, or a solid.
pub trait Operand: Sized {
    /// The points where f < 0, as a solid.
    fn into_solid(self) -> Solid;

    /// Its image under an affine map: of a rotation, a translation, a scaling, or of several in turn. A ray's t stays what
    /// it is, and the inverse is enclosed, so that verdicts speak of the image under exactly this map.
    ///
    /// A map that is not finite, or that may have no inverse, is an error of the scene.
    #[must_use]
    fn placed(self, map: DAffine3) -> Solid {
        let mut solid = self.into_solid();
        for part in &mut solid.parts {
            part.leaf.place(map);
        }
        solid
    }

    /// The same in this colour (linear RGB from 0 to 1), as far as it has none yet. Colours that are not given are those of
    /// [`Shading`](crate::Shading).
    #[must_use]
    fn coloured(self, colour: Vec3) -> Solid {
        let mut solid = self.into_solid();
        for part in &mut solid.parts {
            part.colour.get_or_insert(colour);
        }
        solid
    }

    /// Adds it to a scene.
    #[doc(hidden)]
    fn add_to(self, scene: Scene) -> Scene {
        scene.add(Box::new(self.into_solid()))
    }
}

impl<S: Surface + 'static> Operand for S {
    fn into_solid(self) -> Solid {
        Solid {
            node: Node::Leaf(0),
            parts: vec![Part {
                leaf: Box::new(Placed::new(self)),
                colour: None,
            }],
        }
    }

    /// A surface alone is traced as such.
    fn add_to(self, scene: Scene) -> Scene {
        scene.with_solver::<crate::contract::Auto, S>(self)
    }
}

impl Operand for Solid {
    fn into_solid(self) -> Solid {
        self
    }
}

impl Solid {
    /// The points of both.
    pub fn and(a: impl Operand, b: impl Operand) -> Solid {
        Solid::joined(a.into_solid(), b.into_solid(), Node::and)
    }

    /// The points of either.
    pub fn or(a: impl Operand, b: impl Operand) -> Solid {
        Solid::joined(a.into_solid(), b.into_solid(), Node::or)
    }

    /// The points of `a` that are none of `b`.
    pub fn without(a: impl Operand, b: impl Operand) -> Solid {
        Solid::and(a, Solid::complement(b))
    }

    /// All points that are none of `a`.
    pub fn complement(a: impl Operand) -> Solid {
        let Solid { node, parts } = a.into_solid();
        Solid {
            node: node.negated(),
            parts,
        }
    }

    fn joined(a: Solid, b: Solid, join: fn(Node, Node) -> Node) -> Solid {
        let (mut parts, mut other) = (a.parts, b.node);
        other.shift(parts.len());
        parts.extend(b.parts);
        Solid {
            node: join(a.node, other),
            parts,
        }
    }

    /// The names of its operands; in a picture they are surfaces, numbered in this order.
    pub fn operands(&self) -> impl Iterator<Item = &'static str> {
        self.parts.iter().map(|part| part.leaf.name())
    }
}

/// The operators, for solids on the left. Those for surfaces on the left are generated, because Rust refuses one
/// implementation for all of them.
macro_rules! operators {
    ($($operator:ident $method:ident => $function:ident;)*) => {
        $(impl<R: Operand> $operator<R> for Solid {
            type Output = Solid;
            fn $method(self, other: R) -> Solid {
                Solid::$function(self, other)
            }
        })*
    };
}

operators! {
    BitAnd bitand => and;
    BitOr bitor => or;
    Sub sub => without;
}

impl Not for Solid {
    type Output = Solid;
    fn not(self) -> Solid {
        Solid::complement(self)
    }
}

impl std::fmt::Debug for Solid {
    /// The tree, by the operands' numbers, and their names.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let names: Vec<_> = self.operands().collect();
        f.debug_struct("Solid")
            .field("node", &self.node)
            .field("operands", &names)
            .finish()
    }
}
