//! What is kept of the motion at each sample.

use lagrangian::{Lagrangian, State};

use crate::model::HeavyTop;

/// A sample of the motion, and what (4.8) and (4.10) say should not change with it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    /// Time in s, angles in rad, rates in rad/s.
    pub(crate) state: State<f64, 3>,
    /// The energy in J, from the height of the pivot.
    pub(crate) energy: f64,
    /// The angular momentum `C_φ` about the vertical in kg m²/s.
    pub(crate) c_phi: f64,
    /// The angular momentum `C_ψ` about the third principal axis in kg m²/s.
    pub(crate) c_psi: f64,
    /// How far these three are from their first values, relative to [`Scales`].
    pub(crate) errors: [f64; 3],
}

/// The sizes that errors of energy, `C_φ` and `C_ψ` are relative to. They do not vanish where terms of
/// opposite sign cancel: the energy is measured by T + |V|, both momenta by the larger of the two.
type Scales = [f64; 3];

/// The records of a motion that was sampled at `states`.
pub(crate) fn records(top: &HeavyTop, states: &[State<f64, 3>]) -> Vec<Record> {
    let Some(first) = states.first() else {
        return Vec::new();
    };
    let initial = constants(top, first);
    let scales = scales(top, first);
    let record = |state: &State<f64, 3>| {
        let now = constants(top, state);
        Record {
            state: *state,
            energy: now[0],
            c_phi: now[1],
            c_psi: now[2],
            errors: std::array::from_fn(|i| (now[i] - initial[i]) / scales[i]),
        }
    };
    states.iter().map(record).collect()
}

/// The largest magnitudes of the errors of energy, `C_φ` and `C_ψ` in a motion.
pub(crate) fn largest_errors(records: &[Record]) -> [f64; 3] {
    records.iter().fold([0.0; 3], |most, record| {
        std::array::from_fn(|i| most[i].max(record.errors[i].abs()))
    })
}

/// Energy, `C_φ` and `C_ψ` at a state.
fn constants(top: &HeavyTop, state: &State<f64, 3>) -> [f64; 3] {
    let momenta = top.momenta(state);
    [
        top.energy(state),
        momenta[HeavyTop::PHI],
        momenta[HeavyTop::PSI],
    ]
}

/// The scales of a motion that starts at `state`; 1 where nothing moves and nothing weighs.
fn scales(top: &HeavyTop, state: &State<f64, 3>) -> Scales {
    let [_, c_phi, c_psi] = constants(top, state);
    let energy = top.kinetic_energy(state) + top.potential_energy(state).abs();
    let momentum = c_phi.abs().max(c_psi.abs());
    [energy, momentum, momentum].map(|scale| if scale > 0.0 { scale } else { 1.0 })
}
