//! Hard rays one by one: what each must be answered, and what it takes.

#![forbid(unsafe_code)]

pub mod cases;
pub mod expected;

use expected::Expected;
use zeroset::Surface;
use zeroset::camera::Ray;
use zeroset::glam::DVec3;
use zeroset::interval::Isa;
use zeroset::query::Query;
use zeroset::render::Trail;
use zeroset::solve::Settings;

/// Traces a surface along a ray.
type Run = dyn Fn(&Ray, Isa, Settings) -> Trail;

/// A formula along a ray, and the events that must come of it.
pub struct Case {
    /// What is hard about it.
    pub what: &'static str,
    /// f, as it was written.
    pub formula: String,
    /// Origin and direction.
    pub ray: [[f64; 3]; 2],
    /// All events, in ascending order.
    pub expected: Vec<Expected>,
    run: Box<Run>,
}

impl Case {
    /// A surface along a ray from `origin` along `direction`, in a cube of half width `half`.
    pub fn new<S: Surface + 'static>(
        what: &'static str,
        formula: &str,
        surface: S,
        half: f64,
        ray: [[f64; 3]; 2],
        expected: Vec<Expected>,
    ) -> Self {
        Case {
            what,
            formula: formula.split_whitespace().collect::<Vec<_>>().join(" "),
            ray,
            expected,
            run: Box::new(move |ray, isa, settings| {
                let domain = [[-half; 3], [half; 3]];
                let mut query: Query<S> =
                    Query::new(&surface, domain, isa).expect("a surface in a box");
                query.settings = settings;
                query.trail(ray).expect("a ray")
            }),
        }
    }

    /// All events of the ray, and what they took.
    pub fn run(&self, isa: Isa) -> Trail {
        self.run_within(isa, Settings::default())
    }

    /// The same with other settings.
    pub fn run_within(&self, isa: Isa, settings: Settings) -> Trail {
        let [o, d] = self.ray.map(DVec3::from_array);
        let ray = Ray {
            origin: o,
            direction: d,
        };
        (self.run)(&ray, isa, settings)
    }

    /// Why an answer is not the expected one, if it is not.
    pub fn complaint(&self, trail: &Trail) -> Option<String> {
        expected::complaint(&self.expected, trail)
    }
}
