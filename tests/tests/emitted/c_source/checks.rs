//! The comparisons of functions in C and in Rust.

use super::point::Point;
use super::program::Check;

/// The functions that all models have; `$model` is the model with given inputs.
macro_rules! functions {
    ($n:literal, $c:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const C: usize = $c;
        let model = $model;
        let _ = C;
        vec![
            $crate::c_source::checks::check(
                "inverse dynamics",
                N,
                "$_inverse_dynamics(POINT, a, y);",
                move |point| {
                    let a = SVector::<f64, N>::from_column_slice(&point.a);
                    Some(
                        model(&point.u)
                            .inverse_dynamics(&point.state::<N>(), &a)
                            .as_slice()
                            .to_vec(),
                    )
                },
            ),
            $crate::c_source::checks::check("energy", 1, "y[0] = $_energy(POINT);", move |point| {
                Some(vec![model(&point.u).energy(&point.state::<N>())])
            }),
        ]
    }};
}

/// The functions of models without constraints.
macro_rules! free {
    ($n:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        let model = $model;
        let mut checks = $crate::c_source::checks::functions!($n, 0, $model);
        checks.push($crate::c_source::checks::check(
            "accelerations",
            N,
            "$_accelerations(POINT, y);",
            move |point| {
                Some(
                    model(&point.u)
                        .accelerations(&point.state::<N>())
                        .as_slice()
                        .to_vec(),
                )
            },
        ));
        checks.push($crate::c_source::checks::check(
            "step",
            2 * N,
            &format!("$_step(MOVED, h); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let method = RungeKutta::classical(point.h);
                let model = model(&point.u);
                let end = Problem::new(&model, point.state::<N>())
                    .solve(point.t + point.h, method)
                    .ok()?;
                Some([end.q.as_slice(), end.v.as_slice()].concat())
            },
        ));
        checks
    }};
}

/// The state matrix, and behind it the derivatives by the time.
macro_rules! state_matrix {
    ($n:literal, $model:expr, $of_inputs:literal) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const D: usize = 2 * $n;
        let model = $model;
        $crate::c_source::checks::check(
            "state matrix",
            D * D + N,
            &format!(
                concat!(
                    "double b[{D} * 64]; (void)b; $_linearize(POINT, y, ",
                    $of_inputs,
                    "y + {D} * {D});"
                ),
                D = D
            ),
            move |point| {
                let found = model(&point.u).linearize(&point.state::<N>());
                let by_rows = found.state_matrix::<D>().transpose();
                Some([by_rows.as_slice(), found.time.as_slice()].concat())
            },
        )
    }};
}

/// The same for a model with constraints: the accelerations are differentiated along each coordinate, each velocity and the time. With
/// `MOVED`, the state is projected before.
macro_rules! constrained_state_matrix {
    ($n:literal, $c:literal, $model:expr, $of_inputs:literal) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const D: usize = 2 * $n;
        let model = $model;
        let call = format!(
            concat!(
                "double b[{D} * 64]; (void)b; {PROJECTIONS} $_linearize(MOVED, y, ",
                $of_inputs,
                "y + {D} * {D});"
            ),
            D = D,
            PROJECTIONS = $crate::c_source::checks::PROJECTIONS
        );
        $crate::c_source::checks::check("state matrix", D * D + N, &call, move |point| {
            let model = model(&point.u);
            let state = $crate::c_source::checks::on_constraints!(model, point, N);
            let along = |i: usize| {
                let of = |first: usize| {
                    SVector::<f64, N>::from_fn(|j, _| f64::from(u8::from(first + j == i)))
                };
                let time = f64::from(u8::from(i == D));
                let direction = State::new(time, of(0), of(N));
                let inputs = model.inputs();
                let found =
                    lagrangian::quantities::DirectionalDerivatives::<N, { $c }>::derivatives_along(
                        &model, &state, &inputs, &direction,
                    );
                found.accelerations
            };
            let columns: Vec<_> = (0..=D).map(along).collect();
            let mut rows = vec![0.0; D * D];
            for i in 0..N {
                rows[i * D + N + i] = 1.0;
                for j in 0..D {
                    rows[(N + i) * D + j] = columns[j][i];
                }
            }
            rows.extend(columns[D].iter());
            Some(rows)
        })
    }};
}

/// The input matrix of a model with `$m` inputs.
macro_rules! input_matrix {
    ($n:literal, $m:literal, $model:expr, $call:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const M: usize = $m;
        let model = $model;
        $crate::c_source::checks::check("input matrix", 2 * N * M, &$call, move |point| {
            let found = model(&point.u)
                .input_jacobian::<M>(&point.state::<N>())
                .transpose();
            Some([&[0.0; N * M][..], found.as_slice()].concat())
        })
    }};
}

/// The derivatives by `$p` parameters.
macro_rules! sensitivities {
    ($n:literal, $p:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        let model = $model;
        let call = "$_sensitivities(POINT, y);";
        $crate::c_source::checks::check("sensitivities", $n * $p, call, move |point| {
            let found = model(&point.u).sensitivities::<$p>(&point.state::<$n>());
            Some(found.transpose().as_slice().to_vec())
        })
    }};
}

/// Projects the state until it meets constraints.
pub(super) const PROJECTIONS: &str = "for (int k = 0; k < 8; ++k) $_project(MOVED);";

/// The state that `PROJECTIONS` gives.
macro_rules! on_constraints {
    ($model:expr, $point:expr, $n:expr) => {{
        let mut state = $point.state::<{ $n }>();
        for _ in 0..8 {
            let on = $model.dynamics().project(state.t, &state.x)?.into_state();
            state = State::new(state.t, on.q, on.v);
        }
        state
    }};
}

/// The functions of models with constraints.
macro_rules! constrained {
    ($n:literal, $c:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        use $crate::c_source::checks::PROJECTIONS;
        const N: usize = $n;
        const C: usize = $c;
        let model = $model;
        let mut checks = $crate::c_source::checks::functions!($n, $c, $model);
        checks.push($crate::c_source::checks::check(
            "accelerations and multipliers",
            N + C,
            &format!("$_accelerations(POINT, y, y + {N});"),
            move |point| {
                let (model, state) = (model(&point.u), point.state::<N>());
                let (a, lambda) = (model.accelerations(&state), model.multipliers::<C>(&state));
                Some([a.as_slice(), lambda.as_slice()].concat())
            },
        ));
        checks.push($crate::c_source::checks::check(
            "projection",
            2 * N,
            &format!("$_project(MOVED); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let model = model(&point.u);
                let found = model.dynamics().project(point.t, &point.state::<N>().x)?.into_state();
                Some([found.q.as_slice(), found.v.as_slice()].concat())
            },
        ));
        checks.push($crate::c_source::checks::check(
            "step",
            2 * N,
            &format!("{PROJECTIONS} $_step(MOVED, h); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let (model, method) = (model(&point.u), RungeKutta::classical(point.h));
                let start = $crate::c_source::checks::on_constraints!(model, point, N);
                let end = Problem::new(&model, start).solve(point.t + point.h, method).ok()?;
                Some([end.q.as_slice(), end.v.as_slice()].concat())
            },
        ));
        checks
    }};
}

/// The numbers of a body, in the order of its struct in C.
macro_rules! body {
    ($body:expr) => {{
        let inertia = $body.inertia().matrix();
        let center = $body.center();
        [&[$body.mass()][..], center.as_slice(), inertia.as_slice()].concat()
    }};
}

pub(super) use {
    body, constrained, constrained_state_matrix, free, functions, input_matrix, on_constraints,
    sensitivities, state_matrix,
};

/// A function in C and in Rust.
pub(super) fn check(
    name: &'static str,
    count: usize,
    statements: &str,
    expected: impl Fn(&Point) -> Option<Vec<f64>> + 'static,
) -> Check {
    Check {
        name,
        statements: statements.to_owned(),
        count,
        expected: Box::new(expected),
        agreement: None,
    }
}
