//! What is drawn are the bodies of the models: the energies of the drawing are those of the model.

use lagrangian_exhibits::scene::{Body, Scene};
use lagrangian_exhibits::{Exhibit, Motion, Values, exhibits};

/// Random numbers between −1 and 1 (S. Vigna, `SplitMix64`, 2015).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        f64::from(u32::try_from(z >> 32).unwrap_or_default()) / f64::from(u32::MAX) * 2.0 - 1.0
    }
}

/// A state near the start of a motion: time, coordinates, velocities.
fn state(motion: &dyn Motion, random: &mut Random) -> (f64, Vec<f64>, Vec<f64>) {
    let state = motion.state();
    let (q, v) = state.split_at(state.len() / 2);
    let q = q.iter().map(|q| q + 0.4 * random.next()).collect();
    (
        random.next(),
        q,
        v.iter().map(|_| 2.0 * random.next()).collect(),
    )
}

/// The scene at a time before or after a state, along its velocity.
fn scene(motion: &dyn Motion, (t, q, v): &(f64, Vec<f64>, Vec<f64>), later: f64) -> Scene {
    let q: Vec<_> = q.iter().zip(v).map(|(q, v)| q + later * v).collect();
    motion
        .evaluate(t + later, &q, v)
        .expect("the number of coordinates")
        .scene
}

/// The kinetic energy of what is drawn: from differences of fourth order of the places and axes of its bodies.
fn kinetic_energy(motion: &dyn Motion, state: &(f64, Vec<f64>, Vec<f64>)) -> f64 {
    const H: f64 = 5e-5;
    let scenes = [-2.0, -1.0, 1.0, 2.0].map(|k| scene(motion, state, k * H));
    let here = scene(motion, state, 0.0);
    let mut sum = 0.0;
    for (index, body) in here.bodies.iter().enumerate() {
        let at = scenes.each_ref().map(|scene| &scene.bodies[index]);
        let velocity = difference(&at.map(Body::center_of_gravity), H);
        // Ω = Rᵀ Ṙ.
        let spin = body.axes.transpose() * difference(&at.map(|body| body.axes), H);
        let omega = [
            spin[(2, 1)] - spin[(1, 2)],
            spin[(0, 2)] - spin[(2, 0)],
            spin[(1, 0)] - spin[(0, 1)],
        ];
        let turning = body.axes.transpose() * here.turning;
        let omega = turning.map_with_location(|i, _, x| x + 0.5 * omega[i]);
        sum += 0.5 * body.mass * velocity.norm_squared() + 0.5 * omega.dot(&(body.inertia * omega));
    }
    sum
}

fn difference<T>(at: &[T; 4], h: f64) -> T
where
    T: Copy + std::ops::Sub<Output = T> + std::ops::Mul<f64, Output = T>,
{
    ((at[2] - at[1]) * 8.0 - (at[3] - at[0])) * (1.0 / (12.0 * h))
}

fn each(mut check: impl FnMut(&dyn Exhibit, &dyn Motion, &(f64, Vec<f64>, Vec<f64>))) {
    for exhibit in exhibits() {
        let motion = exhibit.begin(&[]).expect("the exhibit opens");
        let mut random = Random(1);
        for _ in 0..20 {
            let state = state(motion.as_ref(), &mut random);
            check(exhibit, motion.as_ref(), &state);
        }
    }
}

#[test]
fn the_kinetic_energy_of_the_drawing_is_that_of_the_model() {
    each(|exhibit, motion, state| {
        let model = motion
            .evaluate(state.0, &state.1, &state.2)
            .expect("the number of coordinates");
        let drawn = kinetic_energy(motion, state);
        let error = (drawn - model.kinetic).abs();
        assert!(
            error < 1e-8 * model.kinetic.abs(),
            "{}: {drawn} is not {}",
            exhibit.about().slug,
            model.kinetic
        );
    });
}

/// At rest: a potential that contains velocities, that of the Coriolis force, has no picture.
#[test]
fn the_height_of_the_drawing_is_the_potential_energy_of_the_model() {
    each(|exhibit, motion, (t, q, v)| {
        let rest = vec![0.0; v.len()];
        let model = motion
            .evaluate(*t, q, &rest)
            .expect("the number of coordinates");
        let values = Values::new(exhibit.about(), &[]);
        let has_gravity = exhibit
            .about()
            .quantities
            .iter()
            .any(|quantity| quantity.name == "gravity");
        let g = if has_gravity {
            values.get("gravity")
        } else {
            0.0
        };
        let weights = model
            .scene
            .bodies
            .iter()
            .map(|body| body.mass * g * body.center_of_gravity().z);
        let (drawn, size) = weights.fold((0.0, 0.0), |(sum, size), weight| {
            (sum + weight, size + weight.abs())
        });
        let error = (drawn - model.potential).abs();
        assert!(
            error <= 1e-13 * size,
            "{}: {drawn} is not {}",
            exhibit.about().slug,
            model.potential
        );
    });
}

/// Rods and ropes end at bodies.
#[test]
fn each_rod_ends_at_a_body() {
    each(|exhibit, motion, state| {
        let scene = scene(motion, state, 0.0);
        for line in scene
            .lines
            .iter()
            .filter(|line| line.tone == lagrangian_exhibits::scene::Tone::Frame)
        {
            let ends_there = |body: &Body| {
                line.ends
                    .iter()
                    .any(|end| (end - body.origin).norm() < 1e-12)
            };
            assert!(
                scene.bodies.iter().any(ends_there),
                "{}: a rod ends nowhere",
                exhibit.about().slug
            );
        }
    });
}

#[test]
fn names_are_unique() {
    for exhibit in exhibits() {
        let about = exhibit.about();
        for (index, quantity) in about.quantities.iter().enumerate() {
            assert!(
                about.quantities[..index]
                    .iter()
                    .all(|other| other.name != quantity.name),
                "{}",
                quantity.name
            );
            assert!(
                (quantity.range[0]..=quantity.range[1]).contains(&quantity.value),
                "{}: {}",
                about.slug,
                quantity.name
            );
        }
        assert_eq!(
            exhibits()
                .iter()
                .filter(|other| other.about().slug == about.slug)
                .count(),
            1
        );
        let motion = exhibit.begin(&[]).expect("the exhibit opens");
        assert_eq!(motion.curves().len(), about.curves.len());
        assert!(
            motion.curves().iter().all(|value| value.is_finite()),
            "{}",
            about.slug
        );
    }
}

/// A value that is no number is refused with a sentence, whichever slider it is of.
#[test]
fn what_is_no_number_is_refused() {
    for exhibit in exhibits() {
        let about = exhibit.about();
        for (index, quantity) in about.quantities.iter().enumerate() {
            if quantity.is_switch() {
                continue;
            }
            let mut values: Vec<_> = about
                .quantities
                .iter()
                .map(|quantity| quantity.value)
                .collect();
            values[index] = f64::NAN;
            let begun = exhibit.begin(&values).and_then(|mut motion| motion.step());
            assert!(
                begun.is_err(),
                "{}: {} may be NaN",
                about.slug,
                quantity.name
            );
        }
    }
}

/// Masses that are not positive are refused.
#[test]
fn a_mass_is_positive() {
    for exhibit in exhibits() {
        let about = exhibit.about();
        for (index, _) in about
            .quantities
            .iter()
            .enumerate()
            .filter(|(_, quantity)| quantity.unit == "kg")
        {
            for mass in [0.0, -1.0] {
                let mut values: Vec<_> = about
                    .quantities
                    .iter()
                    .map(|quantity| quantity.value)
                    .collect();
                values[index] = mass;
                let begun = exhibit.begin(&values).and_then(|mut motion| motion.step());
                let error = begun.err().map(|error| error.to_string());
                assert!(error.is_some(), "{}: a mass of {mass}", about.slug);
            }
        }
    }
}
