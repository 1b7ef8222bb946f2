//! Radau5 of `differential-equations` on Andrews' squeezing mechanism, for a contest: the equations of E. Hairer & G.
//! Wanner, *Solving Ordinary Differential Equations II*, 2nd edition (1996), VII.7, by hand, with constants folded.
//!
//! The unknowns are q, v, w and λ: q̇ = v, v̇ = w, 0 = M w − f − Gᵀ λ, and g = 0 (index 3), ġ = 0 (index 2) or g̈ = 0
//! (index 1).
//!
//! Tolerances are given component by component: version 0.7.0 transforms a scalar tolerance once for each component, which
//! makes it 1e-3 for 27 components, whatever was asked for.

use std::process::ExitCode;

use differential_equations::linalg::Matrix;
use differential_equations::prelude::*;
use lagrangian::{Dual, Scalar};
use lagrangian_bench::{Integrated, Integration, Question, answer_questions, fewest_seconds};
use nalgebra::{SMatrix, SVector};

mod squeezer_equations;

use squeezer_equations::Angles;

/// The equations of one index. The Jacobian is exact, or without the derivatives of M, f and G, as in the book (p. 540).
#[derive(Clone, Copy)]
struct Squeezer<const INDEX: u8> {
    is_exact: bool,
}

type Unknowns = [f64; 27];

/// q, v, w and λ.
fn parts(y: &Unknowns) -> ([f64; 7], [f64; 7], [f64; 7], [f64; 6]) {
    let part = |first: usize| std::array::from_fn(|i| y[first + i]);
    (
        part(0),
        part(7),
        part(14),
        std::array::from_fn(|i| y[21 + i]),
    )
}

/// M w − f − Gᵀ λ, and the constraints.
#[inline(always)]
fn residuals<S: Scalar, const INDEX: u8>(
    q: &[S; 7],
    v: &[S; 7],
    w: &[S; 7],
    multipliers: &[S; 6],
) -> ([S; 7], [S; 6]) {
    let angles = Angles::at(q);
    let (inertia, forces) = (angles.momenta(w), angles.forces(v));
    let reactions = angles.reactions(multipliers);
    let motion = std::array::from_fn(|i| inertia[i] - forces[i] - reactions[i]);
    let constraints = match INDEX {
        3 => angles.loops(),
        2 => angles.rates(v),
        _ => {
            let (rates, curvatures) = (angles.rates(w), angles.curvatures(v));
            std::array::from_fn(|i| rates[i] + curvatures[i])
        }
    };
    (motion, constraints)
}

impl<const INDEX: u8> Squeezer<INDEX> {
    /// M, G and ones: the Jacobian without the derivatives of M, f and G.
    fn approximate(y: &Unknowns, jacobian: &mut Matrix<f64>) {
        let angles = Angles::at(&parts(y).0);
        for i in 0..14 {
            jacobian[(i, i + 7)] = 1.0;
        }
        let [m11, m21, m22, m33, m44, m54, m55, m66, m76, m77] = angles.mass();
        let diagonal = [m11, m22, m33, m44, m55, m66, m77];
        for (i, entry) in diagonal.into_iter().enumerate() {
            jacobian[(14 + i, 14 + i)] = entry;
        }
        for (i, entry) in [(0, m21), (3, m54), (5, m76)] {
            jacobian[(14 + i, 15 + i)] = entry;
            jacobian[(15 + i, 14 + i)] = entry;
        }
        let first = 7 * (3 - usize::from(INDEX));
        let gradient = angles.gradient();
        for (third, columns) in [&[0, 1, 2][..], &[0, 1, 3, 4], &[0, 1, 5, 6]]
            .into_iter()
            .enumerate()
        {
            for axis in 0..2 {
                let row = 21 + 2 * third + axis;
                for &i in columns {
                    jacobian[(14 + i, row)] = -gradient[i][axis];
                    jacobian[(row, first + i)] = gradient[i][axis];
                }
            }
        }
    }
}

impl<const INDEX: u8> DAE<f64, Unknowns> for Squeezer<INDEX> {
    fn diff(&self, _: f64, y: &Unknowns, derivative: &mut Unknowns) {
        let (q, v, w, multipliers) = parts(y);
        let (motion, constraints) = residuals::<f64, INDEX>(&q, &v, &w, &multipliers);
        derivative[..7].copy_from_slice(&v);
        derivative[7..14].copy_from_slice(&w);
        derivative[14..21].copy_from_slice(&motion);
        derivative[21..].copy_from_slice(&constraints);
    }

    fn mass(&self, mass: &mut Matrix<f64>) {
        for i in 0..14 {
            mass[(i, i)] = 1.0;
        }
    }

    fn jacobian(&self, _: f64, y: &Unknowns, jacobian: &mut Matrix<f64>) {
        Self::approximate(y, jacobian);
        if !self.is_exact {
            return;
        }
        let (_, _, w, multipliers) = parts(y);
        let x: [Dual<f64, 14>; 14] = Dual::variables(std::array::from_fn(|i| y[i]));
        let [q, v] = [0, 7].map(|first| std::array::from_fn(|i| x[first + i]));
        let (w, multipliers) = (w.map(Dual::constant), multipliers.map(Dual::constant));
        let (motion, constraints) = residuals::<Dual<f64, 14>, INDEX>(&q, &v, &w, &multipliers);
        for (i, row) in motion.iter().chain(&constraints).enumerate() {
            for (j, entry) in row.derivative.into_iter().enumerate() {
                jacobian[(14 + i, j)] = entry;
            }
        }
    }
}

/// The unknowns at a start, whose accelerations and multipliers the equations of index 1 give.
fn start(state: &[f64]) -> Result<Unknowns, String> {
    let mut y = [0.0; 27];
    y[..14].copy_from_slice(state.get(..14).ok_or("too few components")?);
    let mut residuals = [0.0; 27];
    let mut jacobian = Matrix::zeros(27, 27);
    Squeezer::<1> { is_exact: false }.diff(0.0, &y, &mut residuals);
    Squeezer::<1>::approximate(&y, &mut jacobian);
    let matrix = SMatrix::<f64, 13, 13>::from_fn(|i, j| jacobian[(14 + i, 14 + j)]);
    let right = SVector::<f64, 13>::from_fn(|i, _| -residuals[14 + i]);
    let found = matrix.lu().solve(&right).ok_or("a singular start")?;
    y[14..].copy_from_slice(found.as_slice());
    Ok(y)
}

fn solved<const INDEX: u8>(
    integration: &Integration,
    is_exact: bool,
    is_of_state: bool,
) -> Result<Integrated, String> {
    let Integration {
        tolerance,
        starts,
        end,
        at_least,
        ..
    } = integration;
    let start = start(starts.first().ok_or("no start")?)?;
    let tolerance = tolerance.ok_or("no tolerance")?;
    let mut absolute = [tolerance; 27];
    if is_of_state {
        absolute[14..].fill(1e12);
    }
    let system = Squeezer::<INDEX> { is_exact };
    let ((steps, end), seconds) = fewest_seconds(*at_least, || {
        let radau = ImplicitRungeKutta::radau5()
            .rtol([tolerance; 27])
            .atol(absolute);
        let radau = radau.max_steps(usize::MAX).max_rejects(usize::MAX);
        let radau = match INDEX {
            3 => {
                let radau = radau.index2_equations((7..14).collect::<Vec<_>>());
                radau.index3_equations((14..27).collect::<Vec<_>>())
            }
            2 => radau.index2_equations((14..27).collect::<Vec<_>>()),
            _ => radau,
        };
        let solution = IVP::dae(&system, 0.0, *end, start).method(radau).solve();
        let solution = solution.map_err(|error| format!("{error:.80?}"))?;
        let last = solution.y.last().ok_or("no state")?;
        Ok((solution.steps.total() as u64, last[..14].to_vec()))
    })?;
    Ok(Integrated {
        seconds,
        steps,
        events: 0,
        states: vec![end],
    })
}

fn main() -> ExitCode {
    answer_questions(|question| {
        let Question::Integrate(integration) = question else {
            return Err("this solver knows no energies".to_owned());
        };
        let is_exact = integration.method.contains(", exact");
        let is_of_state = integration.method.ends_with(", of state");
        let integrated = match integration.method.as_bytes().get(6) {
            Some(b'1') => solved::<1>(&integration, is_exact, is_of_state),
            Some(b'2') => solved::<2>(&integration, is_exact, is_of_state),
            Some(b'3') => solved::<3>(&integration, is_exact, is_of_state),
            _ => Err(format!("there is no method `{}`", integration.method)),
        }?;
        serde_json::to_value(&integrated).map_err(|error| error.to_string())
    })
}
