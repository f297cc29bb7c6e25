//! The singular points of surfaces whose number is known: a formula that is typed wrongly has another number.

#![forbid(unsafe_code)]
#![allow(missing_docs)]

use zeroset::implicit;
use zeroset_zoo::nodes::nodes;
use zeroset_zoo::surfaces as s;

// With the exact golden ratio and square root, where the zoo's surfaces take their nearest numbers.
implicit! { pub struct Kummer;
let m = 1.69;
let root = sqrt(2);
(x^2 + y^2 + z^2 - m)^2
    - (3*m - 1)/(3 - m)*(1 - z - root*x)*(1 - z + root*x)*(1 + z + root*y)*(1 + z - root*y) }
implicit! { pub struct BarthSextic;
let phi = (1 + sqrt(5))/2;
4*(phi^2*x^2 - y^2)*(phi^2*y^2 - z^2)*(phi^2*z^2 - x^2) - (1 + 2*phi)*(x^2 + y^2 + z^2 - 1)^2 }
implicit! { pub struct BarthDecic;
let phi = (1 + sqrt(5))/2;
let r = x^2 + y^2 + z^2;
8*(x^2 - phi^4*y^2)*(y^2 - phi^4*z^2)*(z^2 - phi^4*x^2)*(x^4 + y^4 + z^4 - 2*(x^2*y^2 + y^2*z^2 + z^2*x^2))
    + (3 + 5*phi)*(r - 1)^2*(r - (2 - phi))^2 }
implicit! { pub struct WrongDecic;
let phi = (1 + sqrt(5))/2;
let r = x^2 + y^2 + z^2;
8*(x^2 - phi^4*y^2)*(y^2 - phi^4*z^2)*(z^2 - phi^4*x^2)*(x^4 + y^4 + z^4 - 2*(x^2*y^2 + y^2*z^2 + z^2*x^2))
    + (3 + 5*phi)*(r - 1)^2*(r - (2 - phi)^2) }
implicit! { pub struct SmoothChmutov6;
32*x^6 - 48*x^4 + 18*x^2 + 32*y^6 - 48*y^4 + 18*y^2 + 32*z^6 - 48*z^4 + 18*z^2 - 3 }

macro_rules! nodes {
    ($($test:ident: $surface:expr, $half:expr => $count:expr;)*) => {
        $(#[test]
        fn $test() {
            let found = nodes(&$surface, $half);
            println!("{} cells", found.cells);
            assert_eq!((found.nodes.len(), found.open), ($count, 0), "{} cells", found.cells);
            assert!(found.doubt < 1e-9, "|f| may be {} at a node", found.doubt);
        })*
    };
}

nodes! {
    cayley: s::Cayley, 1.5 => 4;
    clebsch: s::Clebsch, 3.0 => 0;
    kummer: Kummer, 2.5 => 16;
    tangle: s::Tangle, 3.2 => 0;
    mitchell: s::Mitchell, 2.1 => 0;
    barth_sextic: BarthSextic, 2.0 => 50;
    barth_decic: BarthDecic, 2.2 => 300;
    chmutov_6: s::Chmutov6, 1.35 => 54;
    chmutov_8: s::Chmutov8, 1.5 => 144;
    a_cone: s::Cone, 1.0 => 1;
    // Controls: not what was meant.
    a_decic_typed_wrongly: WrongDecic, 2.2 => 90;
    chmutov_6_without_its_one: SmoothChmutov6, 1.35 => 0;
}

/// A surface along a curve of singular points is left open, not counted.
#[test]
fn a_double_line_is_no_number_of_nodes() {
    implicit! { struct DoubleLine; x^2*(1 + z) - y^2 }
    let found = nodes(&DoubleLine, 0.01);
    assert!(found.open > 0);
}
