//! Contenders in turns, and what their times spread over.

use cpu_time::ProcessTime;
use std::time::{Duration, Instant};

/// Times of one contender, in seconds.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    pub least: f64,
    pub median: f64,
    pub most: f64,
}

impl Spread {
    /// Of at least one time.
    pub fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        Spread {
            least: times[0],
            median: times[times.len() / 2],
            most: times[times.len() - 1],
        }
    }

    /// In milliseconds, for a cell of a table.
    pub fn cell(&self) -> String {
        let [median, least, most] = [self.median, self.least, self.most].map(|t| digits(1e3 * t));
        format!("{median} ({least} … {most})")
    }
}

/// Three digits that tell something.
pub fn digits(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        1e-99..1e-3 => format!("{x:.1e}"),
        a => format!(
            "{x:.*}",
            (2 - a.log10().floor() as i32).clamp(0, 5) as usize
        ),
    }
}

/// What is timed: it says itself how long it took.
pub type Contender<'a> = Box<dyn FnMut() -> Duration + 'a>;

/// Lets all contenders run in turn, once to warm up and `runs` times to count.
pub fn interleave(runs: usize, contenders: &mut [Contender]) -> Vec<Spread> {
    let mut times = vec![Vec::new(); contenders.len()];
    for run in 0..=runs.max(1) {
        for (contender, times) in contenders.iter_mut().zip(&mut times) {
            let time = contender().as_secs_f64();
            if run > 0 {
                times.push(time);
            }
        }
    }
    times.into_iter().map(Spread::of).collect()
}

/// How long `work` takes: processor time on one thread, else by the clock on the wall.
pub fn timed<T>(threads: usize, work: impl FnOnce() -> T) -> Duration {
    let (wall, processor) = (Instant::now(), ProcessTime::now());
    let result = work();
    let time = if threads == 1 {
        processor.elapsed()
    } else {
        wall.elapsed()
    };
    std::hint::black_box(result);
    time
}

/// A pool of so many threads.
pub fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads can be started")
}

/// The processor's own name, and its family and model: names of virtual machines hide them.
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = text
            .lines()
            .find(|l| l.split(':').next().map(str::trim) == Some(name));
        line.and_then(|l| l.split(':').nth(1))
            .map_or("?", str::trim)
            .to_owned()
    };
    format!(
        "{}, family {}, model {}",
        field("model name"),
        field("cpu family"),
        field("model")
    )
}
