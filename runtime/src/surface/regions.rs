//! Which regions of a surface's code matter: the code that one side of a choice needs, or each of several sides.

/// The regions of a formula's code: two for each choice, one for either side, and behind them those that several sides share.
#[derive(Clone, Copy, Debug)]
pub struct Regions {
    /// How many there are.
    pub count: usize,
    /// The choices: what stands inside of others comes behind these.
    pub choices: &'static [Place],
}

/// A choice among others.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Which it is.
    pub choice: u32,
    /// The region in which it stands.
    pub within: Option<u32>,
    /// So many of the choices that follow stand inside of its sides.
    pub inside: u32,
    /// The regions of several sides that each of its own is a part of.
    pub parts_of: [&'static [u32]; 2],
}

impl Regions {
    /// There are no choices.
    pub const NONE: Regions = Regions {
        count: 0,
        choices: &[],
    };

    /// All of them, bit by bit.
    pub(super) fn all(&self) -> Vec<u32> {
        vec![u32::MAX; self.count.div_ceil(WORD)]
    }

    /// In which of eight lists each region is alive, from those in which the first number of each choice may be less, and the
    /// second.
    pub(crate) fn find(&self, may: &[[u8; 2]], alive: &mut Vec<u8>) {
        alive.clear();
        alive.resize(self.count.next_multiple_of(WORD), 0);
        let mut next = 0;
        while let Some(place) = self.choices.get(next) {
            let around = place.within.map_or(!0, |region| alive[region as usize]);
            let mut any = 0;
            for (side, parts_of) in place.parts_of.iter().enumerate() {
                let lists = may[place.choice as usize][side] & around;
                if lists != 0 {
                    alive[2 * place.choice as usize + side] = lists;
                    parts_of
                        .iter()
                        .for_each(|union| alive[*union as usize] |= lists);
                    any = lists;
                }
            }
            next += if any == 0 {
                place.inside as usize + 1
            } else {
                1
            };
        }
    }
}

/// How many regions a word tells of.
const WORD: usize = u32::BITS as usize;

/// What bytes, each of which tells of eight lists, tell of one of them, bit by bit.
pub(super) fn words(bytes: &[u8], list: usize) -> impl Iterator<Item = u32> {
    /// The lowest bit of each byte, …
    const EACH: u64 = 0x0101_0101_0101_0101;
    /// … and from there to the byte's own place in the highest.
    const TOGETHER: u64 = 0x0102_0408_1020_4080;
    let byte = move |eight: &[u8; 8]| {
        let bits = u64::from_le_bytes(*eight) >> list & EACH;
        (bits.wrapping_mul(TOGETHER) >> 56) as u8
    };
    let (eights, _) = bytes.as_chunks::<8>();
    let (words, _) = eights.as_chunks::<4>();
    words
        .iter()
        .map(move |word| u32::from_le_bytes(word.each_ref().map(byte)))
}

#[cfg(test)]
mod tests {
    use super::super::Choice;
    use super::{Place, Regions, words};

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
                let own = choice != [Choice::Second, Choice::First][side % 2];
                own && self.within[side / 2].is_none_or(|outer| self.alive(choices, outer))
            })
        }

        fn table(&self) -> Regions {
            let sides = 2 * self.within.len();
            let parts_of = |side| -> &'static [u32] {
                let unions = (0..self.unions.len()).filter(|u| self.unions[*u].contains(&side));
                unions
                    .map(|u| (sides + u) as u32)
                    .collect::<Vec<_>>()
                    .leak()
            };
            let choices = (0..).zip(&self.within).map(|(choice, within)| Place {
                choice,
                within: within.map(|region| region as u32),
                inside: 0,
                parts_of: [0, 1].map(|side| parts_of(2 * choice as usize + side)),
            });
            Regions {
                count: sides + self.unions.len(),
                choices: choices.collect::<Vec<_>>().leak(),
            }
        }
    }

    #[test]
    fn a_region_is_alive_where_one_of_its_sides_is() {
        let (mut state, mut dead) = (7, 0);
        for _ in 0..300 {
            let nest = Nest::new(&mut state, 40);
            let any = [Choice::Open, Choice::First, Choice::Second];
            let mut list = || (0..40).map(|_| any[random(&mut state, 3)]).collect();
            let lists: [Vec<Choice>; 8] = core::array::from_fn(|_| list());
            let bits = |choice: usize, other: Choice| {
                let may = (0..8).filter(|k| lists[*k][choice] != other);
                may.fold(0, |bits, k| bits | 1 << k)
            };
            let may = |choice| [Choice::Second, Choice::First].map(|other| bits(choice, other));
            let may: Vec<[u8; 2]> = (0..40).map(may).collect();
            let (table, mut found) = (nest.table(), Vec::new());
            table.find(&may, &mut found);
            for (list, choices) in lists.iter().enumerate() {
                let found: Vec<u32> = words(&found, list).collect();
                for region in 0..table.count {
                    let alive = found[region / 32] >> (region % 32) & 1 != 0;
                    assert_eq!(alive, nest.alive(choices, region), "{region}");
                    dead += usize::from(!alive);
                }
            }
        }
        assert!(dead > 1_000, "{dead}");
    }
}
