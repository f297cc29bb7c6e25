//! What somebody may have meant.

/// The candidate that is nearest to a name, if it is near enough: a third of its letters may differ, as in rustc.
pub(super) fn nearest<'a>(
    name: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let most = name.chars().count().max(3) / 3;
    let near = |candidate: &'a str| {
        if candidate.to_lowercase() == name.to_lowercase() {
            return Some((0, candidate));
        }
        // Names of one letter are all one letter apart.
        if name.chars().count() < 2 || candidate.chars().count() < 2 {
            return None;
        }
        let distance = distance(name, candidate);
        (distance <= most).then_some((distance, candidate))
    };
    candidates
        .filter_map(near)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// How many letters must be changed, added, removed or swapped with their neighbour: the optimal string alignment
/// distance.
fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().take(64).collect();
    let b: Vec<char> = b.chars().take(64).collect();
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = change.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// `x*y` for `xy`, if the name is made of names that can be used.
pub(super) fn product(name: &str, visible: &[String]) -> Option<String> {
    let mut rest = name;
    let mut factors = Vec::new();
    while !rest.is_empty() {
        let factor = visible
            .iter()
            .filter(|v| {
                rest.starts_with(v.as_str()) && (rest.len() < name.len() || v.len() < name.len())
            })
            .max_by_key(|v| v.len())?;
        factors.push(factor.as_str());
        rest = rest.get(factor.len()..)?;
    }
    (factors.len() > 1).then(|| factors.join("*"))
}

/// `x^2` for `x2`.
pub(super) fn power(name: &str, visible: &[String]) -> Option<String> {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let exponent = name.get(base.len()..)?;
    // Nobody means `x^1` by `x1`.
    (!matches!(exponent, "" | "0" | "1") && visible.iter().any(|v| v == base))
        .then(|| format!("{base}^{exponent}"))
}

/// The constant that goes by another name elsewhere.
pub(super) fn constant(name: &str) -> Option<&'static str> {
    match name {
        "PI" | "Pi" | "π" | "M_PI" => Some("pi"),
        "TAU" | "Tau" | "τ" => Some("tau"),
        "phi" | "PHI" | "φ" => Some("(1 + sqrt(5))/2"),
        _ => None,
    }
}

/// Values of `f64` that are not numbers.
pub(super) fn not_finite(name: &str) -> bool {
    let name = name.to_lowercase();
    matches!(name.as_str(), "inf" | "infinity" | "nan" | "∞")
}

/// Functions that jump.
pub(super) fn jumps(name: &str) -> bool {
    matches!(
        name,
        "floor"
            | "ceil"
            | "round"
            | "trunc"
            | "fract"
            | "signum"
            | "sign"
            | "sgn"
            | "copysign"
            | "rem_euclid"
            | "div_euclid"
            | "mod"
            | "fmod"
            | "step"
            | "round_ties_even"
    )
}

/// What to write for functions that other languages have.
pub(super) fn instead_of_function(name: &str) -> Option<&'static str> {
    Some(match name {
        "pow" | "powf" | "powi" | "power" => "a^b",
        "sqr" | "square" | "sq" => "a^2",
        "mul_add" | "fma" => "a*b + c",
        "sec" => "1/cos(a)",
        "csc" | "cosec" => "1/sin(a)",
        "cot" => "1/tan(a)",
        "sin_cos" => "sin(a)",
        "tg" => "tan(a)",
        "ctg" | "ctan" | "cotan" => "1/tan(a)",
        "sh" => "sinh(a)",
        "ch" => "cosh(a)",
        "th" => "tanh(a)",
        "arcsin" => "asin(a)",
        "arccos" => "acos(a)",
        "arctan" | "arctg" => "atan(a)",
        "arsinh" | "arcsinh" => "asinh(a)",
        "arcosh" | "arccosh" => "acosh(a)",
        "artanh" | "arctanh" => "atanh(a)",
        "to_radians" | "radians" => "a*pi/180",
        "to_degrees" | "degrees" => "a*180/pi",
        "ln1p" | "log1p" => "ln_1p(a)",
        "expm1" => "exp_m1(a)",
        "length" | "norm" => "sqrt(x^2 + y^2 + z^2)",
        "mix" | "lerp" => "a + t*(b - a)",
        "inv" | "inverse" => "recip(a)",
        "dot" => "a*x + b*y + c*z",
        "smoothstep" => "let t = clamp((a - lower)/(upper - lower), 0, 1); t^2*(3 - 2*t)",
        "smin" | "smooth_min" | "smooth_union" => "-k*ln(exp(-a/k) + exp(-b/k))",
        "union" => "min(a, b)",
        "intersection" => "max(a, b)",
        "difference" => "max(a, -b)",
        "sum" => "sum(i in 0..8) { … }",
        "prod" | "product" => "prod(i in 0..8) { … }",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_is_a_third_of_the_letters() {
        assert_eq!(
            nearest("radus", ["radius", "major"].into_iter()),
            Some("radius")
        );
        assert_eq!(
            nearest("sine", ["cos", "sin", "sinh"].into_iter()),
            Some("sin")
        );
        assert_eq!(nearest("qqq", ["radius", "x"].into_iter()), None);
        assert_eq!(nearest("a", ["b"].into_iter()), None);
        assert_eq!(nearest("X", ["x", "y"].into_iter()), Some("x"));
        assert_eq!(distance("abcd", "abdc"), 1);
        assert_eq!(distance("", "abc"), 3);
    }

    #[test]
    fn products_take_the_longest_factor_first() {
        let visible: Vec<String> = ["x", "y", "k", "kx"].map(str::to_owned).to_vec();
        assert_eq!(product("xy", &visible).as_deref(), Some("x*y"));
        assert_eq!(product("kxy", &visible).as_deref(), Some("kx*y"));
        assert_eq!(product("xq", &visible), None);
        assert_eq!(product("kx", &visible).as_deref(), Some("k*x"));
    }
}
