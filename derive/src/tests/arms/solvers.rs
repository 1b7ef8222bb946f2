//! All solvers of one mechanism find the same accelerations, to what the condition of M allows.

use lagrangian_symbolic::Solution;

use super::*;

/// By articulated links, by the factors of M of composite bodies, and by elimination with pivots of numbers. Towards the
/// tip links get lighter, so that the condition of M is up to 10¹⁰.
#[test]
fn solvers_agree_to_what_the_condition_allows() {
    let mut worst = 0.0_f64;
    for (links, lighter) in [(2, 1.0), (3, 1e-3), (5, 0.1), (5, 1e-2), (8, 0.3)] {
        let mut derived = derive(arm(links));
        let solutions = Kinetics::solutions(&mut derived.model, &derived.equations);
        let methods: Vec<_> = solutions.iter().map(Solution::method).collect();
        for method in ["articulated links", "factors of M"] {
            assert!(methods.contains(&method), "{links}: {methods:?}");
        }
        let programs: Vec<_> = solutions
            .iter()
            .map(|solution| Program::schedule(&derived.model.graph, &[&solution.accelerations]))
            .collect();
        for seed in 0..4 {
            let mut numbers = Numbers::new(seed);
            let mut parameters = Arm::new(links, &mut numbers).parameters();
            let mut factor = 1.0;
            for i in 0..links {
                let inertia = 7 * links + 9 * i;
                parameters[i] *= factor;
                for x in &mut parameters[inertia..inertia + 9] {
                    *x *= factor;
                }
                factor *= lighter;
            }
            let state: Vec<_> = (0..2 * links).map(|_| 3.0 * numbers.next()).collect();
            let value = |symbol| match symbol {
                Symbol::Coordinate(i) => state[i as usize],
                Symbol::Velocity(i) => state[links + i as usize],
                Symbol::Parameter(i) => parameters[i as usize],
                _ => f64::NAN,
            };
            let mass = values(&derived, &derived.methods.mass_matrix, value);
            let forcing = values(&derived, &derived.methods.forcing, value);
            let system = System::new(&mass, forcing);
            worst = worst.max(system.condition());
            for (program, method) in programs.iter().zip(&methods) {
                let found = program.evaluate(value).concat();
                let (error, bound) = system.error(&found);
                assert!(
                    error < bound,
                    "{links}, {method}: {error:e} exceeds {bound:e}"
                );
            }
        }
    }
    assert!(worst > 1e8, "{worst:e}");
}

/// M x = f, with M⁻¹.
struct System {
    mass: Vec<Vec<f64>>,
    inverse: Vec<Vec<f64>>,
    forcing: Vec<f64>,
}

impl System {
    fn new(mass: &[f64], forcing: Vec<f64>) -> Self {
        let n = forcing.len();
        let mass: Vec<_> = mass.chunks(n).map(<[f64]>::to_vec).collect();
        let column = |i: usize| {
            let unit = (0..n).map(|j| if i == j { 1.0 } else { 0.0 });
            solve(mass.clone(), unit.collect())
        };
        Self {
            inverse: (0..n).map(column).collect(),
            mass,
            forcing,
        }
    }

    fn condition(&self) -> f64 {
        size(&self.mass.concat()) * size(&self.inverse.concat())
    }

    /// The difference of a solution from that by elimination, and what rounding allows: |δx| ≤ |M⁻¹| (|δf| + |δM| |x|), with
    /// some tens of rounding errors in each of f and M.
    fn error(&self, found: &[f64]) -> (f64, f64) {
        let expected = solve(self.mass.clone(), self.forcing.clone());
        let pairs = found.iter().zip(&expected);
        let differences: Vec<_> = pairs.map(|(x, y)| x - y).collect();
        let parts = size(&self.forcing) + size(&self.mass.concat()) * size(&expected);
        let rounded = 64.0 * f64::EPSILON;
        (
            size(&differences),
            rounded * size(&self.inverse.concat()) * parts,
        )
    }
}

fn size(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}
