//! Scenes and pictures: which surface wins, what is refused, and that threads and instruction sets agree.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use zeroset::camera::{Camera, Ray, Sampling};
use zeroset::interval::Isa;
use zeroset::render::{Options, Progress, RenderError, all_roots, render, render_over};
use zeroset::scene::{Scene, SceneError};
use zeroset::shade::Shading;
use zeroset::verdict::Verdict;
use zeroset_tracing_tests::staged::{Ball, Blobs};

fn camera() -> Camera {
    Camera::perspective(DVec3::new(0.0, 0.0, 4.0), DVec3::ZERO, DVec3::Y, 40.0).unwrap()
}

fn ball(radius: f64) -> Ball {
    Ball { radius, half: 2.0 }
}

#[test]
fn the_nearest_surface_wins_in_any_order() {
    let options = Options::new(33, 21);
    for (scene, outer) in [
        (Scene::new().with(ball(1.0)).with(ball(0.5)), 0),
        (Scene::new().with(ball(0.5)).with(ball(1.0)), 1),
    ] {
        let picture = render(&scene, &camera(), &options).unwrap();
        let mut hits = 0;
        for (x, y) in (0..33).flat_map(|x| (0..21).map(move |y| (x, y))) {
            let pixel = picture.pixel(x, y);
            assert_eq!(
                pixel.surface.is_some(),
                matches!(pixel.answer.first, Verdict::Root { .. })
            );
            assert!(pixel.surface.is_none_or(|s| s == outer));
            hits += usize::from(pixel.surface.is_some());
        }
        assert!(hits > 50, "{hits}");
    }
}

#[test]
fn surfaces_in_one_place_are_tied() {
    let scene = Scene::new().with(ball(1.0)).with(ball(1.0));
    let picture = render(&scene, &camera(), &Options::new(16, 16)).unwrap();
    let s = picture.statistics();
    assert!(s.root > 0 && s.tied == s.root, "{s}");
}

#[test]
fn normals_are_unit_vectors_towards_the_viewer() {
    let picture = render(
        &Scene::new().with(ball(1.0)),
        &camera(),
        &Options::new(32, 32),
    )
    .unwrap();
    let pixel = picture.pixel(16, 16);
    let n = pixel.normal.expect("the ball is in the middle");
    let length = n.iter().map(|x| x * x).sum::<f32>();
    assert!((length - 1.0).abs() < 1e-6 && n[2] > 0.9, "{n:?}");
    // From inside the gradient points away from the viewer, the normal does not.
    let inside =
        Camera::perspective(DVec3::new(0.0, 0.0, 0.5), DVec3::ZERO, DVec3::Y, 40.0).unwrap();
    let picture = render(
        &Scene::new().with(ball(1.0)),
        &inside,
        &Options::new(32, 32),
    )
    .unwrap();
    assert!(picture.pixel(16, 16).normal.expect("all pixels hit")[2] > 0.9);
}

#[test]
fn threads_and_instruction_sets_agree() {
    let scene = || {
        Scene::new().with(ball(1.0)).with(Ball {
            radius: 1.4,
            half: 1.2,
        })
    };
    let mut pictures = Vec::new();
    for isa in Isa::available() {
        for threads in [1, 3] {
            let mut options = Options::new(50, 37);
            options.isa = Some(isa);
            options.threads = Some(threads);
            let picture = render(&scene(), &camera(), &options).unwrap();
            assert_eq!(picture.statistics().isa, isa.name());
            pictures.push((isa, picture));
        }
    }
    for pair in pictures.windows(2) {
        let ((a, one), (b, other)) = (&pair[0], &pair[1]);
        let mut hits = 0;
        for (x, y) in (0..50).flat_map(|x| (0..37).map(move |y| (x, y))) {
            let (p, q) = (one.answer(x, y), other.answer(x, y));
            if a == b {
                assert_eq!(p, q, "threads differ at ({x}, {y})");
            }
            if let (Some(s), Some(t)) = (p.first.t(), q.first.t()) {
                assert!(
                    p.entry + s.lo <= q.entry + t.hi + 1e-14,
                    "{a} and {b} at ({x}, {y})"
                );
                assert!(
                    q.entry + t.lo <= p.entry + s.hi + 1e-14,
                    "{a} and {b} at ({x}, {y})"
                );
                hits += 1;
            }
        }
        assert!(hits > 100, "{hits}");
    }
}

#[test]
fn nothing_shows_of_a_picture_that_is_rendered_over() {
    let scene = |radius| Scene::new().with(ball(radius));
    let options = |size, threads| {
        let mut options = Options::new(size, size);
        options.threads = Some(threads);
        options
    };
    let mut last = render(&scene(1.2), &camera(), &options(150, 2)).unwrap();
    // Smaller and larger pictures, on fewer and more threads.
    for (radius, size, threads) in [(0.3, 40, 1), (0.9, 260, 3), (0.6, 90, 2)] {
        let (scene, options) = (scene(radius), options(size, threads));
        let fresh = render(&scene, &camera(), &options).unwrap();
        last = render_over(last, &scene, &camera(), &options).unwrap();
        assert_eq!([last.width(), last.height()], [size; 2]);
        let pixels = (0..size).flat_map(|x| (0..size).map(move |y| (x, y)));
        for (x, y) in pixels {
            let pixel = last.pixel(x, y);
            assert_eq!(pixel, fresh.pixel(x, y), "({x}, {y})");
            assert_eq!(pixel.surface.is_some(), pixel.normal.is_some());
        }
        assert_eq!(last.statistics().root, fresh.statistics().root);
        assert!(fresh.statistics().root > 20);
    }
}

#[test]
fn what_is_skipped_is_counted() {
    let mut options = Options::new(41, 37);
    options.settings.beams = false;
    let scene = Scene::new().with(ball(1.0)).within([-2.0; 3], [2.0; 3]);
    let wide =
        Camera::perspective(DVec3::new(0.0, 0.0, 4.0), DVec3::ZERO, DVec3::Y, 120.0).unwrap();
    let with = render(&scene, &wide, &options).unwrap();
    let s = with.statistics();
    assert_eq!(s.rays, 41 * 37);
    assert_eq!(
        s.rays,
        s.miss + s.root + s.tangent + s.crossing + s.unresolved
    );
    assert!(s.outside > 100 && s.root > 10, "{s}");
    let e = s.evaluations;
    assert_eq!(
        (s.rays - s.outside, e.gradient, e.total()),
        (e.closed, s.root, s.root)
    );
    options.settings.closed_forms = false;
    options.normals = false;
    let without = render(&scene, &wide, &options).unwrap();
    let e = without.statistics().evaluations;
    assert_eq!((e.closed, e.gradient), (0, 0));
    assert!(e.value + e.slope > 100, "{e:?}");
}

/// Balls that the box cuts, blobs, two surfaces in two boxes.
fn scenes() -> [Scene; 4] {
    let inner = Ball {
        radius: 1.4,
        half: 1.2,
    };
    [
        Scene::new().with(ball(1.0)),
        Scene::new().with(inner),
        Scene::new().with(Blobs::some(3)),
        Scene::new().with(inner).with(Blobs::some(2)),
    ]
}

fn cameras() -> [Camera; 5] {
    let far = |distance: f64, angle| {
        let from = distance * DVec3::new(0.48, 0.6, 0.64);
        Camera::perspective(from, DVec3::ZERO, DVec3::Y, angle).unwrap()
    };
    let inside = Camera::perspective(DVec3::splat(0.1), DVec3::X, DVec3::Y, 120.0).unwrap();
    let oblique =
        Camera::orthographic(DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO, DVec3::Y, 3.0).unwrap();
    [camera(), inside, oblique, far(1e3, 0.2), far(1e6, 2e-4)]
}

#[test]
fn beams_change_no_verdict() {
    for isa in Isa::available() {
        let (mut hits, mut spared, mut single) = (0, 0, 0);
        for (scene, camera) in scenes().iter().flat_map(|s| cameras().map(|c| (s, c))) {
            let mut options = Options::new(83, 71);
            options.isa = Some(isa);
            options.settings.closed_forms = false;
            let with = render(scene, &camera, &options).unwrap();
            options.settings.beams = false;
            let without = render(scene, &camera, &options).unwrap();
            for (x, y) in (0..83).flat_map(|x| (0..71).map(move |y| (x, y))) {
                let (p, q) = (with.pixel(x, y), without.pixel(x, y));
                assert_eq!(p.surface, q.surface, "{isa}, ({x}, {y}), {camera:?}");
                let (p, q) = (p.answer, q.answer);
                match (p.first, q.first) {
                    (Verdict::Root { t: s }, Verdict::Root { t }) => {
                        assert_eq!(p.entry, q.entry);
                        assert!(s.lo <= t.hi && t.lo <= s.hi, "{p:?}, {q:?}");
                        hits += 1;
                    }
                    (one, other) => assert_eq!(one, other, "{isa}, ({x}, {y}), {camera:?}"),
                }
            }
            let (with, without) = (with.statistics(), without.statistics());
            assert_eq!(with.rays, without.rays);
            assert_eq!((without.made, without.evaluations.beams), (without.rays, 0));
            assert!(with.evaluations.beams > 0);
            spared += with.rays - with.made;
            single += with.evaluations.single;
        }
        println!("{isa}: {hits} hits, {spared} rays spared, {single} rays not searched");
        assert!(hits > 10_000 && spared > 10_000 && single > 10_000);
    }
}

#[test]
fn certain_areas_bound_the_disc_of_a_ball() {
    let (radius, size): (f64, u32) = (1.0, 400);
    let degrees: f64 = 40.0;
    let oblique =
        Camera::orthographic(DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO, DVec3::Y, 3.0).unwrap();
    // A perspective view shows it as large as where its tangents from the eye meet the picture.
    let apparent = radius / (16.0 - radius * radius).sqrt() / (0.5 * degrees).to_radians().tan();
    for isa in Isa::available() {
        for (camera, radius) in [(camera(), apparent), (oblique, radius / 1.5)] {
            let mut options = Options::new(size, size);
            options.isa = Some(isa);
            for sampling in [Sampling::Centre, Sampling::Corner] {
                options.sampling = sampling;
                let picture = render(&Scene::new().with(ball(1.0)), &camera, &options).unwrap();
                let area = picture.statistics().area;
                let disc = std::f64::consts::PI * (0.5 * radius * f64::from(size)).powi(2);
                let most = area.hit + area.undecided;
                assert!(
                    area.hit as f64 <= disc && disc <= most as f64,
                    "{disc}: {area:?}"
                );
                let all = u64::from(size * size);
                assert_eq!(most + area.miss, all);
                assert!(10 * area.undecided < all, "{area:?}");
            }
            options.settings.beams = false;
            let picture = render(&Scene::new().with(ball(1.0)), &camera, &options).unwrap();
            assert_eq!(picture.statistics().area.undecided, u64::from(size * size));
        }
    }
}

#[test]
fn a_box_that_cuts_leaves_its_edges_open() {
    // The ball is larger than its box: rays through the box's outline may leave it before they meet the ball.
    let cut = Ball {
        radius: 1.5,
        half: 1.0,
    };
    let front = Camera::orthographic(DVec3::Z * 4.0, DVec3::ZERO, DVec3::Y, 4.0).unwrap();
    let picture = render(&Scene::new().with(cut), &front, &Options::new(160, 160)).unwrap();
    let s = picture.statistics();
    // Half the picture's height and width is the box, and the ball fills it but for its edges and corners.
    assert!(
        s.area.hit <= 80 * 80 && s.area.miss <= 160 * 160 - s.root,
        "{s}"
    );
    assert!(s.area.undecided < 160 * 160 / 4, "{s}");
}

#[test]
fn an_empty_scene_is_all_background() {
    let picture = render(&Scene::new(), &camera(), &Options::new(5, 3)).unwrap();
    let s = picture.statistics();
    assert_eq!((s.miss, s.made, s.area.miss), (15, 0, 15));
    let image = picture.image(&Shading::default());
    assert_eq!(image.dimensions(), (5, 3));
    assert!(image.pixels().all(|p| p == image.get_pixel(0, 0)));
    assert_eq!(picture.verdict_image().get_pixel(0, 0).0, [255, 255, 255]);
}

#[test]
fn progress_counts_every_block_once() {
    let calls = AtomicUsize::new(0);
    let last = AtomicUsize::new(0);
    let note = |p: Progress| {
        calls.fetch_add(1, Ordering::Relaxed);
        last.fetch_max(p.done, Ordering::Relaxed);
        assert_eq!(p.of, 6);
    };
    let mut options = Options::new(140, 90);
    options.progress = Some(&note);
    render(&Scene::new().with(ball(1.0)), &camera(), &options).unwrap();
    assert_eq!((calls.into_inner(), last.into_inner()), (6, 6));
}

#[test]
fn a_surface_without_a_domain_takes_the_scene_s_box() {
    let mut blobs = Blobs::some(1);
    let size = Options::new(16, 16);
    let own = render(&Scene::new().with(blobs.clone()), &camera(), &size).unwrap();
    blobs.domain = None;
    let scene = Scene::new().with(blobs.clone()).within([-2.0; 3], [2.0; 3]);
    let given = render(&scene, &camera(), &size).unwrap();
    assert!(own.statistics().root > 10);
    assert_eq!(own.statistics().evaluations, given.statistics().evaluations);
    let error = render(&Scene::new().with(blobs), &camera(), &size)
        .err()
        .expect("there is no box");
    let message = error.to_string();
    assert!(
        message.contains("#[domain(") && message.contains("Scene::within"),
        "{message}"
    );
}

#[test]
fn what_cannot_be_rendered_is_refused_with_advice() {
    let refuse = |scene: Scene, options: Options| {
        render(&scene, &camera(), &options).err().expect("an error")
    };
    let error = refuse(Scene::new(), Options::new(0, 5));
    assert!(
        matches!(error, RenderError::BadSize { .. })
            && error.to_string().contains("from 1 to 65536")
    );
    let bad = Ball {
        radius: 1.0,
        half: -1.0,
    };
    let error = refuse(Scene::new().with(bad), Options::new(5, 5));
    assert!(
        matches!(error, RenderError::Scene(SceneError::BadBox { of: "ball" })),
        "{error}"
    );
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::ZERO,
    };
    let error =
        all_roots(&Scene::new().with(ball(1.0)), &ray, &Options::new(1, 1)).expect_err("an error");
    assert!(matches!(error, RenderError::BadRay), "{error}");
}

#[test]
fn all_roots_of_a_ball() {
    let ray = Ray {
        origin: DVec3::new(-3.0, 0.0, 0.0),
        direction: DVec3::new(2.0, 0.0, 0.0),
    };
    for closed_forms in [true, false] {
        let mut options = Options::new(1, 1);
        options.settings.closed_forms = closed_forms;
        let lists = all_roots(&Scene::new().with(ball(1.0)), &ray, &options).unwrap();
        let (entry, events) = &lists[0];
        // A little before the box, so that a root on its face is inside.
        assert!(*entry <= 0.5 && *entry > 0.5 - 3e-13, "{entry}");
        // t is in units of the direction as given, from the entry.
        let expected = [1.0 - entry, 2.0 - entry];
        assert_eq!(events.len(), 2, "{events:?}");
        for (event, x) in events.iter().zip(expected) {
            assert!(
                matches!(event, Verdict::Root { t } if t.contains(x) && t.width() < 1e-13),
                "{event:?}"
            );
        }
    }
}
