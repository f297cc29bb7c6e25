//! Which regions of a surface's code matter: the code that one side of a choice needs, or each of several sides.

use super::Choice;

/// The regions of a formula's code, and the choices inside of them: two for each choice, one for either side, and behind them
/// those that several sides share.
#[derive(Clone, Copy, Debug)]
pub struct Regions {
    /// How many there are.
    pub count: usize,
    /// The choices that stand in no region.
    pub outermost: &'static [u32],
    /// Those of one side.
    pub of_sides: &'static [Region],
}

/// A region of one side.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    /// Those of several sides, of which it is one: words of bits, and which bits.
    pub parts_of: &'static [(u32, u32)],
    /// The choices that stand in it, or in one of these.
    pub choices: &'static [u32],
}

impl Regions {
    /// There are no choices.
    pub const NONE: Regions = Regions {
        count: 0,
        outermost: &[],
        of_sides: &[],
    };

    /// All of them, bit by bit.
    pub(super) fn all(&self) -> Vec<u32> {
        vec![u32::MAX; self.words()]
    }

    fn words(&self) -> usize {
        self.count.div_ceil(32)
    }

    /// Those that are alive. A side is if its choice may fall on it and stands where code is alive.
    pub(super) fn find(&self, choices: &[Choice], alive: &mut Vec<u32>) {
        alive.clear();
        alive.resize(self.words(), 0);
        self.choose(self.outermost, choices, alive);
    }

    fn choose(&self, among: &[u32], choices: &[Choice], alive: &mut [u32]) {
        for &number in among {
            let first = 2 * number as usize;
            if alive[first / 32] >> (first % 32) & 0b11 != 0 {
                // It was met before, in a region of several sides.
                continue;
            }
            let choice = choices[number as usize];
            if choice.first() {
                self.enter(first, choices, alive);
            }
            if choice.second() {
                self.enter(first + 1, choices, alive);
            }
        }
    }

    fn enter(&self, side: usize, choices: &[Choice], alive: &mut [u32]) {
        alive[side / 32] |= 1 << (side % 32);
        let region = &self.of_sides[side];
        for &(word, bits) in region.parts_of {
            alive[word as usize] |= bits;
        }
        self.choose(region.choices, choices, alive);
    }
}
