//! What is kept of a finished packet.

/// The answers of eight rays. Lanes that show nothing hold leftovers of other packets.
#[derive(Clone, Copy, Default)]
pub(crate) struct Record {
    /// The parameter from which t counts.
    pub entry: [f64; 8],
    /// The interval that is shown: that of the nearest certain root, or of what comes before it.
    pub lo: [f64; 8],
    pub hi: [f64; 8],
    /// Unit normals towards the viewer, of the rays that show a surface; zero where the gradient is.
    pub normal: [[f32; 8]; 3],
    /// The surface that each ray shows, if it does.
    pub surface: [u16; 8],
    /// Rays that show a surface.
    pub shown: u8,
    /// Rays whose nearest root overlaps one of another surface.
    pub tied: u8,
    /// Rays whose answer is neither a miss nor a plain root, and is in a list.
    pub special: u8,
}

impl Record {
    /// Nothing is shown yet.
    #[inline(always)]
    pub fn forget(&mut self) {
        self.lo = [f64::INFINITY; 8];
        self.hi = [f64::INFINITY; 8];
        (self.shown, self.tied, self.special) = (0, 0, 0);
    }
}
