//! The zoo, each surface in its cube. Apart from the program, so that it is compiled once.

#![forbid(unsafe_code)]

use std::f64::consts::TAU;

use zeroset_accuracy::subject::{Named, Subject};
use zeroset_zoo::surfaces as s;

macro_rules! subjects {
    ($($name:ident in $half:expr => $surface:expr;)*) => {
        vec![$(Box::new(Named::<_, false> { name: stringify!($name), half: $half, surface: $surface })),*]
    };
}

macro_rules! with_all_solvers {
    ($($name:ident in $half:expr => $surface:expr;)*) => {
        vec![$(Box::new(Named::<_, true> { name: stringify!($name), half: $half, surface: $surface })),*]
    };
}

/// All of them. This library's other solvers are compiled and measured for the first ones, one of each kind: compiling
/// them for all takes half an hour.
pub fn subjects() -> Vec<Box<dyn Subject>> {
    let mut all = first();
    all.extend(others());
    all
}

fn first() -> Vec<Box<dyn Subject>> {
    with_all_solvers! {
        sphere in 1.0 => s::Sphere;
        torus in 0.9 => s::Torus;
        barth_sextic in 2.0 => s::BarthSextic::default();
        chmutov_8 in 1.5 => s::Chmutov8;
        gyroid in TAU => s::Gyroid;
        exponentials in 1.0 => s::Exponentials { blobs: s::BLOBS };
    }
}

fn others() -> Vec<Box<dyn Subject>> {
    subjects! {
        ellipsoid in 1.5 => s::Ellipsoid;
        cylinder in 1.0 => s::Cylinder;
        cone in 1.0 => s::Cone;
        hyperboloid in 1.5 => s::Hyperboloid;
        torus_root in 0.9 => s::TorusRoot;
        cayley in 1.5 => s::Cayley;
        clebsch in 3.0 => s::Clebsch;
        kummer in 2.5 => s::Kummer::default();
        tangle in 3.2 => s::Tangle;
        mitchell in 2.1 => s::Mitchell;
        steiner in 0.6 => s::Steiner;
        klein in 4.2 => s::Klein;
        heart in 1.5 => s::Heart;
        teardrop in 1.2 => s::Teardrop;
        barth_decic in 2.2 => s::BarthDecic::default();
        chmutov_6 in 1.35 => s::Chmutov6;
        bretzel in 2.4 => s::Bretzel;
        decocube in 1.3 => s::Decocube;
        icosahedral in 4.77 => s::Icosahedral::default();
        superquadric in 1.3 => s::Superquadric;
        schwarz_p in TAU => s::SchwarzP;
        schwarz_d in TAU => s::SchwarzD;
        blobby in 2.5 => s::Blobby;
        scherk in 10.0 => s::Scherk;
        zitrus in 1.2 => s::Zitrus;
        ding_dong in 1.5 => s::DingDong;
        calypso in 1.5 => s::Calypso;
        whitney in 1.5 => s::Whitney;
        himmel in 1.5 => s::Himmel;
        limao in 1.5 => s::Limao;
        doubled_sphere in 1.0 => s::DoubledSphere;
        isolated_point in 1.0 => s::IsolatedPoint;
        thin_shell in 1.0 => s::ThinShell::default();
    }
}
