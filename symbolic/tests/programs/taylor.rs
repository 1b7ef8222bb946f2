//! Taylor series of programs, and the check that every expansion makes of them.

use lagrangian_symbolic::{
    Binary, Equations, Expression, FirstOrderEquations, Graph, ImplicitEquations, Kinetics, Model,
    Operation, PoleForm, Program, Reduction, SeriesCheck, SeriesOutputs, Staged, Symbol,
    TaylorProgram, ValueSeriesCheck,
};
use lagrangian_symbolic_testing::mutation::wrong_series;
use lagrangian_symbolic_testing::systems::{
    Chain, cardan_rates, cart_pole, charged, driven_pendulum, euler_rates, indefinite, polar,
    rigid_body, top,
};
use lagrangian_symbolic_testing::{Draft, Quantity};

/// The staged program of the accelerations of a model, or of M and f, and the number of pivots or of coordinates.
struct Accelerations {
    graph: Graph,
    staged: Staged,
    pivots: Option<usize>,
    coordinates: usize,
}

impl Accelerations {
    fn of(mut model: Model) -> Self {
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        Self::by(model, &kinetics)
    }

    fn by(model: Model, kinetics: &Kinetics) -> Self {
        let outputs = Self::outputs(kinetics);
        let solution = kinetics.solution.as_ref();
        let pivots = solution.map(|solution| solution.pivots.len());
        let program = Program::schedule_for_staging(&model.graph, &[&outputs]);
        Self {
            staged: program.staged(model.graph.passes),
            graph: model.graph,
            pivots,
            coordinates: kinetics.mass.len(),
        }
    }

    /// The series in velocities, those in quasi-velocities, and those of implicit equations.
    fn choices(model: &Model) -> Vec<(Self, TaylorProgram)> {
        let found = Self::of(model.clone());
        let taylor = found.taylor();
        let mut choices = vec![(found, taylor)];
        let mut model = model.clone();
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        for choice in kinetics.first_order_equations(&mut model, &equations) {
            choices.push(Self::of(model.clone()).of_first_order(&model, &choice));
        }
        choices.extend(Self::implicit_choices(&mut model, &equations, &kinetics));
        choices
    }

    /// The series of implicit equations.
    fn implicit_choices(
        model: &mut Model,
        equations: &Equations,
        kinetics: &Kinetics,
    ) -> Vec<(Self, TaylorProgram)> {
        let choices = kinetics.implicit_equations(model, equations);
        let choices = choices.iter().map(|choice| {
            let found = Self::by(model.clone(), kinetics);
            found.of_implicit_equations(model, kinetics, choice)
        });
        choices.collect()
    }

    /// The series in velocities and those of implicit equations, where M is factored numerically.
    fn numerical_choices(model: &Model) -> Vec<(Self, TaylorProgram)> {
        let mut model = model.clone();
        let equations = Equations::derive(&mut model).unwrap();
        let mut kinetics = Kinetics::cheapest(&mut model, &equations);
        kinetics.solution = None;
        let found = Self::by(model.clone(), &kinetics);
        let taylor = found.taylor();
        let mut choices = vec![(found, taylor)];
        choices.extend(Self::implicit_choices(&mut model, &equations, &kinetics));
        choices
    }

    fn of_implicit_equations(
        mut self,
        model: &Model,
        kinetics: &Kinetics,
        equations: &ImplicitEquations,
    ) -> (Self, TaylorProgram) {
        let first = Self::outputs(kinetics);
        let roots = [&first[..], &equations.residuals, &equations.solution];
        let program = Program::schedule_for_staging(&model.graph, &roots);
        let staged = program.staged(model.graph.passes);
        let kernel = staged.with_setup_in(&mut self.staged.setup);
        let [first, residuals, solution] = [0, 1, 2].map(|group| &*kernel.groups[group].outputs);
        let accelerations = self.pivots.map_or(&[][..], |pivots| &first[pivots..]);
        let outputs = SeriesOutputs::Implicit {
            accelerations,
            residuals,
            solution,
        };
        let taylor = TaylorProgram::of(&model.graph, &kernel, outputs).unwrap();
        (self, taylor)
    }

    /// The pivots and accelerations, or M and f.
    fn outputs(kinetics: &Kinetics) -> Vec<Expression> {
        if let Some(solution) = &kinetics.solution {
            return [&*solution.pivots, &solution.accelerations].concat();
        }
        let rows = kinetics.system.mass.iter().enumerate();
        let mut outputs: Vec<_> = rows.flat_map(|(i, row)| row[..=i].to_vec()).collect();
        outputs.extend(&kinetics.system.forcing);
        outputs
    }

    fn of_first_order(
        mut self,
        model: &Model,
        equations: &FirstOrderEquations,
    ) -> (Self, TaylorProgram) {
        let FirstOrderEquations {
            values,
            velocities,
            rates,
        } = equations;
        let roots = [&values[..], velocities, rates];
        let program = Program::schedule_for_staging(&model.graph, &roots);
        let staged = program.staged(model.graph.passes);
        let kernel = staged.with_setup_in(&mut self.staged.setup);
        let [values, velocities, rates] = [0, 1, 2].map(|group| &*kernel.groups[group].outputs);
        let outputs = SeriesOutputs::QuasiVelocities {
            values,
            velocities,
            rates,
        };
        let taylor = TaylorProgram::of(&model.graph, &kernel, outputs).unwrap();
        (self, taylor)
    }

    fn taylor(&self) -> TaylorProgram {
        let kernel = &self.staged.kernel;
        let outputs = &kernel.groups[0].outputs;
        let operands = if let Some(pivots) = self.pivots {
            SeriesOutputs::Accelerations(&outputs[pivots..])
        } else {
            let (mass, forcing) = outputs.split_at(outputs.len() - self.coordinates);
            SeriesOutputs::System(mass, forcing)
        };
        TaylorProgram::of(&self.graph, kernel, operands).unwrap()
    }

    fn agree_with(&self, taylor: &TaylorProgram) -> bool {
        let kernel = &self.staged.kernel;
        let program = (kernel, self.pivots);
        let setup = &self.staged.setup;
        let solution = (self.coordinates, self.pivots.is_none());
        SeriesCheck::new(&self.graph, setup, program, taylor, solution).agrees()
    }
}

/// The symmetric top without its ignorable angles.
fn reduced_top(form: PoleForm) -> Model {
    let mut full = top(euler_rates, [0, 0, 1]);
    let equations = Equations::derive(&mut full).unwrap();
    let parameters = 4;
    let reduction = Reduction::of(&full, &equations, parameters, form);
    reduction.unwrap().model
}

fn systems() -> Vec<(&'static str, Model)> {
    vec![
        ("driven pendulum", driven_pendulum()),
        ("rigid body", rigid_body()),
        ("symmetric top", top(euler_rates, [0, 0, 1])),
        ("general top", top(cardan_rates, [0, 1, 2])),
        ("reduced top", reduced_top(PoleForm::Direct)),
        ("cart and pole", cart_pole()),
        ("polar", polar()),
        ("charged", charged()),
        ("indefinite", indefinite()),
        ("three links", Chain::of(3).model()),
    ]
}

#[test]
fn recurrences_give_the_derivatives_of_the_accelerations() {
    for (what, model) in systems() {
        for (choice, (accelerations, taylor)) in Accelerations::choices(&model).iter().enumerate() {
            assert!(accelerations.agree_with(taylor), "{what}: choice {choice}");
        }
    }
}

/// Every instruction and every convolution of a recurrence counts in the check.
#[test]
fn a_recurrence_with_an_error_anywhere_is_found_out() {
    for (what, model) in systems() {
        for (accelerations, right) in Accelerations::choices(&model) {
            find_out(what, &accelerations, &right);
        }
    }
}

#[test]
fn recurrences_hold_where_the_mass_matrix_is_factored_numerically() {
    for (what, model) in systems() {
        for (accelerations, right) in Accelerations::numerical_choices(&model) {
            assert!(accelerations.agree_with(&right), "{what}");
            find_out(what, &accelerations, &right);
        }
    }
}

/// Fails where the check does not find an error in a recurrence.
fn find_out(what: &str, accelerations: &Accelerations, right: &TaylorProgram) {
    for (error, wrong) in wrong_series(right, &[0, 1]) {
        assert!(!accelerations.agree_with(&wrong), "{what}: {error}");
    }
}

/// Euler's equations and the kinematics of their angles are shorter than what they give for the angles; momenta of
/// ignorable coordinates do not vary.
#[test]
fn series_in_quasi_velocities_take_fewer_convolutions() {
    let fewest = |model: Model| {
        let choices = Accelerations::choices(&model);
        let counts = choices.iter().map(|(_, taylor)| taylor.convolutions.len());
        let counts: Vec<usize> = counts.collect();
        (counts[0], counts.into_iter().min().unwrap())
    };
    assert_eq!(fewest(rigid_body()), (22, 13));
    assert_eq!(fewest(top(euler_rates, [0, 0, 1])), (10, 6));
    assert_eq!(fewest(top(cardan_rates, [0, 1, 2])), (26, 15));
}

/// By the cosine, whose second derivative is a polynomial, three sums: its square, and two for the sine and the rate of the
/// angle. The acceleration takes sine and cosine, three for the potential and one for the quotient by sin³ θ.
#[test]
fn an_angle_in_an_effective_potential_moves_by_its_cosine() {
    let choices = Accelerations::choices(&reduced_top(PoleForm::Direct));
    let counts = choices.iter().map(|(_, taylor)| taylor.convolutions.len());
    let counts: Vec<usize> = counts.collect();
    assert_eq!((counts[0], counts.iter().min()), (6, Some(&3)));
    let cheapest = choices.iter().min_by_key(|(_, taylor)| taylor.cost());
    assert_eq!(cheapest.unwrap().1.convolutions.len(), 3);
}

fn square(draft: &Draft) -> Quantity<'_> {
    draft.v(0).squared()
}

fn cosine(draft: &Draft) -> Quantity<'_> {
    draft.q(0).cos()
}

fn pole(draft: &Draft) -> Quantity<'_> {
    let numerator = (draft.one() - draft.p(0) * cosine(draft)).squared();
    numerator / draft.q(0).sin().squared()
}

/// Without a pole, with a force, where an inertia varies, or in time, there is no such polynomial, or it earns nothing.
#[test]
fn other_angles_do_not_move_by_their_cosines() {
    let count = |make: &dyn for<'d> Fn(&'d Draft) -> [Quantity<'d>; 3]| {
        let draft = Draft::new(1);
        let [kinetic, potential, force] = make(&draft);
        let force = force.expression();
        let mut model = draft.natural(kinetic, potential);
        model.forces = vec![force];
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        kinetics.first_order_equations(&mut model, &equations).len()
    };
    let regular = count(&|d| [square(d), cosine(d), d.zero()]);
    let with_pole = [
        count(&|d| [square(d), pole(d), d.zero()]),
        count(&|d| [d.p(1) * square(d), pole(d) + cosine(d) - d.p(2), d.zero()]),
    ];
    assert_eq!(with_pole, [regular + 1; 2]);
    let others = [
        count(&|d| [square(d), pole(d) + d.q(0).sin(), d.zero()]),
        count(&|d| [square(d), pole(d) + d.q(0), d.zero()]),
        count(&|d| [square(d), pole(d) * d.time(), d.zero()]),
        count(&|d| [square(d), pole(d), -d.v(0)]),
        count(&|d| {
            [
                square(d) * (d.one() + cosine(d).squared()),
                pole(d),
                d.zero(),
            ]
        }),
    ];
    // Where the inertia varies, there is no quasi-velocity either.
    assert_eq!(others, [regular, regular, regular, regular, regular - 1]);
}

/// The factors of M have no series in implicit equations: a link takes two convolutions for its sine and cosine, one for
/// the square of its rate, four for the acceleration of the next joint, and two for the moment.
#[test]
fn implicit_equations_take_a_few_convolutions_for_each_link() {
    let counts = |links| {
        let choices = Accelerations::choices(&Chain::of(links).model());
        let counts = choices.iter().map(|(_, taylor)| taylor.convolutions.len());
        counts.collect::<Vec<_>>()
    };
    // The last ones are in differences of angles.
    assert_eq!(counts(2), [20, 18, 12]);
    assert_eq!(counts(3), [52, 27, 27]);
    assert_eq!(counts(5), [112, 45]);
    assert_eq!(counts(20), [562, 180]);
}

/// A term costs as much for each link, of which one more adds as much as the one before.
#[test]
fn the_recurrence_of_a_chain_grows_with_its_length() {
    let [five, ten, twenty] = [5, 10, 20].map(|links| {
        let choices = Accelerations::choices(&Chain::of(links).model());
        choices
            .iter()
            .map(|(_, taylor)| taylor.cost())
            .min()
            .unwrap()
    });
    assert!(
        twenty - ten <= 2 * (ten - five) + 1,
        "{five}, {ten}, {twenty}"
    );
}

/// The series of values along any motion, such as those of event functions: here of the energies and the forcing.
fn values() -> Vec<(&'static str, Graph, Program)> {
    // In the energy of the symmetric top sin² ψ + cos² ψ is 1, whatever the rate of ψ.
    let systems = systems().into_iter();
    let systems = systems.filter(|(what, _)| *what != "symmetric top");
    let systems = systems.map(|(what, mut model)| {
        let equations = Equations::derive(&mut model).unwrap();
        let mut values = equations.forcing.clone();
        values.extend([equations.energy, equations.lagrangian]);
        let program = Program::schedule(&model.graph, &[&values]);
        (what, model.graph, program)
    });
    systems.collect()
}

fn series_of_values(graph: &Graph, program: &Program) -> TaylorProgram {
    let outputs = SeriesOutputs::Values(&program.groups[0].outputs);
    TaylorProgram::of(graph, program, outputs).unwrap()
}

#[test]
fn series_of_values_with_an_error_anywhere_are_found_out() {
    for (what, graph, program) in values() {
        let right = series_of_values(&graph, &program);
        assert!(
            ValueSeriesCheck::new(&graph, &program, &right).agrees(),
            "{what}"
        );
        for (error, wrong) in wrong_series(&right, &[0]) {
            let agrees = ValueSeriesCheck::new(&graph, &program, &wrong).agrees();
            assert!(!agrees, "{what}: {error}");
        }
    }
}

/// An angle times its slope has one scale: the squares of x and y are convolved once, and so is x y′ − y x′.
#[test]
fn an_angle_and_its_slope_share_the_squares_of_the_distance() {
    let mut graph = Graph::new();
    let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
    let angle = graph.binary(Binary::Atan2, y, x);
    let potential = graph.square(angle);
    let force = graph.derivative(potential, Symbol::Coordinate(0));
    let program = Program::schedule(&graph, &[&[force]]);
    let outputs = SeriesOutputs::Values(&program.groups[0].outputs);
    let taylor = TaylorProgram::of(&graph, &program, outputs).unwrap();
    let instructions = taylor
        .initial
        .groups
        .iter()
        .flat_map(|group| &group.instructions);
    let scales = instructions.filter(|instruction| {
        matches!(instruction.operation, Operation::Binary(Binary::Scale, ..))
    });
    assert_eq!((scales.count(), taylor.convolutions.len()), (1, 7));
}
