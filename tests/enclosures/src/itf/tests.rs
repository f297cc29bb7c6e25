use super::*;

/// A number that is a double.
fn number(text: &str) -> Option<f64> {
    enclosed(text).filter(|x| x.0 == x.1).map(|x| x.0)
}

#[test]
fn cases_are_read() {
    let text = "/* a\n comment; */\ntestcase x {\n  add [1.0,2.0]_com [-infinity,-0X1.8P+1] = [-infinity,-1.0]_dac;\n  pown [13.1, 13.1] 2 = [empty]; // 13.1;\n  neg [nai] = [nai];\n  sub [1.0]\n    [1, 1] = [0,0] <= [-1,1];\n  isEmpty [empty] = true;\n}\n";
    let cases = parse("x.itl", text).unwrap();
    assert_eq!(cases.len(), 5);
    assert_eq!((cases[0].place.line, cases[3].place.line), (4, 7));
    assert_eq!(
        cases[0].operands[1],
        Set::Some(Interval {
            lo: f64::NEG_INFINITY,
            hi: -3.0
        })
    );
    assert_eq!(cases[1].operands[1], Set::Number(2.0));
    assert_eq!(cases[1].results, [Set::Empty]);
    assert_eq!(cases[2].operands, [Set::Nai]);
    assert_eq!(cases[3].results, [Set::Some(Interval::ZERO)]);
    assert_eq!(cases[4].results, [Set::Other("true".to_owned())]);
}

#[test]
fn texts_and_lists_are_values() {
    let text = "testcase y { t \"[1;2]=//\" = [1,2]; sum {1.0, 2.0} = 3.0 signal inexact; }";
    let cases = parse("y.itl", text).unwrap();
    assert_eq!(cases[0].operands, [Set::Other("[1;2]=//".to_owned())]);
    assert_eq!(cases[1].operands, [Set::Other("1.0, 2.0".to_owned())]);
    assert_eq!(cases[1].results, [Set::Number(3.0)]);
}

#[test]
fn mistakes_are_named_with_file_and_line() {
    for (text, expected) in [
        (
            "\nadd [1,2] [3,4];",
            "z.itl:2: `add [1,2] [3,4]` has no `=`",
        ),
        ("add [1,2 = [1,2];", "z.itl:1: `[1,2` lacks a `]`"),
        (
            "\n\nneg [1,x] = [1,2];",
            "z.itl:3: [1,x]: `x` is not a number",
        ),
        (
            "neg [0x1.zp0,2] = [1,2];",
            "z.itl:1: [0x1.zp0,2]: `0x1.zp0` is not a number",
        ),
        (
            "neg [2,1] = [1,2];",
            "z.itl:1: [2,1]: [2, 1] is not an interval",
        ),
        ("pown [1,1] 2x = [1,1];", "z.itl:1: `2x` is not a number"),
        ("neg [1,1] = ;", "has no result"),
        ("neg = [1,1];", "z.itl:1: `neg` has no operand"),
        (
            "neg [1,1] = [1,1]",
            "z.itl:1: `neg [1,1] = [1,1]` does not end in `;`",
        ),
        ("\n/* neg", "z.itl:2: a comment does not end"),
    ] {
        let error = parse("z.itl", text).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}\n{expected}");
    }
}

#[test]
fn hexadecimal_numbers_are_exact() {
    assert_eq!(number("0X0.0000000000001P-1022"), Some(f64::from_bits(1)));
    assert_eq!(number("-0x1.FFFFFFFFFFFFFp1023"), Some(-f64::MAX));
    assert_eq!(number("0x1p-1074"), Some(f64::from_bits(1)));
    assert_eq!(number("0x1.8p-1022"), Some(1.5 * f64::MIN_POSITIVE));
    assert_eq!(number("0x1.8000000000000p4"), Some(24.0));
    // A bound that is no double is rounded outward.
    let bounds = set_of("-0x1.FFFFFFFFFFFFF8p0, 0x1.00000000000008p0");
    let outward = Interval {
        lo: -2.0,
        hi: 1.0f64.next_up(),
    };
    assert_eq!(bounds, Ok(Set::Some(outward)));
    // Not doubles.
    for text in ["0x1p1024", "0x1p-1075", "0x1.FFFFFFFFFFFFF8p0", "nan", "1e"] {
        assert_eq!(number(text), None, "{text}");
    }
}

/// A vector whose range is missed, one whose range is exceeded, and one that is right: the tally tells them apart.
#[test]
fn wrong_and_wide_ranges_are_noticed() {
    use crate::backend::Backend;
    let text =
        "neg [1,2] = [-2.5,-1]; neg [1,2] = [-1.5,-1]; neg [1,2] = [-2,-1]; neg [1] = [empty];";
    let cases = parse("w.itl", text).unwrap();
    for backend in Backend::rounded() {
        let neg = &tally::tally(backend, &cases)["neg"];
        assert_eq!((neg.run, neg.wrong.len(), neg.too_wide.len()), (4, 1, 1));
        assert!(neg.wrong[0].starts_with("w.itl:1: neg"), "{}", neg.wrong[0]);
    }
}
