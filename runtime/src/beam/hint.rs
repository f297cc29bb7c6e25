//! What beams tell about the rays in them.

/// Where a beam's rays are to be searched. Parameters count from the camera.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hint {
    /// May there be roots at all?
    pub open: bool,
    /// No ray has a root before this …
    pub front: f64,
    /// … and steps of about this length are promising.
    pub length: f64,
    /// Each ray has exactly one root there and none before, unless it leaves the box.
    pub single: Option<Single>,
}

/// A piece in which a ray has one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Single {
    pub t: [f64; 2],
    /// Bounds of the derivative along the rays there; 0 is outside.
    pub slope: [f64; 2],
    /// Is the piece inside the surface's box, so that each ray has its root?
    pub inside: bool,
    /// Where the roots may be, without any guarantee: this, plus this per pixel to the right, plus this per pixel up,
    /// counted from the middle of the picture.
    pub plane: [f64; 3],
}

impl Default for Hint {
    fn default() -> Self {
        Hint::OPEN
    }
}

impl Hint {
    /// Does every ray of the beam have a root inside the surface's box?
    pub fn is_full(&self) -> bool {
        self.single.is_some_and(|single| single.inside)
    }

    /// There is no root.
    pub const CLOSED: Hint = Hint {
        open: false,
        ..Hint::OPEN
    };

    /// Nothing is known.
    pub const OPEN: Hint = Hint {
        open: true,
        front: 0.0,
        length: f64::INFINITY,
        single: None,
    };
}
