//! The reduced symmetric top, against closed forms and the full one.

use lagrangian::prelude::*;
use lagrangian::{OperationCount, StopReason};
use lagrangian_tests::{Random, assert_close, relative_error};

use crate::models::{ReducedTop, Top, TopThroughPoles, polar_top, top};

/// (4.7) to (4.10), by hand.
#[test]
fn the_reduced_top_is_that_of_the_book() {
    let top = top();
    let Top { i, i_s, m, g, l } = top;
    let mut random = Random::default();
    for _ in 0..100 {
        let [theta, rate, precession, spin] = random.array(0.2, 2.8);
        let state = State::new(0.0, [0.4, theta, -1.0], [precession, rate, 10.0 * spin]);
        let (reduced, start) = top.reduce(&state);
        let (s, c) = theta.sin_cos();
        let (p_phi, p_psi) = (reduced.p_phi, reduced.p_psi);
        assert_close(
            "C_ψ",
            &[p_psi],
            &[i_s * (10.0 * spin + precession * c)],
            1e-14,
        );
        assert_close(
            "C_φ",
            &[p_phi],
            &[i * precession * s * s + p_psi * c],
            1e-13,
        );
        let potential = m * g * l * c
            + p_psi * p_psi / (2.0 * i_s)
            + (p_phi - p_psi * c).powi(2) / (2.0 * i * s * s);
        assert_close(
            "V_eff",
            &[reduced.effective_potential(&start)],
            &[potential],
            1e-12,
        );
        let energy = 0.5 * i * rate * rate + potential;
        assert_close("E", &[reduced.energy(&start)], &[energy], 1e-12);
        assert_close(
            "R",
            &[reduced.routhian(&start)],
            &[potential - 0.5 * i * rate * rate],
            1e-12,
        );
        assert_close(
            "T",
            &[reduced.kinetic_energy(&start)],
            &[0.5 * i * rate * rate],
            1e-13,
        );
        let slope = -m * g * l * s + (p_phi - p_psi * c) * (p_psi - p_phi * c) / (i * s.powi(3));
        assert_close(
            "θ̈",
            &[reduced.accelerations(&start)[0]],
            &[-slope / i],
            1e-12,
        );
        let phi = (p_phi - p_psi * c) / (i * s * s);
        let rates = [phi, p_psi / i_s - phi * c];
        assert_close(
            "φ̇, ψ̇",
            reduced.ignorable_velocities(&start).as_slice(),
            &rates,
            1e-12,
        );
    }
}

/// In additions, with divisions as five and a sine and cosine as twelve of them.
fn cost(count: OperationCount) -> usize {
    assert_eq!((count.square_roots, count.functions), (0, 0));
    count.additions + count.multiplications + 5 * count.divisions + 12 * count.sines_and_cosines
}

#[test]
fn the_reduced_top_costs_little() {
    let reduced = ReducedTop::OPERATIONS.accelerations;
    assert!(reduced.total() <= 11 && cost(reduced) <= 26, "{reduced:?}");
    let through_poles = TopThroughPoles::OPERATIONS.accelerations;
    assert!(
        through_poles.total() <= 14 && cost(through_poles) <= 33,
        "{through_poles:?}"
    );
    let full = Top::OPERATIONS.accelerations;
    assert!(full.total() >= 19 && cost(full) >= 34, "{full:?}");
}

/// θ of the full and the reduced top over a hundred nutations, and φ and ψ from the reduced one.
#[test]
fn a_hundred_nutations_are_reconstructed() {
    let top = top();
    let start = State::new(0.0, [0.3, 0.5, 0.1], [0.2, 0.3, 40.0]);
    let (reduced, reduced_start) = top.reduce(&start);
    // The frequency of the nutation is somewhat less than Iₛ ω₃/I = 10.
    let end = 115.0 * core::f64::consts::TAU / (0.1 * 40.0 / 0.4);
    let method = Taylor::new();
    let times: Vec<f64> = (1..=400).map(|k| end * f64::from(k) / 400.0).collect();
    let full = Problem::new(&top, start).save(&times).solve(end, method);
    let full = full.unwrap();
    let equations = reduced.reconstruction();
    let problem = Problem::new(&equations, At::from((reduced_start, [0.3, 0.1])));
    let motion = problem.clone().save(&times).solve(end, method).unwrap();
    let mut nutations = 0;
    let mut before = 0.0;
    for (full, sample) in full.samples().iter().zip(motion.samples()) {
        let state = equations.full_state(sample);
        assert!((state.q - full.q).amax() < 1e-10, "{} {}", state.q, full.q);
        assert!((state.v - full.v).amax() < 1e-9, "{} {}", state.v, full.v);
        nutations += usize::from(before < 0.0 && full.v[1] >= 0.0);
        before = full.v[1];
    }
    assert!(nutations >= 99, "{nutations}");
    // Dense output of Runge and Kutta's kind, too.
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let solution = problem.save(Dense).solve(5.0, method).unwrap();
    for t in [0.123, 1.7, 4.999] {
        let sample: State<f64, 1, SVector<f64, 2>> = solution.at(t).unwrap();
        let expected = Problem::new(&top, start).solve(t, method).unwrap();
        let state = equations.full_state(&sample);
        assert!((state.q - expected.q).amax() < 1e-9, "{t}");
    }
}

/// The sleeping top at θ = 0 itself, and near it with all digits: `V_eff` = const + (C²/(8 I) − m g l/2) θ² + ….
#[test]
fn the_sleeping_top_is_evaluated_where_it_sleeps() {
    let top = polar_top();
    let (i, i_s, weight) = (top.i, top.i_s, top.m * top.g * top.l);
    let spin = 30.0;
    for pole in [0.0, core::f64::consts::PI] {
        let state = State::new(0.0, [0.0, pole, 0.0], [0.0, 0.0, spin]);
        let (mut reduced, start) = top.reduce(&state);
        let up = pole.cos();
        reduced.p_phi = up * reduced.p_psi;
        let constant = i_s * spin;
        assert_close("C_ψ", &[reduced.p_psi], &[constant], 1e-15);
        let potential = constant.powi(2) / (2.0 * i_s) + up * weight;
        assert_close(
            "V_eff",
            &[reduced.effective_potential(&start)],
            &[potential],
            1e-14,
        );
        let stiffness = constant.powi(2) / (4.0 * i) - up * weight;
        let found = -reduced.linearize(&start).position[(0, 0)];
        assert_close("V_eff″", &[i * found], &[stiffness], 1e-12);
        assert!(reduced.accelerations(&start)[0].abs() < 1e-14 * stiffness);
        assert!(reduced.forcing(&start)[0].abs() < 1e-14 * stiffness);
        let rates = reduced.ignorable_velocities(&start);
        // Of the sum, or the difference, of the angles the velocity is that of the spin.
        assert_close("ψ̇ ± φ̇", &[rates[1] + up * rates[0]], &[spin], 1e-13);
        let end = Problem::new(&reduced, start).solve(3.0, Taylor::new());
        let end = end.unwrap();
        assert!((end.q[0] - pole).abs() < 1e-12);
    }
    // Nearby, a motion through the pole keeps its energy, and is that of x and y.
    let state = State::new(0.0, [0.0, 0.0, 0.0], [0.0, 0.4, spin]);
    let (reduced, start) = top.reduce(&state);
    assert!(reduced.p_phi.to_bits() == reduced.p_psi.to_bits());
    for theta in [1e-3, 1e-6, 1e-9, 1e-12_f64] {
        let near = State::new(0.0, [theta], [0.0]);
        let slope = (reduced.p_psi.powi(2) / (4.0 * i) - weight) * theta;
        let expected = -slope / i;
        let error = relative_error(&[reduced.accelerations(&near)[0]], &[expected], 1e-300);
        assert!(error < theta * theta + 1e-14, "{theta}: {error}");
    }
    let end = Problem::new(&reduced, start).solve(5.0, Taylor::new());
    let end = end.unwrap();
    assert_close(
        "energy",
        &[reduced.energy(&end)],
        &[reduced.energy(&start)],
        1e-13,
    );
    // With other constants there is a pole.
    let (mut reduced, start) = top.reduce(&state);
    reduced.p_phi += 1e-3;
    assert!(!reduced.accelerations(&start)[0].is_finite());
    assert!(!reduced.effective_potential(&start).is_finite());
}

/// The same top in fewer operations has no value there, and says so where an integration begins.
#[test]
fn the_pole_of_the_shorter_form_is_reported() {
    let asleep = State::new(0.0, [0.0; 3], [0.0, 0.0, 30.0]);
    let (reduced, start) = top().reduce(&asleep);
    assert_eq!(<ReducedTop as GeneralizedCoordinates<1>>::POLES, [0]);
    assert!(<TopThroughPoles as GeneralizedCoordinates<1>>::POLES.is_empty());
    let message = "at t = 0 the reduced model has no accelerations at the pole theta = 0 of its angles: write \
                   `routhian(Name, half_angles)`";
    let problem = Problem::new(&reduced, start);
    let partials = [
        problem.clone().solve(1.0, Taylor::new()).unwrap_err(),
        problem.solve(1.0, Dop853::new()).unwrap_err(),
    ];
    for partial in partials {
        let error = partial.error();
        let IntegrationError::SingularConfiguration { singularity, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(singularity.coordinate(), "theta");
        assert!(error.to_string().contains(message), "{error}");
    }
    let there = At::from((start, [0.0; 2]));
    let found = Problem::new(reduced.reconstruction(), there).solve(1.0, Taylor::new());
    assert!(found.unwrap_err().to_string().contains(message));
    // Another value that is not finite is not put down to the pole.
    let lost = State::new(0.0, [1.0], [f64::NAN]);
    let error = Problem::new(&reduced, lost).solve(1.0, Dop853::new());
    assert!(!error.unwrap_err().to_string().contains("pole"));
}

/// Every method keeps its digits near the pole where the constant momenta nearly agree.
#[test]
fn all_methods_keep_their_digits_near_the_pole() {
    let Top { i, i_s, m, g, l } = top();
    let weight = m * g * l;
    let p_psi = 3.0;
    for theta in [1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-12_f64] {
        let p_phi = p_psi - theta;
        let top = TopThroughPoles {
            i,
            i_s,
            m,
            g,
            l,
            p_phi,
            p_psi,
        };
        let (s, c) = (0.5 * theta).sin_cos();
        let [lesser, greater] = [p_phi - p_psi, p_phi + p_psi].map(|x| x * x / (8.0 * i));
        let potential = lesser / (s * s) + greater / (c * c)
            - p_psi * p_psi * (0.5 / i - 0.5 / i_s)
            + weight * theta.cos();
        let force = lesser * c / s.powi(3) - greater * s / c.powi(3) + weight * theta.sin();
        let slope = -0.5 * lesser * (s * s + 3.0 * c * c) / s.powi(4)
            - 0.5 * greater * (c * c + 3.0 * s * s) / c.powi(4)
            + weight * theta.cos();
        let state = State::new(0.0, [theta], [0.0]);
        assert_close(
            "V_eff",
            &[top.effective_potential(&state)],
            &[potential],
            1e-14,
        );
        assert_close("h", &[top.energy(&state)], &[potential], 1e-14);
        assert_close("L", &[top.lagrangian(&state)], &[-potential], 1e-14);
        assert_close("f", &[top.forcing(&state)[0]], &[force], 1e-13);
        let slopes = top.linearize(&state).position;
        assert_close("∂q̈/∂θ", &[slopes[(0, 0)]], &[slope / i], 1e-13);
    }
}

/// A motion that passes near the pole with nearly equal constants turns φ and ψ quickly there, and is followed by both methods.
#[test]
fn a_motion_near_the_pole_is_reconstructed() {
    let Top { i, i_s, m, g, l } = top();
    let reduced = TopThroughPoles {
        i,
        i_s,
        m,
        g,
        l,
        p_phi: 1.0,
        p_psi: 1.0 - 1e-6,
    };
    let start = At::from((State::new(0.0, [0.3], [-1.0]), [0.0; 2]));
    let problem = Problem::new(reduced.reconstruction(), start);
    let by_series = problem.clone().max_steps(200).solve(2.0, Taylor::new());
    let by_stages = problem.max_steps(400).solve(2.0, Dop853::new());
    let [found, expected] = [by_series, by_stages].map(|motion| {
        let motion = motion.unwrap();
        assert_eq!(motion.reason, StopReason::Completed);
        motion.last.x
    });
    assert_close("q", found.q.as_slice(), expected.q.as_slice(), 1e-9);
    let [found, expected] = [found, expected].map(|x| <[f64; 2]>::from(x.z));
    assert_close("φ and ψ", &found, &expected, 1e-9);
    // Half a turn within a millionth of a second.
    assert!(found[0] > 3.0, "{found:?}");
}
