//! The integrated motion beside its closed forms, as text.

use std::fmt::Write;

use lagrangian::State;

use crate::model::HeavyTop;
use crate::nutation::Nutation;
use crate::record::Record;
use crate::symmetric_top::SymmetricTop;
use crate::turning_points::{Measured, measure};

/// Below this amplitude in rad a nutation is rounding error: the precession is steady.
const STEADY: f64 = 1e-9;

/// The comparison of a sampled motion with what is known in closed form.
pub(crate) fn comparison(
    top: &HeavyTop,
    records: &[Record],
    nutation: Option<&Nutation>,
    tolerance: f64,
) -> String {
    let Some(first) = records.first() else {
        return "There are no samples to compare.\n".into();
    };
    let Some(symmetric) = SymmetricTop::of(top) else {
        return "With i1 ≠ i2 the motion has no closed form in general: nothing is compared.\n"
            .into();
    };
    let mut text = match nutation {
        None => "The tilt has no period, for the axis reaches the vertical or rests: nothing is compared.\n"
            .into(),
        Some(closed) if closed.greatest_tilt() - closed.least_tilt() < STEADY => {
            format!(
                "The precession is steady: the tilt does not change.\n{}",
                closeness(closed, records)
            )
        }
        Some(closed) => match measured(top, records, closed, tolerance) {
            Ok(measured) => table(closed, &measured) + &closeness(closed, records),
            Err(reason) => reason + &closeness(closed, records),
        },
    };
    text.push('\n');
    text.push_str(&steady_precession(&symmetric, &first.state));
    text
}

/// The nutation of the samples, or why they do not show it.
fn measured(
    top: &HeavyTop,
    records: &[Record],
    closed: &Nutation,
    tolerance: f64,
) -> Result<Measured, String> {
    let states: Vec<_> = records.iter().map(|record| record.state).collect();
    let period = closed.period();
    // Between two samples θ̇ may vanish once; a quarter of a period is safe.
    if states
        .windows(2)
        .any(|pair| pair[1].t - pair[0].t > 0.25 * period)
    {
        return Err(format!(
            "The samples are too far apart to show the nutation, whose period is {period:.6} s.\n"
        ));
    }
    measure(top, &states, tolerance).ok_or_else(|| {
        format!("The motion holds no whole nutation, whose period is {period:.6} s.\n")
    })
}

/// How far the integrated nutation is from the closed form.
fn table(closed: &Nutation, measured: &Measured) -> String {
    let heading = format!("Nutation, over {} periods", measured.periods);
    let mut text = format!(
        "{heading:30}{:>20}{:>20}{:>14}\n",
        "integrated", "closed form", "difference"
    );
    let mut row = |name: &str, measured: f64, closed: f64, unit: &str| {
        let difference = measured - closed;
        let [measured, closed] = [measured, closed].map(|value| format!("{value:.12}{unit}"));
        let _ = writeln!(
            text,
            "  {name:28}{measured:>20}{closed:>20}{difference:>14.1e}"
        );
    };
    let mut angle = |name: &str, measured: f64, closed: f64| {
        row(name, measured.to_degrees(), closed.to_degrees(), "°");
    };
    angle("least tilt", measured.least_tilt, closed.least_tilt());
    angle(
        "greatest tilt",
        measured.greatest_tilt,
        closed.greatest_tilt(),
    );
    angle(
        "precession in a period",
        measured.precession,
        closed.precession(),
    );
    row("period", measured.period, closed.period(), " s");
    text
}

/// How far all samples are from the closed form.
fn closeness(closed: &Nutation, records: &[Record]) -> String {
    let farthest = records
        .iter()
        .map(|record| (record.state.q[HeavyTop::THETA] - closed.tilt_at(record.state.t)).abs())
        .fold(0.0, f64::max);
    format!(
        "  At all samples the tilt is within {:.1e}° of the closed form.\n",
        farthest.to_degrees()
    )
}

/// The steady precessions (4.11) at the initial tilt and ω₃.
fn steady_precession(top: &SymmetricTop, start: &State<f64, 3>) -> String {
    let tilt = start.q[HeavyTop::THETA];
    let axial_rate = start.v[HeavyTop::PSI] + start.v[HeavyTop::PHI] * tilt.cos();
    let found = match top.steady_precession(tilt, axial_rate).as_slice() {
        [slow, fast] => format!("slow {slow:.6} rad/s, fast {fast:.6} rad/s"),
        [only] => format!("{only:.6} rad/s, and no fast one"),
        _ => format!(
            "exists only from |ω₃| = {:.4} rad/s",
            top.least_axial_rate(tilt)
        ),
    };
    format!(
        "Steady precession at θ = {:.4}° and ω₃ = {axial_rate:.4} rad/s: {found}\n",
        tilt.to_degrees()
    )
}
