//! The family g = Σ exp(r(x, y, z)), and its random members.

use zeroset::implicit;

use crate::random::Random;

implicit! {
    /// Σ exp(rᵢ(x, y, z)) = level, each rᵢ a quadratic with all ten coefficients. Inside, the sum is above the level.
    #[derive(Clone, Debug)]
    #[domain(x in -1..1, y in -1..1, z in -1..1)]
    pub struct SumOfExpQuadrics {
        /// x², y², z², xy, xz, yz, x, y, z, 1
        pub terms: [[f64; 10]],
        /// The sum on the surface.
        pub level: f64 = 0.5,
    }
    level = sum([a, b, c, d, e, f, g, h, i, j] in terms) {
        exp(a*x^2 + b*y^2 + c*z^2 + d*x*y + e*x*z + f*y*z + g*x + h*y + i*z + j)
    }
}

/// The signs of a quadratic form's three eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// All negative: each term is a bump of height 1.
    NegativeDefinite,
    /// One or two are positive: each term is a saddle, and large at some of the box's corners.
    Indefinite,
}

impl Form {
    /// The name in figures and tables.
    pub fn name(self) -> &'static str {
        match self {
            Form::NegativeDefinite => "negative definite",
            Form::Indefinite => "indefinite",
        }
    }
}

/// `count` quadratics r(p) = (p − c)ᵀ A (p − c), with centres c whose mean is the origin and A = R diag(±1/s²) Rᵀ: a random
/// rotation R and three random half axes s. Those of bumps shrink as the terms become more, so that the sum stays a
/// cluster; saddles are flatter, so that their exponentials stay below e¹⁰ or so in the box.
pub fn quadratics(random: &mut Random, count: usize, form: Form) -> Vec<[f64; 10]> {
    let (shortest, longest) = match form {
        Form::NegativeDefinite => {
            let scale = (8.0 / count as f64).cbrt().min(1.4);
            (0.12 * scale, 0.46 * scale)
        }
        Form::Indefinite => (0.7, 1.4),
    };
    centres(random, count)
        .into_iter()
        .map(|centre| {
            let signs = signs(random, form);
            let mut axes = [[0.0; 3]; 3];
            let rotation = random.rotation();
            for (axis, (row, sign)) in axes.iter_mut().zip(rotation.iter().zip(signs)) {
                let s = random.between(shortest, longest);
                // Rows of the rotation, each scaled by the eigenvalue; `expand` multiplies by the row itself.
                *axis = row.map(|x| sign * x / (s * s));
            }
            expand(&product(&rotation, &axes), centre)
        })
        .collect()
}

/// Points of a ball, moved so that their mean is the origin: the cluster is in the middle of the picture.
fn centres(random: &mut Random, count: usize) -> Vec<[f64; 3]> {
    let points: Vec<_> = (0..count).map(|_| random.in_ball(0.6)).collect();
    let mean = [0, 1, 2].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / count as f64);
    let centred = |p: &[f64; 3]| [0, 1, 2].map(|k| p[k] - mean[k]);
    points.iter().map(centred).collect()
}

/// Three signs, not all of them the same for an indefinite form.
fn signs(random: &mut Random, form: Form) -> [f64; 3] {
    if form == Form::NegativeDefinite {
        return [-1.0; 3];
    }
    // Bits 001 to 110: neither none nor all.
    let bits = 1 + random.below(6);
    [0, 1, 2].map(|k| if bits >> k & 1 == 0 { -1.0 } else { 1.0 })
}

/// Rᵀ·S: the symmetric matrix Σₖ λₖ rₖ rₖᵀ where S has the rows λₖ rₖ.
fn product(r: &[[f64; 3]; 3], s: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| r[k][i] * s[k][j]).sum()))
}

/// (p − c)ᵀ A (p − c) = pᵀAp − 2(Ac)ᵀp + cᵀAc, with A symmetric.
fn expand(a: &[[f64; 3]; 3], c: [f64; 3]) -> [f64; 10] {
    let ac = [0, 1, 2].map(|i| a[i][0] * c[0] + a[i][1] * c[1] + a[i][2] * c[2]);
    let constant = ac[0] * c[0] + ac[1] * c[1] + ac[2] * c[2];
    let mixed = |i: usize, j: usize| a[i][j] + a[j][i];
    [
        a[0][0],
        a[1][1],
        a[2][2],
        mixed(0, 1),
        mixed(0, 2),
        mixed(1, 2),
        -2.0 * ac[0],
        -2.0 * ac[1],
        -2.0 * ac[2],
        constant,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(q: &[f64; 10], [x, y, z]: [f64; 3]) -> f64 {
        q[0] * x * x
            + q[1] * y * y
            + q[2] * z * z
            + q[3] * x * y
            + q[4] * x * z
            + q[5] * y * z
            + q[6] * x
            + q[7] * y
            + q[8] * z
            + q[9]
    }

    #[test]
    fn expansion_is_the_form_about_its_centre() {
        let a = [[-2.0, 0.5, 0.25], [0.5, -3.0, 1.0], [0.25, 1.0, -4.0]];
        let q = expand(&a, [0.5, -0.25, 1.0]);
        // At c + (1, 2, 3): the sum of all aᵢⱼ dᵢ dⱼ.
        let expected = -2.0 - 12.0 - 36.0 + 2.0 * (0.5 * 2.0 + 0.25 * 3.0 + 1.0 * 6.0);
        assert!((value(&q, [1.5, 1.75, 4.0]) - expected).abs() < 1e-12);
        assert!(value(&q, [0.5, -0.25, 1.0]).abs() < 1e-12);
    }

    #[test]
    fn definite_terms_are_never_positive_and_indefinite_ones_have_both_signs() {
        let mut random = Random::new(3);
        let points: Vec<_> = (0..500).map(|_| random.in_ball(1.7)).collect();
        for q in quadratics(&mut random, 20, Form::NegativeDefinite) {
            assert!(points.iter().all(|&p| value(&q, p) < 1e-9));
        }
        for q in quadratics(&mut random, 20, Form::Indefinite) {
            assert!(points.iter().any(|&p| value(&q, p) > 0.0));
            assert!(points.iter().any(|&p| value(&q, p) < 0.0));
        }
    }
}
