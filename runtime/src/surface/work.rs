//! What evaluations of a surface cost.

use super::Active;

/// What evaluations of f cost along a ray, roughly, in additions of two enclosures.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    /// Outside of folds.
    pub whole: u32,
    /// A row of each outermost fold.
    pub rows: &'static [u32],
    /// What is computed only where the first number of a choice is less, and only where the second is.
    pub sides: &'static [[u32; 2]],
}

impl Work {
    /// Nothing is known.
    pub const UNKNOWN: Work = Work {
        whole: 0,
        rows: &[],
        sides: &[],
    };

    /// With what is active.
    pub(crate) fn of(&self, active: &Active) -> u32 {
        let rows = self.rows.iter().zip(&active.rows);
        let rows = rows.map(|(work, rows)| work.saturating_mul(rows.len() as u32));
        let sides = self.sides.iter().zip(&active.choices);
        // By a table: there may be hundreds, and no telling which.
        let spared = sides.map(|([first, second], choice)| [0, *second, *first][*choice as usize]);
        let all = rows.fold(self.whole, u32::saturating_add);
        all.saturating_sub(spared.fold(0, u32::saturating_add))
    }

    /// Is a list so much less than one of this work that it is worth another look at rays behind where it holds?
    pub(crate) fn pays(&self, less: &Active, than: u32) -> bool {
        4 * u64::from(self.of(less)) <= 3 * u64::from(than)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Choice, Regions};
    use super::{Active, Work};

    #[test]
    fn lists_pay_if_they_spare_a_quarter() {
        let work = Work {
            whole: 100,
            rows: &[10],
            sides: &[[60, 4]],
        };
        let all = Active::everything(&[8], 0, 1, &[Regions::NONE; 2]);
        let with = |choice| Active {
            choices: vec![choice],
            ..all.clone()
        };
        // Where the first number is less, the second side is not computed.
        assert!(!work.pays(&with(Choice::First), work.of(&all)));
        assert!(work.pays(&with(Choice::Second), work.of(&all)));
        let rows = |n| Active::everything(&[n], 0, 1, &[Regions::NONE; 2]);
        assert!(!work.pays(&rows(4), work.of(&all)));
        assert!(work.pays(&rows(3), work.of(&all)));
        assert!(Work::UNKNOWN.pays(&all, Work::UNKNOWN.of(&all)));
    }
}
