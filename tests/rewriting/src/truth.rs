//! The exact value of a formula of rational operations at a rational point.

use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};

use crate::formula::Formula;

/// The exact number of an `f64`.
///
/// # Panics
/// If it is not finite.
pub fn exact(x: f64) -> BigRational {
    BigRational::from_f64(x).expect("a finite number")
}

/// f(point), where f is defined; nothing for a formula with other than rational values.
pub fn value(f: &Formula, point: &[BigRational; 3]) -> Option<BigRational> {
    let of = |f: &Formula| value(f, point);
    Some(match f {
        Formula::Quarters(n) => BigRational::new((*n).into(), 4.into()),
        Formula::Pi => return None,
        Formula::Coordinate(k) => point[*k].clone(),
        Formula::Negate(a) => -of(a)?,
        Formula::Binary(sign, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            match sign {
                '+' => a + b,
                '-' => a - b,
                '*' => a * b,
                _ if b.is_zero() => return None,
                _ => a / b,
            }
        }
        Formula::Power(a, halves) if halves % 2 == 0 => {
            let a = of(a)?;
            if a.is_zero() && *halves < 0 {
                return None;
            }
            num_traits::Pow::pow(a, halves / 2)
        }
        Formula::Power(..) => return None,
        Formula::Call(name, of_these) => {
            let mut numbers = of_these.iter().map(of).collect::<Option<Vec<_>>>()?;
            match (*name, numbers.len()) {
                ("abs", 1) => numbers.remove(0).abs(),
                ("recip", 1) if numbers[0].is_zero() => return None,
                ("recip", 1) => BigRational::one() / numbers.remove(0),
                ("min", 2) => numbers.into_iter().min()?,
                ("max", 2) => numbers.into_iter().max()?,
                ("clamp", 3) => {
                    let v = numbers.remove(0);
                    v.min(numbers.remove(1)).max(numbers.remove(0))
                }
                _ => return None,
            }
        }
        Formula::If(all) => {
            let [a, b, c, d] = all.each_ref().map(of);
            if a? < b? { c? } else { d? }
        }
    })
}
