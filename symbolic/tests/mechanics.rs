//! Lagrange's equations against closed forms, and the facts that are derived about their structure.

use lagrangian_symbolic::{
    Binary, Defect, Energies, Equations, Expression, Fault, Graph, Model, Point, Program, Rational,
    Symbol, Unary,
};

/// A model under construction: the graph, and shorthands that read as formulas.
struct Draft {
    graph: Graph,
    coordinates: u32,
}

impl Draft {
    fn new(coordinates: u32) -> Self {
        Self {
            graph: Graph::new(),
            coordinates,
        }
    }

    fn q(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Coordinate(i))
    }

    fn v(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Velocity(i))
    }

    fn parameter(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Parameter(i))
    }

    fn sin(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Sin, x)
    }

    fn cos(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Cos, x)
    }

    fn times(&mut self, factors: &[Expression]) -> Expression {
        self.graph
            .product(factors.iter().map(|x| (*x, Rational::ONE)))
    }

    fn plus(&mut self, terms: &[Expression]) -> Expression {
        self.graph.sum(terms.iter().map(|x| (*x, Rational::ONE)))
    }

    fn half(&mut self, x: Expression) -> Expression {
        self.graph.scale(x, &Rational::HALF)
    }

    fn square(&mut self, x: Expression) -> Expression {
        self.graph.square(x)
    }

    fn dot(&mut self, x: Expression) -> Expression {
        self.graph.time_derivatives(&[x], self.coordinates)[0]
    }

    fn model(self, energies: Energies) -> Model {
        let zero = self.graph.zero();
        Model {
            coordinates: self.coordinates,
            inputs: 1,
            energies,
            dissipation: zero,
            forces: vec![zero; self.coordinates as usize],
            outputs: Vec::new(),
            graph: self.graph,
        }
    }

    fn natural(self, kinetic: Expression, potential: Expression) -> Model {
        self.model(Energies::Natural { kinetic, potential })
    }
}

/// Values for a few symbols, the same on every run.
fn value(symbol: Symbol) -> f64 {
    match symbol {
        Symbol::Time => 0.3,
        Symbol::Coordinate(i) => 0.7 + 0.4 * f64::from(i),
        Symbol::Velocity(i) => 1.1 - 0.6 * f64::from(i),
        Symbol::Acceleration(i) => -0.5 + 0.9 * f64::from(i),
        Symbol::Parameter(i) => 1.3 + 0.5 * f64::from(i),
        Symbol::Input(_) | Symbol::Prepared(_) => 0.2,
    }
}

#[track_caller]
fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error < 1e-13, "{found} is not {expected}: {error:e}");
}

/// A pendulum on a pivot that moves up and down as a sin(w t), from positions: parameters m, l, g, a, w.
fn driven_pendulum() -> Model {
    let mut draft = Draft::new(1);
    let [m, l, g, a, w] = core::array::from_fn(|i| draft.parameter(u32::try_from(i).unwrap()));
    let t = draft.graph.symbol(Symbol::Time);
    let q = draft.q(0);
    let (sin, cos) = (draft.sin(q), draft.cos(q));
    let x = draft.times(&[l, sin]);
    let phase = draft.times(&[w, t]);
    let sin_phase = draft.sin(phase);
    let pivot = draft.times(&[a, sin_phase]);
    let drop = draft.times(&[l, cos]);
    let y = draft.graph.subtract(pivot, drop);
    let (vx, vy) = (draft.dot(x), draft.dot(y));
    let (vx2, vy2) = (draft.square(vx), draft.square(vy));
    let speed = draft.plus(&[vx2, vy2]);
    let twice = draft.times(&[m, speed]);
    let kinetic = draft.half(twice);
    let potential = draft.times(&[m, g, y]);
    draft.natural(kinetic, potential)
}

#[test]
fn explicit_time_enters_the_forcing() {
    let mut model = driven_pendulum();
    let equations = Equations::derive(&mut model).unwrap();
    let (m, l, g, a, w) = (1.3, 1.8, 2.3, 2.8, 3.3);
    let (t, q, v) = (0.3_f64, 0.7_f64, 1.1_f64);
    let found = model
        .graph
        .evaluate(&[equations.mass[0][0], equations.forcing[0]], value);
    assert_close(found[0], m * l * l);
    // m l² q̈ = −m l (g + ÿ₀) sin q with the pivot's acceleration ÿ₀ = −a w² sin(w t).
    assert_close(found[1], -m * l * (g - a * w * w * (w * t).sin()) * q.sin());
    // h = p q̇ − L, which here is not T + V.
    let (vx, vy) = (l * q.cos() * v, a * w * (w * t).cos() + l * q.sin() * v);
    let momentum = m * l * (q.cos() * vx + q.sin() * vy);
    let height = a * (w * t).sin() - l * q.cos();
    let energy = momentum * v - (0.5 * m * (vx * vx + vy * vy) - m * g * height);
    assert_close(model.graph.evaluate(&[equations.energy], value)[0], energy);
}

/// The free rigid body of (4.5): parameters I₁, I₂, I₃; coordinates φ, θ, ψ.
fn rigid_body() -> (Model, [Expression; 3]) {
    let mut draft = Draft::new(3);
    let inertia: [_; 3] = core::array::from_fn(|i| draft.parameter(u32::try_from(i).unwrap()));
    let (theta, psi) = (draft.q(1), draft.q(2));
    let (vphi, vtheta, vpsi) = (draft.v(0), draft.v(1), draft.v(2));
    let [(st, ct), (sp, cp)] = [theta, psi].map(|x| (draft.sin(x), draft.cos(x)));
    let (a, b) = (draft.times(&[vphi, st, sp]), draft.times(&[vtheta, cp]));
    let w1 = draft.plus(&[a, b]);
    let (a, b) = (draft.times(&[vphi, st, cp]), draft.times(&[vtheta, sp]));
    let w2 = draft.graph.subtract(a, b);
    let a = draft.times(&[vphi, ct]);
    let w3 = draft.plus(&[a, vpsi]);
    let w = [w1, w2, w3];
    let terms: Vec<_> = inertia
        .into_iter()
        .zip(w)
        .map(|(i, w)| {
            let square = draft.square(w);
            draft.times(&[i, square])
        })
        .collect();
    let twice = draft.plus(&terms);
    let kinetic = draft.half(twice);
    let zero = draft.graph.zero();
    (draft.natural(kinetic, zero), w)
}

#[test]
fn lagranges_equations_of_a_rigid_body_are_eulers() {
    let (mut model, w) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let rates = model.graph.time_derivatives(&w, 3);
    let found = model.graph.evaluate(&equations.inverse_dynamics, value);
    let w = model.graph.evaluate(&w, value);
    let rate = model.graph.evaluate(&rates, value);
    let i = [1.3, 1.8, 2.3];
    // Q = Eᵀ N with N of (3.5)-(3.7), for any accelerations.
    let n: Vec<f64> = (0..3)
        .map(|k| {
            let (k1, k2) = ((k + 1) % 3, (k + 2) % 3);
            i[k] * rate[k] - (i[k1] - i[k2]) * w[k1] * w[k2]
        })
        .collect();
    let (theta, psi) = (1.1_f64, 1.5_f64);
    let (st, ct) = theta.sin_cos();
    let (sp, cp) = psi.sin_cos();
    assert_close(found[0], (n[0] * sp + n[1] * cp) * st + n[2] * ct);
    assert_close(found[1], n[0] * cp - n[1] * sp);
    assert_close(found[2], n[2]);
}

#[test]
fn euler_angles_are_singular_where_theta_says_so() {
    let (mut model, _) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    // det M = I₁ I₂ I₃ sin²θ: neither φ nor ψ matters, though M contains ψ.
    assert_eq!(equations.structure.singularities, vec![vec![1]; 3]);
    // φ occurs nowhere.
    assert_eq!(equations.structure.angles, vec![false, true, true]);
    assert_eq!(equations.structure.ignorable, vec![true, false, false]);
}

#[test]
fn blocks_of_the_mass_matrix_have_their_own_singularities() {
    // A planar point in polar coordinates beside a linear one: T = ½(ṙ² + r²φ̇² + ẋ²), V = x².
    let mut draft = Draft::new(3);
    let (r, x) = (draft.q(0), draft.q(2));
    let (vr, vphi, vx) = (draft.v(0), draft.v(1), draft.v(2));
    let across = draft.times(&[r, vphi]);
    let squares: Vec<_> = [vr, across, vx].map(|v| draft.square(v)).to_vec();
    let sum = draft.plus(&squares);
    let (kinetic, potential) = (draft.half(sum), draft.square(x));
    let mut model = draft.natural(kinetic, potential);
    let structure = Equations::derive(&mut model).unwrap().structure;
    assert_eq!(structure.singularities, vec![vec![], vec![0], vec![]]);
    // φ occurs nowhere; r and x are lengths.
    assert_eq!(structure.angles, vec![false; 3]);
    assert_eq!(structure.ignorable, vec![false, true, false]);
}

#[test]
fn natural_systems_conserve_kinetic_plus_potential() {
    let (mut model, _) = rigid_body();
    let Energies::Natural { kinetic, .. } = model.energies else {
        unreachable!()
    };
    assert_eq!(Equations::derive(&mut model).unwrap().energy, kinetic);
}

#[test]
fn a_general_lagrangian_need_not_be_quadratic() {
    // A relativistic particle, L = −√(1 − v²) − x: p = γ v, M = γ³, f = −1.
    let mut draft = Draft::new(1);
    let (x, v) = (draft.q(0), draft.v(0));
    let square = draft.square(v);
    let one = draft.graph.one();
    let inner = draft.graph.subtract(one, square);
    let root = draft.graph.square_root(inner);
    let sum = draft.plus(&[root, x]);
    let lagrangian = draft.graph.negate(sum);
    let mut model = draft.model(Energies::General(lagrangian));
    let equations = Equations::derive(&mut model).unwrap();
    let slow = |symbol: Symbol| {
        if symbol == Symbol::Velocity(0) {
            0.6
        } else {
            value(symbol)
        }
    };
    let roots = [
        equations.momenta[0],
        equations.mass[0][0],
        equations.forcing[0],
        equations.energy,
    ];
    let found = model.graph.evaluate(&roots, slow);
    assert_close(found[0], 1.25 * 0.6);
    assert_close(found[1], 1.25_f64.powi(3));
    assert_close(found[2], -1.0);
    assert_close(found[3], 1.25 + 0.7);
}

#[test]
fn what_has_no_equations_of_motion_is_refused() {
    // T = ½(ẋ + ẏ)²: M has rank one.
    let mut draft = Draft::new(2);
    let (vx, vy) = (draft.v(0), draft.v(1));
    let sum = draft.plus(&[vx, vy]);
    let square = draft.square(sum);
    let kinetic = draft.half(square);
    let zero = draft.graph.zero();
    let mut model = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );

    // T = ½ẋ², with y in V: y has no acceleration.
    let mut draft = Draft::new(2);
    let (vx, y) = (draft.v(0), draft.q(1));
    let square = draft.square(vx);
    let kinetic = draft.half(square);
    let mut model = draft.natural(kinetic, y);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::NoVelocity(vec![1])
    );

    // T = ½ẋ² + u ẋ: the momentum contains an input.
    let mut draft = Draft::new(1);
    let vx = draft.v(0);
    let u = draft.graph.symbol(Symbol::Input(0));
    let square = draft.square(vx);
    let quadratic = draft.half(square);
    let linear = draft.times(&[u, vx]);
    let kinetic = draft.plus(&[quadratic, linear]);
    let zero = draft.graph.zero();
    let mut model = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::MomentumOfInput(vec![0])
    );
}

#[test]
fn singularity_is_decided_through_trigonometry_and_roots() {
    // w₁ = ẋ cos a + ẏ sin a with a moving, T = ½ w₁² + ½ √(a²+1)² ȧ²: rank two of three.
    let mut draft = Draft::new(3);
    let (vx, vy, a, va) = (draft.v(0), draft.v(1), draft.q(2), draft.v(2));
    let (sin, cos) = (draft.sin(a), draft.cos(a));
    let (first, second) = (draft.times(&[vx, cos]), draft.times(&[vy, sin]));
    let along = draft.plus(&[first, second]);
    let a2 = draft.square(a);
    let one = draft.graph.one();
    let inner = draft.plus(&[a2, one]);
    let root = draft.graph.square_root(inner);
    let turning = draft.times(&[root, va]);
    let (t1, t2) = (draft.square(along), draft.square(turning));
    let sum = draft.plus(&[t1, t2]);
    let kinetic = draft.half(sum);
    let zero = draft.graph.zero();
    let mut singular = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut singular).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );
}

#[test]
fn indefinite_mass_matrices_are_regular() {
    // L = ẋẏ − xy.
    let mut draft = Draft::new(2);
    let (x, y, vx, vy) = (draft.q(0), draft.q(1), draft.v(0), draft.v(1));
    let (kinetic, potential) = (draft.times(&[vx, vy]), draft.times(&[x, y]));
    let mut model = draft.natural(kinetic, potential);
    let equations = Equations::derive(&mut model).unwrap();
    assert_eq!(equations.mass[0][0], model.graph.zero());
    assert_eq!(equations.mass[0][1], model.graph.one());
}

#[test]
fn derivatives_of_the_residual_are_those_of_finite_differences() {
    let (mut model, _) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let symbols = [
        Symbol::Coordinate(1),
        Symbol::Coordinate(2),
        Symbol::Velocity(0),
        Symbol::Time,
    ];
    let derivatives =
        symbols.map(|symbol| model.graph.derivatives(&equations.inverse_dynamics, symbol));
    for (j, moved) in symbols.into_iter().enumerate() {
        let step = 1e-5;
        let at = |side: f64| {
            let shifted =
                move |symbol| value(symbol) + if symbol == moved { side * step } else { 0.0 };
            model.graph.evaluate(&equations.inverse_dynamics, shifted)
        };
        let (above, below) = (at(1.0), at(-1.0));
        for (i, derivative) in derivatives[j].iter().enumerate() {
            let found = model.graph.evaluate(&[*derivative], value)[0];
            let expected = (above[i] - below[i]) / (2.0 * step);
            // The third derivative is of order ten, so that the formula errs by about 1e-9.
            assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
        }
    }
}

#[test]
fn programs_compute_what_they_were_made_from() {
    let (mut model, _) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let mass: Vec<_> = equations.mass_lower().collect();
    let groups: [&[Expression]; 2] = [&mass, &equations.inverse_dynamics];
    let program = Program::schedule(&model.graph, &groups);
    assert_eq!(program.verify(&model.graph, &groups), Ok(()));
    let values = program.evaluate(value);
    for (roots, values) in groups.iter().zip(values) {
        for (expected, found) in model.graph.evaluate(roots, value).into_iter().zip(values) {
            assert_close(found, expected);
        }
    }
}

#[test]
fn programs_expand_to_the_expressions_that_they_were_made_from() {
    let (mut model, _) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let groups: [&[Expression]; 2] = [&equations.mass.concat(), &equations.forcing];
    let program = Program::schedule(&model.graph, &groups);
    let expanded = program.expand(&mut model.graph);
    for (root, again) in groups.concat().into_iter().zip(expanded.concat()) {
        let difference = model.graph.subtract(root, again);
        for seed in 0..3 {
            assert_eq!(
                Point::new(seed).evaluate(&model.graph, &[difference]),
                Some(vec![0])
            );
        }
    }
}

#[test]
fn a_wrong_program_is_found_out() {
    let (mut model, _) = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let groups: [&[Expression]; 1] = [&equations.forcing];
    let program = Program::schedule(&model.graph, &groups);

    let mut swapped = program.clone();
    swapped.phases[0].outputs.swap(0, 1);
    assert!(swapped.verify(&model.graph, &groups).is_err());

    let mut unordered = program.clone();
    unordered.phases[0].instructions.reverse();
    assert!(unordered.verify(&model.graph, &groups).is_err());

    let mut repeated = program;
    let first = repeated.phases[0].instructions[0].clone();
    repeated.phases[0].instructions.insert(1, first);
    assert!(repeated.verify(&model.graph, &groups).is_err());
}

/// ½ m (ẋ + √c ẏ)², which is singular for every c.
fn leaning(c: i64) -> Model {
    let mut draft = Draft::new(2);
    let (m, vx, vy) = (draft.parameter(0), draft.v(0), draft.v(1));
    let number = draft.graph.integer(c);
    let root = draft.graph.square_root(number);
    let slanted = draft.times(&[root, vy]);
    let along = draft.plus(&[vx, slanted]);
    let square = draft.square(along);
    let twice = draft.times(&[m, square]);
    let kinetic = draft.half(twice);
    let zero = draft.graph.zero();
    draft.natural(kinetic, zero)
}

#[test]
fn roots_of_small_numbers_are_no_obstacle() {
    for c in [2, 3, 5, 6, 7, 10, 11, 13, 17, 19, 23] {
        let defect = Equations::derive(&mut leaning(c)).unwrap_err();
        assert_eq!(defect, Defect::SingularMass(vec![0, 1]), "root of {c}");
    }
}

#[test]
fn corners_are_not_taken_for_zero() {
    // T = ½ max(l, 0) ẋ²: M vanishes for half of all l, and not identically.
    for i in 0..24 {
        let mut draft = Draft::new(1);
        let (l, v) = (draft.parameter(i), draft.v(0));
        let zero = draft.graph.zero();
        let mass = draft.graph.binary(Binary::Max, l, zero);
        let square = draft.square(v);
        let twice = draft.times(&[mass, square]);
        let kinetic = draft.half(twice);
        assert!(Equations::derive(&mut draft.natural(kinetic, zero)).is_ok());
    }

    // T = ½ v² − min(v, 0)³: the energy function is not T.
    let mut draft = Draft::new(1);
    let v = draft.v(0);
    let zero = draft.graph.zero();
    let negative = draft.graph.binary(Binary::Min, v, zero);
    let cube = draft.graph.power(negative, &Rational::integer(3));
    let square = draft.square(v);
    let half = draft.half(square);
    let kinetic = draft.graph.subtract(half, cube);
    let mut model = draft.natural(kinetic, zero);
    let equations = Equations::derive(&mut model).unwrap();
    let back = |symbol: Symbol| {
        if symbol == Symbol::Velocity(0) {
            -2.0
        } else {
            value(symbol)
        }
    };
    // p = v − 3 min(v, 0)², h = p v − T.
    let expected = (-2.0 - 12.0) * -2.0 - (2.0 + 8.0);
    assert_close(model.graph.evaluate(&[equations.energy], back)[0], expected);
}

#[test]
fn programs_with_roots_are_verified_too() {
    let mut graph = Graph::new();
    let roots: Vec<_> = (0..12)
        .map(|i| {
            let x = graph.symbol(Symbol::Parameter(i));
            let exponent = Rational::new(2 * i64::from(i) + 1, 2).unwrap();
            graph.power(x, &exponent)
        })
        .collect();
    let program = Program::schedule(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    let mut wrong = program;
    wrong.phases[0].outputs.swap(3, 4);
    assert!(matches!(
        wrong.verify(&graph, &[&roots]),
        Err(Fault::WrongOutput {
            group: 0,
            output: 3
        })
    ));
}
