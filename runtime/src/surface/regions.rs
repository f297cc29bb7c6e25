//! Which regions of a surface's code matter: the code that one side of a choice needs, or each of several sides.

use super::Choice;

/// The regions of a formula's code, and the choices inside of them.
///
/// Two regions for each choice, one for either side, and behind them those that several sides share.
#[derive(Clone, Copy, Debug)]
pub struct Regions {
    /// The choices that stand in no region.
    pub outermost: &'static [u32],
    /// All regions.
    pub all: &'static [Region],
}

/// A region.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    /// The regions that are alive where this one is, and may be elsewhere.
    pub parts_of: &'static [u32],
    /// The choices that stand in it.
    pub choices: &'static [u32],
}

impl Regions {
    /// There are no choices.
    pub const NONE: Regions = Regions {
        outermost: &[],
        all: &[],
    };

    /// All of them, bit by bit.
    pub(super) fn all(&self) -> Vec<u64> {
        vec![u64::MAX; self.words()]
    }

    fn words(&self) -> usize {
        self.all.len().div_ceil(64)
    }

    /// Those that are alive. A side is if its choice may fall on it and stands where code is alive.
    pub(super) fn find(&self, choices: &[Choice], alive: &mut Vec<u64>) {
        alive.clear();
        alive.resize(self.words(), 0);
        self.choose(self.outermost, choices, alive);
    }

    fn choose(&self, among: &[u32], choices: &[Choice], alive: &mut [u64]) {
        for &number in among {
            let choice = choices[number as usize];
            if choice.first() {
                self.enter(2 * number, choices, alive);
            }
            if choice.second() {
                self.enter(2 * number + 1, choices, alive);
            }
        }
    }

    fn enter(&self, region: u32, choices: &[Choice], alive: &mut [u64]) {
        let (word, bit) = (region as usize / 64, 1 << (region % 64));
        if alive[word] & bit != 0 {
            return;
        }
        alive[word] |= bit;
        let Region {
            parts_of,
            choices: inside,
        } = self.all[region as usize];
        for &outer in parts_of {
            self.enter(outer, choices, alive);
        }
        self.choose(inside, choices, alive);
    }
}
