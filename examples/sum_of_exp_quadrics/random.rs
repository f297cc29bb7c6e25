//! A small deterministic generator: the same seed gives the same picture on every machine.

/// Splitmix64 (Steele, Lea and Flood, 2014).
pub struct Random {
    state: u64,
}

impl Random {
    /// A stream of its own per seed.
    pub fn new(seed: u64) -> Self {
        Random { state: seed }
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = self.state;
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `n`; `n` is small, so the bias does not matter.
    pub fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// Uniform in [lo, hi), from 53 bits.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        lo + (hi - lo) * unit
    }

    /// Uniform in the ball of this radius around the origin, by rejection from its cube.
    pub fn in_ball(&mut self, radius: f64) -> [f64; 3] {
        loop {
            let p = [0; 3].map(|_| self.between(-1.0, 1.0));
            if p.iter().map(|x| x * x).sum::<f64>() <= 1.0 {
                return p.map(|x| x * radius);
            }
        }
    }

    /// A uniform rotation: the matrix of a unit quaternion that is uniform on the sphere in four dimensions.
    pub fn rotation(&mut self) -> [[f64; 3]; 3] {
        let [w, x, y, z] = loop {
            let q = [0; 4].map(|_| self.between(-1.0, 1.0));
            let square = q.iter().map(|x| x * x).sum::<f64>();
            if (0.01..=1.0).contains(&square) {
                break q.map(|x| x / square.sqrt());
            }
        };
        [
            [
                1.0 - 2.0 * (y * y + z * z),
                2.0 * (x * y - w * z),
                2.0 * (x * z + w * y),
            ],
            [
                2.0 * (x * y + w * z),
                1.0 - 2.0 * (x * x + z * z),
                2.0 * (y * z - w * x),
            ],
            [
                2.0 * (x * z - w * y),
                2.0 * (y * z + w * x),
                1.0 - 2.0 * (x * x + y * y),
            ],
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_splitmix64() {
        // The first outputs for seed 1234567 of the reference implementation by Vigna.
        let mut random = Random::new(1_234_567);
        assert_eq!(random.next(), 6_457_827_717_110_365_317);
        assert_eq!(random.next(), 3_203_168_211_198_807_973);
    }

    #[test]
    fn rotations_keep_lengths() {
        let mut random = Random::new(5);
        let r = random.rotation();
        for i in 0..3 {
            for j in 0..3 {
                let dot: f64 = (0..3).map(|k| r[i][k] * r[j][k]).sum();
                assert!((dot - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }
}
