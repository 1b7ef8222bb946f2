//! Two lists of events of one problem, one setting each, are watched as one list of both.

use lagrangian::prelude::*;

/// An oscillator beside a pendulum, and a place that it passes shortly before and behind a turning point.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * m0 * dot(x).powi(2) + 0.5 * m1 * dot(y).powi(2),
    potential = 0.5 * k0 * x.powi(2) + k1 * (1.0 - cos(y)),
    event(near = x - place, turning = dot(x)),
)]
struct Oscillator {
    m0: f64,
    k0: f64,
    m1: f64,
    k1: f64,
    place: f64,
}

/// A list has found the second passage where a reaction to an event of the other list comes before it: at the end of a run, too,
/// the passage is still to be reported.
#[test]
fn what_a_list_has_found_behind_a_reaction_is_found_again() {
    let model = Oscillator {
        m0: 1.1,
        k0: 0.805_763_660_088_262_2,
        m1: 1.4,
        k1: 0.837_230_991_229_557_1,
        place: -1.115_037_523_138_557,
    };
    let start = State::new(
        -1.260_924_284_203_903_7,
        [0.224_297_075_407_625_9, -0.821_161_918_277_929_7],
        [-0.934_850_002_226_406_1, -1.735_110_548_481_986_2],
    );
    let passage = 0.820_327_005_510_986_f64;
    for roundings in [-400, 0, 1, 2, 20, 400] {
        let end = f64::from_bits(passage.to_bits().wrapping_add_signed(roundings));
        let (mut seen, mut last) = (Vec::new(), start);
        for end in [end, 1.0] {
            let motion = Problem::new(&model, last)
                .on(Oscillator::NEAR)
                .then_with(|_, _| ())
                .on(Oscillator::TURNING)
                .rising()
                .then_with(|_, _| ());
            let motion = motion.solve(end, Taylor::new()).unwrap();
            seen.extend(motion.events().iter().map(|event| event.event));
            last = motion.last;
        }
        assert_eq!(seen, [0, 1, 0], "{roundings}");
    }
}
