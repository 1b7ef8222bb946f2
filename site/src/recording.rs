//! The motion of an exhibit as the gallery shows it.

use lagrangian_exhibits::scene::Scene;
use lagrangian_exhibits::{Exhibit, Refusal, Trails, exhibits};

/// The motion that begins with the values with which an exhibit opens.
#[derive(Debug)]
pub struct Recording {
    /// The times, and for each the values of the curves.
    pub samples: Vec<(f64, Vec<f64>)>,
    /// The drawing at the end of the part that the gallery draws.
    pub scene: Scene,
    /// The paths up to there.
    pub trails: Trails,
    /// How far the balance of the energy is missed at the end, relative to the largest kinetic energy.
    pub energy_error: f64,
    /// How many steps the integration took.
    pub steps: u32,
}

/// How many samples a recording has.
const SAMPLES: u32 = 600;

/// How much of the motion is in the drawing, and how many samples its paths have.
const DRAWN: f64 = 0.2;
const TRAIL: usize = 110;

/// Integrates the motions of all exhibits, in the order of [`exhibits`], each in a thread of its own.
///
/// # Errors
///
/// Any error of a model or its integration.
pub fn recordings() -> Result<Vec<Recording>, Refusal> {
    std::thread::scope(|scope| {
        let record = |exhibit| move || recorded(exhibit).map_err(|error| error.to_string());
        let threads = exhibits().map(|exhibit| scope.spawn(record(exhibit)));
        let ends = threads.into_iter().map(|thread| match thread.join() {
            Ok(recording) => Ok(recording?),
            Err(_) => Err("a motion ended in a panic".into()),
        });
        ends.collect()
    })
}

/// Integrates the motion of an exhibit.
fn recorded(exhibit: &dyn Exhibit) -> Result<Recording, Refusal> {
    let about = exhibit.about();
    let mut motion = exhibit.begin(&[])?;
    let mut trails = Trails::new(TRAIL);
    let mut scene = motion.scene();
    let (mut samples, mut steps) = (Vec::new(), 0);
    for index in 0..=SAMPLES {
        let t = about.seconds * f64::from(index) / f64::from(SAMPLES);
        while motion.reached() < t {
            motion.step()?;
            steps += 1;
        }
        motion.show(t)?;
        samples.push((t, motion.curves()));
        if t <= DRAWN * about.seconds {
            scene = motion.scene();
            trails.add(&scene);
        }
    }
    Ok(Recording {
        samples,
        scene,
        trails,
        energy_error: motion.energy_error(),
        steps,
    })
}
