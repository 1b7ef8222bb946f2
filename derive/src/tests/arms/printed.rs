//! The recursion of Newton and Euler as it is printed: code that is written from the lines of the page has the values of the
//! program of inverse dynamics.

use lagrangian_symbolic::Symbol;
use proc_macro2::TokenStream;
use quote::quote;

use super::kane::{M, Numbers, V, add, apply, cross, elementary, scaled, transposed};
use super::{arm, assert_near, derived, values};
use crate::expand::expand;
use crate::tests::pages::constant;

/// A link by the rows of the page.
struct Row {
    /// p, of which 0 is the frame at rest.
    before: usize,
    /// R.
    turn: M,
    /// s and its rates, along the axes of the link before.
    place: [V; 3],
    /// σ and its rate.
    rate: [V; 2],
    /// m, the centre and I.
    mass: f64,
    center: V,
    tensor: M,
}

/// n and f of all links, by the statements of the page; the links count from 1.
fn moments_and_forces(rows: &[Row], base: V) -> Vec<[V; 2]> {
    let zero = [0.0; 3];
    let (mut turning, mut turning_rate, mut acceleration) = (vec![zero], vec![zero], vec![base]);
    for row in rows {
        let back = transposed(&row.turn);
        let (w, w_rate) = (turning[row.before], turning_rate[row.before]);
        let carried = apply(&back, w);
        turning.push(add(carried, row.rate[0]));
        let rate = add(apply(&back, w_rate), cross(carried, row.rate[0]));
        turning_rate.push(add(rate, row.rate[1]));
        let [s, s_rate, s_change] = row.place;
        let mut sum = add(acceleration[row.before], cross(w_rate, s));
        sum = add(sum, cross(w, cross(w, s)));
        sum = add(sum, add(scaled(2.0, cross(w, s_rate)), s_change));
        acceleration.push(apply(&back, sum));
    }
    let mut found = vec![[zero; 2]; rows.len() + 1];
    for (i, row) in rows.iter().enumerate().map(|(i, row)| (i + 1, row)).rev() {
        let (w, w_rate) = (turning[i], turning_rate[i]);
        let own = add(cross(w_rate, row.center), cross(w, cross(w, row.center)));
        let inertial = scaled(row.mass, add(acceleration[i], own));
        let spin = cross(w, apply(&row.tensor, w));
        let moment = add(apply(&row.tensor, w_rate), spin);
        let [behind_moment, behind_force] = found[i];
        let force = add(inertial, behind_force);
        let moment = add(add(moment, cross(row.center, inertial)), behind_moment);
        found[i] = [moment, force];
        let turned = apply(&row.turn, force);
        let lever = add(apply(&row.turn, moment), cross(row.place[0], turned));
        let [sum_of_moments, sum_of_forces] = found[row.before];
        found[row.before] = [add(sum_of_moments, lever), add(sum_of_forces, turned)];
    }
    found
}

#[track_caller]
fn page(declaration: TokenStream, lines: &[&str]) {
    let page = constant(&expand(declaration), "EQUATIONS");
    for line in lines {
        assert!(page.lines().any(|found| found == *line), "{line}\n{page}");
    }
}

/// The numbers of a state: q, q̇ and q̈, and parameters.
fn state(numbers: &mut Numbers, coordinates: usize, parameters: usize) -> [Vec<f64>; 4] {
    let [q, v, a] = [(); 3].map(|()| (0..coordinates).map(|_| numbers.next()).collect());
    [
        q,
        v,
        a,
        (0..parameters).map(|_| 1.4 + numbers.next()).collect(),
    ]
}

fn value([q, v, a, parameters]: &[Vec<f64>; 4]) -> impl Fn(Symbol) -> f64 {
    move |symbol| match symbol {
        Symbol::Coordinate(i) => q[i as usize],
        Symbol::Velocity(i) => v[i as usize],
        Symbol::Acceleration(i) => a[i as usize],
        Symbol::Parameter(i) => parameters[i as usize],
        _ => f64::NAN,
    }
}

fn along(axis: usize, size: f64) -> V {
    let mut vector = [0.0; 3];
    vector[axis] = size;
    vector
}

#[test]
fn the_recursion_of_an_arm_is_its_inverse_dynamics() {
    page(
        arm(4),
        &[
            "ωᵢ = Rᵢᵀ ωᵢ₋₁ + σᵢ",
            "ω\u{307}ᵢ = Rᵢᵀ ω\u{307}ᵢ₋₁ + Rᵢᵀ ωᵢ₋₁ × σᵢ + σ\u{307}ᵢ",
            "aᵢ = Rᵢᵀ (aᵢ₋₁ + ω\u{307}ᵢ₋₁ × sᵢ + ωᵢ₋₁ × (ωᵢ₋₁ × sᵢ))",
            "Fᵢ = mᵢ (aᵢ + ω\u{307}ᵢ × ρᵢ + ωᵢ × (ωᵢ × ρᵢ))",
            "fᵢ = Fᵢ + Rᵢ₊₁ fᵢ₊₁",
            "nᵢ = Iᵢ ω\u{307}ᵢ + ωᵢ × Iᵢ ωᵢ + ρᵢ × Fᵢ + Rᵢ₊₁ nᵢ₊₁ + sᵢ₊₁ × Rᵢ₊₁ fᵢ₊₁",
            "R₀ = R_z(q₀)",
            "R₁ = R_y(q₁)",
            "R₂ = R_x(q₂)",
            "R₃ = R_y(q₃)",
            "s₀ = 0",
            "sᵢ = linkᵢ₋₁  (i = 1, 2, 3)",
            "σ₀ = q\u{307}₀ e_z",
            "σ₃ = q\u{307}₃ e_y",
            "ρᵢ = centerᵢ  (i = 0, …, 3)",
            "Iᵢ = ½ (inertiaᵢ + inertiaᵢᵀ)  (i = 0, …, 3)",
            "n₀_z = 0",
            "n₁_y = 0",
            "n₂_x = 0",
            "n₃_y = 0",
        ],
    );
    let derived = derived(arm(4));
    for seed in 0..4 {
        let state = state(&mut Numbers::new(seed), 4, 4 + 12 + 12 + 36 + 1);
        let [q, v, a, parameters] = &state;
        let axes = [2, 1, 0, 1];
        let vector = |start: usize| [0, 1, 2].map(|k| parameters[start + k]);
        let rows = (0..4).map(|i| Row {
            before: i,
            turn: elementary(axes[i], q[i]),
            place: match i {
                0 => [[0.0; 3]; 3],
                _ => [vector(4 + 3 * (i - 1)), [0.0; 3], [0.0; 3]],
            },
            rate: [along(axes[i], v[i]), along(axes[i], a[i])],
            mass: parameters[i],
            center: vector(16 + 3 * i),
            tensor: {
                let rows = [0, 3, 6].map(|start| vector(28 + 9 * i + start));
                let columns = transposed(&rows);
                [0, 1, 2].map(|k| scaled(0.5, add(rows[k], columns[k])))
            },
        });
        let gravity = along(2, parameters[64]);
        let found = moments_and_forces(&rows.collect::<Vec<_>>(), gravity);
        let found: Vec<_> = (0..4).map(|i| found[i + 1][0][axes[i]]).collect();
        let expected = values(&derived, &derived.methods.inverse_dynamics, value(&state));
        assert_near(&found, &expected);
    }
}

/// A tower on a slide, with an arm at its side and a load that slides along it.
fn tower() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[4]),
            define(
                tower = rotation_z(q[1]),
                arm = tower * rotation_y(q[2]),
                foot = [q[0], 0.0, 0.0],
                place[0] = foot + tower * center[0],
                place[1] = foot + tower * [0.0, d[0], d[1]] + arm * center[1],
                place[2] = foot + tower * [d[2] + q[3], 0.0, d[1]],
                w = angular_velocity(tower),
                u = angular_velocity(arm),
            ),
            kinetic = (0..3).map(|i| 0.5 * m[i] * dot(place[i]).norm_squared()).sum(),
            kinetic = 0.5 * (j[0].x * w.x.powi(2) + j[0].y * w.y.powi(2) + j[0].z * w.z.powi(2)),
            kinetic = 0.5 * (j[1].x * u.x.powi(2) + j[1].y * u.y.powi(2) + j[1].z * u.z.powi(2)),
            potential = (0..3).map(|i| m[i] * g * place[i].z).sum() + 0.5 * k * q[3].powi(2),
            force(q[0] = -h * dot(q[0])),
        )]
        struct Tower {
            m: [f64; 3],
            center: [Vector3<f64>; 2],
            j: [Vector3<f64>; 2],
            d: [f64; 3],
            g: f64,
            k: f64,
            h: f64,
        }
    }
}

/// What is printed of it.
const TOWER: [&str; 28] = [
    "ωᵢ = Rᵢᵀ ω_p + σᵢ",
    "aᵢ = Rᵢᵀ (a_p + ω\u{307}_p × sᵢ + ω_p × (ω_p × sᵢ) + 2 ω_p × s\u{307}ᵢ + s\u{308}ᵢ)",
    "Fᵢ = μᵢ (aᵢ + ω\u{307}ᵢ × cᵢ + ωᵢ × (ωᵢ × cᵢ))",
    "fᵢ = Fᵢ + Σⱼ Rⱼ fⱼ",
    "nᵢ = Iᵢ ω\u{307}ᵢ + ωᵢ × Iᵢ ωᵢ + cᵢ × Fᵢ + Σⱼ (Rⱼ nⱼ + sⱼ × Rⱼ fⱼ)",
    "p(1) = 0",
    "p(2) = 1",
    "p(3) = 1",
    "R₁ = R_z(q₁)",
    "R₂ = R_y(q₂)",
    "R₃ = 1",
    "s₁ = q₀ e_x",
    "s₂ = (0, d₀, d₁)",
    "s₃ = (q₃ + d₂, 0, d₁)",
    "σ₁ = q\u{307}₁ e_z",
    "σ₂ = q\u{307}₂ e_y",
    "σ₃ = 0",
    "μᵢ = mᵢ₋₁  (i = 1, 2, 3)",
    "c₁ = center₀",
    "c₂ = center₁",
    "c₃ = 0",
    "I₁ = diag(j₀_x, j₀_y, j₀_z)",
    "I₂ = diag(j₁_x, j₁_y, j₁_z)",
    "I₃ = 0",
    "(R₁ f₁)_x = −h q\u{307}₀",
    "n₁_z = 0",
    "n₂_y = 0",
    "f₃_x + k q₃ = 0",
];

#[test]
fn the_recursion_of_links_that_branch_and_slide_is_their_inverse_dynamics() {
    page(tower(), &TOWER);
    let derived = derived(tower());
    for seed in 0..4 {
        let state = state(&mut Numbers::new(seed), 4, 21);
        let [q, v, a, parameters] = &state;
        let vector = |start: usize| [0, 1, 2].map(|k| parameters[start + k]);
        let [m, d] = [vector(0), vector(15)];
        let diagonal = |[x, y, z]: V| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        let zero = [0.0; 3];
        let rows = [
            Row {
                before: 0,
                turn: elementary(2, q[1]),
                place: [along(0, q[0]), along(0, v[0]), along(0, a[0])],
                rate: [along(2, v[1]), along(2, a[1])],
                mass: m[0],
                center: vector(3),
                tensor: diagonal(vector(9)),
            },
            Row {
                before: 1,
                turn: elementary(1, q[2]),
                place: [[0.0, d[0], d[1]], zero, zero],
                rate: [along(1, v[2]), along(1, a[2])],
                mass: m[1],
                center: vector(6),
                tensor: diagonal(vector(12)),
            },
            Row {
                before: 1,
                turn: diagonal([1.0; 3]),
                place: [[q[3] + d[2], 0.0, d[1]], along(0, v[3]), along(0, a[3])],
                rate: [zero; 2],
                mass: m[2],
                center: zero,
                tensor: [zero; 3],
            },
        ];
        let found = moments_and_forces(&rows, along(2, parameters[18]));
        let slide = apply(&rows[0].turn, found[1][1])[0];
        let [spring, damper] = [parameters[19] * q[3], parameters[20] * v[0]];
        let found = [
            slide + damper,
            found[1][0][2],
            found[2][0][1],
            found[3][1][0] + spring,
        ];
        let expected = values(&derived, &derived.methods.inverse_dynamics, value(&state));
        assert_near(&found, &expected);
    }
}
