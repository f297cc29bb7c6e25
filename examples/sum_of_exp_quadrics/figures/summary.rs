//! Many numbers in four.

/// The mean, and the quartiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// The sum over the count.
    pub mean: f64,
    /// A quarter of the numbers is below.
    pub first: f64,
    /// Half of the numbers are below.
    pub median: f64,
    /// Three quarters are below.
    pub third: f64,
}

impl Summary {
    /// Of at least one number; quartiles are interpolated between neighbours.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_by(f64::total_cmp);
        let last = numbers.len() - 1;
        let quantile = |q: f64| {
            let place = q * last as f64;
            let (low, part) = (place.floor() as usize, place.fract());
            let high = (low + 1).min(last);
            numbers[low] + part * (numbers[high] - numbers[low])
        };
        Summary {
            mean: numbers.iter().sum::<f64>() / numbers.len() as f64,
            first: quantile(0.25),
            median: quantile(0.5),
            third: quantile(0.75),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_a_known_list() {
        let s = Summary::of(vec![9.0, 1.0, 3.0, 2.0, 5.0]);
        assert_eq!((s.mean, s.first, s.median, s.third), (4.0, 2.0, 3.0, 5.0));
        assert_eq!(Summary::of(vec![1.0, 2.0]).median, 1.5);
    }
}
