/// Numbers in [−1, 1), always the same from the same seed.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    pub fn point(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| size * self.next())
    }
}
