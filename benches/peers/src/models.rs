//! Constructive models: one text each, compiled as a surface, as fidget's tree, and in plain `f64`.

use std::ops::{Add, Mul, Neg, Sub};

use fidget::context::Tree;
use zeroset::implicit;

/// What a model's text computes with.
trait Number: Copy {
    fn min(self, b: Self) -> Self;
    fn max(self, b: Self) -> Self;
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
}

impl Number for f64 {
    fn min(self, b: f64) -> f64 {
        f64::min(self, b)
    }
    fn max(self, b: f64) -> f64 {
        f64::max(self, b)
    }
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
}

/// A tree that may be used more than once. It is never freed: there are few.
#[derive(Clone, Copy)]
pub struct Shared(&'static Tree);

impl Shared {
    pub fn new(tree: Tree) -> Shared {
        Shared(Box::leak(Box::new(tree)))
    }

    pub fn tree(self) -> Tree {
        self.0.clone()
    }
}

impl From<f64> for Shared {
    fn from(c: f64) -> Shared {
        Shared::new(Tree::constant(c as f32))
    }
}

impl Number for Shared {
    fn min(self, b: Shared) -> Shared {
        Shared::new(self.tree().min(b.tree()))
    }
    fn max(self, b: Shared) -> Shared {
        Shared::new(self.tree().max(b.tree()))
    }
    fn abs(self) -> Shared {
        Shared::new(self.tree().abs())
    }
    fn sqrt(self) -> Shared {
        Shared::new(self.tree().sqrt())
    }
}

impl Neg for Shared {
    type Output = Shared;
    fn neg(self) -> Shared {
        Shared::new(self.tree().neg())
    }
}

macro_rules! operator {
    ($($trait:ident $name:ident $op:tt;)*) => {$(
        impl $trait for Shared {
            type Output = Shared;
            fn $name(self, b: Shared) -> Shared {
                Shared::new(self.tree() $op b.tree())
            }
        }
        impl $trait<f64> for Shared {
            type Output = Shared;
            fn $name(self, b: f64) -> Shared {
                self $op Shared::from(b)
            }
        }
        impl $trait<Shared> for f64 {
            type Output = Shared;
            fn $name(self, b: Shared) -> Shared {
                Shared::from(self) $op b
            }
        }
    )*};
}

operator! { Add add +; Sub sub -; Mul mul *; }

fn min<N: Number>(a: N, b: N) -> N {
    a.min(b)
}

fn max<N: Number>(a: N, b: impl Into<N>) -> N {
    a.max(b.into())
}

fn abs<N: Number>(a: N) -> N {
    a.abs()
}

fn sqrt<N: Number>(a: N) -> N {
    a.sqrt()
}

/// A model in all forms.
pub trait Model: zeroset::Surface + Clone + Default + 'static {
    fn by_hand(p: [f64; 3]) -> f64;
    fn tree(axes: [Shared; 3]) -> Shared;
}

macro_rules! model {
    ($name:ident($x:ident, $y:ident, $z:ident) $($body:tt)*) => {
        implicit! { #[derive(Clone, Default)] pub struct $name; $($body)* }

        impl Model for $name {
            fn by_hand([$x, $y, $z]: [f64; 3]) -> f64 {
                $($body)*
            }
            fn tree([$x, $y, $z]: [Shared; 3]) -> Shared {
                $($body)*
            }
        }
    };
}

include!("../data/models.rs");
