//! Chains of 1 to 20 pendulums, declared by families, against the closed form of M and f solved by LU. Some lengths stand for
//! all, which take long to compile, but for the feature `all-cases`.

use lagrangian::{Operations, prelude::*};
use lagrangian_tests::{Figures, Random, motions, relative_error};
use nalgebra::{DMatrix, DVector, Vector2};

/// Of q̈, relative to its greatest entry: M of 20 links loses some digits.
const TOLERANCE: f64 = 1e-12;
const G: f64 = 9.81;

/// A chain of so many links, its point masses below one another.
trait Chain<const N: usize>: Lagrangian<N> {
    /// What its methods cost.
    const COSTS: Operations;
    /// The chain with these masses and lengths.
    fn new(m: [f64; N], l: [f64; N], g: f64) -> Self;
}

/// The angles of the links from the vertical, and what acts on a chain besides its weight.
struct ClosedForm<'a> {
    m: &'a [f64],
    l: &'a [f64],
    /// The acceleration of the point of suspension.
    suspension: Vector2<f64>,
    /// Generalized forces.
    forces: DVector<f64>,
}

impl<'a> ClosedForm<'a> {
    fn new(m: &'a [f64], l: &'a [f64]) -> Self {
        let forces = DVector::zeros(m.len());
        Self {
            m,
            l,
            suspension: Vector2::zeros(),
            forces,
        }
    }

    /// What hangs on a link, itself included.
    fn below(&self, link: usize) -> f64 {
        self.m[link..].iter().sum()
    }

    /// Mᵢⱼ = μ lᵢ lⱼ cos(θᵢ − θⱼ), where μ hangs on the lower of the two, and
    /// fᵢ = −Σⱼ μ lᵢ lⱼ sin(θᵢ − θⱼ) θ̇ⱼ² − μᵢ lᵢ (ẍ cos θᵢ + (g + ÿ) sin θᵢ) + Qᵢ.
    fn accelerations(&self, q: &[f64], v: &[f64]) -> Vec<f64> {
        let n = self.m.len();
        let factor = |i: usize, j: usize| self.below(i.max(j)) * self.l[i] * self.l[j];
        let mass = DMatrix::from_fn(n, n, |i, j| factor(i, j) * (q[i] - q[j]).cos());
        let forcing = DVector::from_fn(n, |i, _| {
            let centrifugal = |j: usize| factor(i, j) * (q[i] - q[j]).sin() * v[j].powi(2);
            let (x, y) = (self.suspension.x, G + self.suspension.y);
            let fictitious = self.below(i) * self.l[i] * (x * q[i].cos() + y * q[i].sin());
            self.forces[i] - (0..n).map(centrifugal).sum::<f64>() - fictitious
        });
        let solution = mass.lu().solve(&forcing).expect("M is positive definite");
        solution.as_slice().to_vec()
    }
}

/// Declares a chain of `$n` links in three spellings.
macro_rules! three_spellings {
    ($n:literal) => {
        /// Sums over the links above.
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(theta[$n]),
            define(
                x[i] = (0..=i).map(|k| l[k] * sin(theta[k])).sum() for i in 0..$n,
                y[i] = (0..=i).map(|k| -l[k] * cos(theta[k])).sum() for i in 0..$n,
            ),
            kinetic = 0.5 * (0..$n).map(|i| m[i] * (dot(x[i]).powi(2) + dot(y[i]).powi(2))).sum(),
            potential = g * (0..$n).map(|i| m[i] * y[i]).sum(),
        )]
        struct Sums {
            m: [f64; $n],
            l: [f64; $n],
            g: f64,
        }

        /// Each mass from the one above.
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(theta[$n]),
            define(
                x[0] = l[0] * sin(theta[0]),
                y[0] = -l[0] * cos(theta[0]),
                x[i] = x[i - 1] + l[i] * sin(theta[i]) for i in 1..$n,
                y[i] = y[i - 1] - l[i] * cos(theta[i]) for i in 1..$n,
            ),
            kinetic = 0.5 * (0..$n).map(|i| m[i] * (dot(x[i]).powi(2) + dot(y[i]).powi(2))).sum(),
            potential = g * (0..$n).map(|i| m[i] * y[i]).sum(),
        )]
        struct Recursion {
            m: [f64; $n],
            l: [f64; $n],
            g: f64,
        }

        /// The same in vectors.
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(theta[$n]),
            define(
                p[0] = l[0] * [sin(theta[0]), -cos(theta[0])],
                p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..$n,
            ),
            kinetic = (0..$n).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
            potential = (0..$n).map(|i| m[i] * g * p[i].y).sum(),
        )]
        struct Vectors {
            m: [f64; $n],
            l: [f64; $n],
            g: f64,
        }

        three_spellings!(@ $n Sums Recursion Vectors);
    };
    (@ $n:literal $($model:ident)*) => {
        $(impl Chain<$n> for $model {
            const COSTS: Operations = Self::OPERATIONS;
            fn new(m: [f64; $n], l: [f64; $n], g: f64) -> Self {
                Self { m, l, g }
            }
        })*
    };
}

#[test]
fn chains_follow_the_closed_form() {
    let mut figures = Figures::new();
    let mut costs = Vec::new();
    macro_rules! links {
        ($($n:literal)*) => {$({
            three_spellings!($n);
            compare::<Sums, $n>("sums", &mut figures);
            compare::<Recursion, $n>("recursion", &mut figures);
            compare::<Vectors, $n>("vectors", &mut figures);
            let totals = [Sums::COSTS, Recursion::COSTS, Vectors::COSTS];
            costs.push(($n, totals.map(|all| all.accelerations.total())));
        })*};
    }
    #[cfg(not(feature = "all-cases"))]
    links!(1 2 3 5 8 13 20);
    #[cfg(feature = "all-cases")]
    links!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20);
    figures.finish();
    assert_grow_linearly(&costs);
}

fn compare<M: Chain<N>, const N: usize>(spelling: &'static str, figures: &mut Figures) {
    let mut random = Random::default();
    for _ in 0..20 {
        let (m, l) = (random.array(0.5, 2.0), random.array(0.5, 2.0));
        let state = random.state();
        let found = M::new(m, l, G).accelerations(&state);
        let expected =
            ClosedForm::new(&m, &l).accelerations(state.q.as_slice(), state.v.as_slice());
        let error = relative_error(found.as_slice(), &expected, 1.0);
        figures.record(spelling, &format!("{N} links, {state:?}"), error, TOLERANCE);
    }
}

/// From eight links on, each costs as much as the one before, and all spellings nearly the same: numbers of links with the costs
/// of each spelling.
fn assert_grow_linearly(costs: &[(usize, [usize; 3])]) {
    for (links, spellings) in costs {
        println!("{links:>2} links: {spellings:?} operations");
    }
    for (links, [sums, recursion, vectors]) in costs {
        assert_eq!(sums, recursion, "{links} links");
        assert!(
            10 * vectors.abs_diff(*sums) <= *sums,
            "{links} links: {vectors}, not {sums}"
        );
    }
    let most = costs
        .last()
        .map(|(links, spellings)| (*links, spellings[0]));
    let (20, most) = most.expect("there are chains") else {
        panic!("the longest chain has 20 links");
    };
    assert!(most <= 1200, "{most} operations of 20 links");
    for pair in costs.windows(2).filter(|pair| pair[0].0 > 7) {
        let [(fewer, [before, ..]), (links, [after, ..])] = [pair[0], pair[1]];
        assert!(after - before <= 65 * (links - fewer), "{pair:?}");
    }
}

/// Moved at its first joint, with friction in all joints, and its suspension shaken.
macro_rules! disturbed {
    ($n:literal) => {
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(theta[$n]),
            define(
                p[0] = [sway * sin(nu * t), lift * cos(nu * t)] + l[0] * [sin(theta[0]), -cos(theta[0])],
                p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..$n,
            ),
            kinetic = (0..$n).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
            potential = (0..$n).map(|i| m[i] * g * p[i].y).sum(),
            dissipation = 0.5 * c * (dot(theta[0]).powi(2)
                + (1..$n).map(|i| (dot(theta[i]) - dot(theta[i - 1])).powi(2)).sum()),
            force(theta[0] = torque),
        )]
        struct Disturbed {
            m: [f64; $n],
            l: [f64; $n],
            g: f64,
            sway: f64,
            lift: f64,
            nu: f64,
            c: f64,
            #[lagrangian(input)]
            torque: f64,
        }
    };
}

#[test]
fn disturbed_chains_follow_the_closed_form() {
    let mut figures = Figures::new();
    macro_rules! links {
        ($($n:literal)*) => {$({
            disturbed!($n);
            let mut random = Random::default();
            // One after another, then all at once.
            for (c, torque, [sway, lift]) in [
                (0.0, 1.7, [0.0; 2]),
                (0.3, 0.0, [0.0; 2]),
                (0.0, 0.0, [0.0, 0.1]),
                (0.3, 1.7, [0.2, 0.1]),
            ] {
                let (m, l) = (random.array(0.5, 2.0), random.array(0.5, 2.0));
                let state = random.state();
                let nu = 7.0;
                let chain = Disturbed { m, l, g: G, sway, lift, nu, c, torque: f64::NAN };
                let found = chain.with_inputs([torque]).accelerations(&state);
                let suspension = [sway * (nu * state.t).sin(), lift * (nu * state.t).cos()];
                let expected = ClosedForm {
                    suspension: Vector2::from(suspension) * -nu.powi(2),
                    forces: joint_torques(c, torque, state.v.as_slice()),
                    ..ClosedForm::new(&m, &l)
                };
                let expected = expected.accelerations(state.q.as_slice(), state.v.as_slice());
                let error = relative_error(found.as_slice(), &expected, 1.0);
                figures.record("disturbed", &format!("{} links, {state:?}", $n), error, TOLERANCE);
            }
        })*};
    }
    links!(1 2 3 8 20);
    figures.finish();
}

/// Each joint brakes the link below it and is pushed back by it into the link above.
fn joint_torques(friction: f64, torque: f64, v: &[f64]) -> DVector<f64> {
    let mut forces = DVector::zeros(v.len());
    forces[0] = torque - friction * v[0];
    for i in 1..v.len() {
        let braking = friction * (v[i] - v[i - 1]);
        forces[i] -= braking;
        forces[i - 1] += braking;
    }
    forces
}

#[test]
fn five_links_move_as_the_reference() {
    three_spellings!(5);
    let mut figures = Figures::new();
    for motion in motions("pendulum_5link") {
        let of_links =
            |letter: &str| std::array::from_fn(|i| motion.parameter(&format!("{letter}{}", i + 1)));
        macro_rules! compare {
            ($($model:ident)*) => {$(
                let chain = $model::new(of_links("m"), of_links("l"), motion.parameter("g"));
                motion.compare(stringify!($model), &chain.dynamics(), 1e-11, &mut figures);
            )*};
        }
        compare!(Sums Recursion Vectors);
    }
    figures.finish();
}

/// The declaration of the example: the attribute with the energies, and the struct.
#[test]
fn twenty_links_are_declared_in_eleven_lines() {
    let example = include_str!("../../../examples/n_link_pendulum.rs");
    let attribute = example.find("#[lagrangian(").expect("an attribute");
    let declaration = &example[attribute..];
    let end = declaration.find("\n}\n").expect("the end of the struct");
    let declaration = &declaration[..end + 2];
    assert!(
        declaration.contains("coordinates(theta[20])"),
        "{declaration}"
    );
    assert_eq!(declaration.lines().count(), 11, "{declaration}");
    assert!(
        declaration.lines().all(|line| line.len() <= 100),
        "{declaration}"
    );
}

/// A pendulum of which gravity is a number, and one of which it is a parameter.
#[test]
fn a_number_costs_no_more_than_a_parameter() {
    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(theta),
        kinetic = 0.5 * m * (l * dot(theta)).powi(2),
        potential = -m * g * l * cos(theta),
    )]
    struct Parameter {
        m: f64,
        g: f64,
        l: f64,
    }

    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(theta),
        kinetic = 0.5 * m * (l * dot(theta)).powi(2),
        potential = -m * 9.81 * l * cos(theta),
    )]
    struct Number {
        m: f64,
        l: f64,
    }

    let [parameter, number] = [Parameter::OPERATIONS, Number::OPERATIONS];
    let [parameter, number] = [parameter, number].map(|all| all.accelerations.total());
    assert!(
        number <= parameter,
        "{number} operations, and {parameter} with a parameter"
    );
}
