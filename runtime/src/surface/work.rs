//! What evaluations of a surface cost.

use super::Active;

/// What evaluations of f cost along a ray, roughly, in additions of two enclosures.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    /// Outside of folds and regions.
    pub whole: u32,
    /// A row of each outermost fold.
    pub rows: &'static [u32],
    /// Each region, without those inside of it.
    pub regions: &'static [u32],
}

impl Work {
    /// Nothing is known.
    pub const UNKNOWN: Work = Work {
        whole: 0,
        rows: &[],
        regions: &[],
    };

    /// With what is active.
    pub(crate) fn of(&self, active: &Active) -> u32 {
        let rows = self.rows.iter().zip(&active.rows);
        let rows = rows.map(|(work, rows)| work.saturating_mul(rows.len() as u32));
        let regions = active.regions().map(|number| self.regions.get(number));
        let regions = regions.map(|work| work.copied().unwrap_or(0));
        rows.chain(regions).fold(self.whole, u32::saturating_add)
    }

    /// Is a list so much less than one of this work that it is worth another look at rays behind where it holds?
    pub(crate) fn pays(&self, less: &Active, than: u32) -> bool {
        4 * u64::from(self.of(less)) <= 3 * u64::from(than)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Place, Regions};
    use super::{Active, Work};

    #[test]
    fn lists_pay_if_they_spare_a_quarter() {
        let regions = Regions {
            count: 2,
            choices: &[Place {
                choice: 0,
                within: None,
                inside: 0,
                parts_of: [&[]; 2],
            }],
        };
        let work = Work {
            whole: 30,
            rows: &[10],
            regions: &[60, 10],
        };
        let all = Active::everything(&[8], 0, 1, &regions);
        let with = |may| {
            let (mut active, mut alive) = (all.clone(), Vec::new());
            regions.find(&[may], &mut alive);
            active.decide(0, &[may], &alive);
            active
        };
        assert_eq!(work.of(&all), 180);
        // Where the first number is less, the second side is not computed.
        assert!(!work.pays(&with([1, 0]), work.of(&all)));
        assert!(work.pays(&with([0, 1]), work.of(&all)));
        let rows = |n| Active::everything(&[n], 0, 1, &regions);
        assert!(!work.pays(&rows(4), work.of(&all)));
        assert!(work.pays(&rows(3), work.of(&all)));
        assert!(Work::UNKNOWN.pays(&all, Work::UNKNOWN.of(&all)));
    }
}
