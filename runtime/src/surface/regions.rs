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

#[cfg(test)]
mod tests {
    use super::super::Choice;
    use super::{Region, Regions};

    /// Numbers below `n`, one after the other.
    fn random(state: &mut u64, n: usize) -> usize {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
        (*state >> 33) as usize % n
    }

    /// Where each choice stands: in no region, in one side of an earlier choice, or in a region of several sides.
    struct Nest {
        within: Vec<Option<usize>>,
        unions: Vec<Vec<usize>>,
    }

    impl Nest {
        fn new(state: &mut u64, choices: usize) -> Nest {
            let mut nest = Nest {
                within: vec![None],
                unions: Vec::new(),
            };
            for number in 1..choices {
                let sides = 2 * number;
                let some = [0; 3].map(|_| random(state, sides));
                nest.within.push(match random(state, 4) {
                    0 => None,
                    1 => {
                        nest.unions.push(some.to_vec());
                        Some(2 * choices + nest.unions.len() - 1)
                    }
                    _ => Some(some[0]),
                });
            }
            nest
        }

        fn holds(&self, region: usize) -> Vec<usize> {
            let union = region.checked_sub(2 * self.within.len());
            union.map_or(vec![region], |number| self.unions[number].clone())
        }

        /// By the definition: regions inside of others come later.
        fn alive(&self, choices: &[Choice], region: usize) -> bool {
            self.holds(region).into_iter().any(|side| {
                let choice = choices[side / 2];
                let own = [choice.first(), choice.second()][side % 2];
                own && self.within[side / 2].is_none_or(|outer| self.alive(choices, outer))
            })
        }

        fn table(&self) -> Regions {
            let sides = 2 * self.within.len();
            let standing = |stands: &dyn Fn(Option<usize>) -> bool| -> &'static [u32] {
                let all = (0..self.within.len()).filter(|k| stands(self.within[*k]));
                all.map(|k| k as u32).collect::<Vec<_>>().leak()
            };
            let of_sides = (0..sides).map(|side| {
                let parts_of = (0..self.unions.len()).filter(|u| self.unions[*u].contains(&side));
                let parts_of = parts_of.map(|u| ((sides + u) as u32 / 32, 1 << ((sides + u) % 32)));
                Region {
                    parts_of: parts_of.collect::<Vec<_>>().leak(),
                    choices: standing(&|w| w.is_some_and(|of| self.holds(of).contains(&side))),
                }
            });
            Regions {
                count: sides + self.unions.len(),
                outermost: standing(&|w| w.is_none()),
                of_sides: of_sides.collect::<Vec<_>>().leak(),
            }
        }
    }

    #[test]
    fn a_region_is_alive_where_one_of_its_sides_is() {
        let (mut state, mut dead) = (7, 0);
        for _ in 0..300 {
            let nest = Nest::new(&mut state, 40);
            let (table, mut found) = (nest.table(), Vec::new());
            let any = [Choice::Open, Choice::First, Choice::Second];
            let choices: Vec<Choice> = (0..40).map(|_| any[random(&mut state, 3)]).collect();
            table.find(&choices, &mut found);
            for region in 0..table.count {
                let alive = found[region / 32] >> (region % 32) & 1 != 0;
                assert_eq!(alive, nest.alive(&choices, region), "{region}");
                dead += usize::from(!alive);
            }
        }
        assert!(dead > 1_000, "{dead}");
    }
}
