//! The arm that is measured: its parameters, and the fewer ones that its motion depends on.

use serde_json::{Value, json};

use crate::states::uniform;

/// Rows.
pub(super) type Matrix = [[f64; 3]; 3];

/// The tensor of inertia of each link about its centre of mass.
pub(crate) const INERTIA: Matrix = [[0.1, 0.01, 0.002], [0.01, 0.2, 0.003], [0.002, 0.003, 0.15]];
/// From the origin of a link to the next.
pub(crate) const LINK: [f64; 3] = [0.05, 0.02, 0.5];
/// The centre of mass of each link.
pub(crate) const CENTER: [f64; 3] = [0.01, 0.02, 0.25];
pub(crate) const GRAVITY: f64 = 9.81;

/// The mass of a link.
#[allow(clippy::cast_precision_loss)] // Some tens.
pub(crate) fn mass(link: usize) -> f64 {
    1.0 + 0.1 * link as f64
}

/// The axis of a joint: z, y, x, y, and again.
pub(crate) const fn axis(link: usize) -> usize {
    [2, 1, 0, 1][link % 4]
}

/// What a link carries, in base inertial parameters (Gautier and Khalil, Direct calculation of minimum set of inertial
/// parameters of serial robots, 1990): no mass, and neither moment along its axis.
pub(super) struct Link {
    /// The origin in the link before.
    pub(super) place: [f64; 3],
    pub(super) first: [f64; 3],
    /// Σ m r rᵀ.
    pub(super) second: Matrix,
}

/// The links, with origins that have been moved along the joint axes, so that no place has a component along its own.
pub(super) fn links(count: usize) -> Vec<Link> {
    let mut slides = vec![0.0; count];
    let mut links = Vec::with_capacity(count);
    let mut masses = Vec::with_capacity(count);
    for i in 0..count {
        let mut place = [0.0; 3];
        if i > 0 {
            place = LINK;
            place[axis(i - 1)] -= slides[i - 1];
        }
        // The origin moves by what the place has along the axis; that of the first stays.
        slides[i] = if i == 0 { 0.0 } else { -place[axis(i)] };
        place[axis(i)] = 0.0;
        let mut center = CENTER;
        center[axis(i)] -= slides[i];
        let half_trace = (0..3).map(|i| INERTIA[i][i]).sum::<f64>() / 2.0;
        let m = mass(i);
        let second = [0, 1, 2].map(|x: usize| {
            [0, 1, 2].map(|y: usize| {
                let diagonal = if x == y { half_trace } else { 0.0 };
                diagonal - INERTIA[x][y] + m * center[x] * center[y]
            })
        });
        links.push(Link {
            place,
            first: center.map(|x| m * x),
            second,
        });
        masses.push(m);
    }
    for i in (1..count).rev() {
        let k = axis(i);
        let place = links[i].place;
        let (m, first, second) = (masses[i], links[i].first[k], links[i].second[k][k]);
        links[i].first[k] = 0.0;
        links[i].second[k][k] = 0.0;
        let mut along = [0.0; 3];
        along[k] = first;
        let before = &mut links[i - 1];
        for x in 0..3 {
            before.first[x] += m * place[x] + along[x];
            for y in 0..3 {
                before.second[x][y] +=
                    m * place[x] * place[y] + along[x] * place[y] + place[x] * along[y];
            }
        }
        before.second[k][k] += second;
        masses[i - 1] += m;
    }
    links
}

/// The arm for a script: what its motion depends on, and what is declared.
pub(super) fn description(count: usize) -> Value {
    let links: Vec<_> = links(count)
        .iter()
        .enumerate()
        .map(|(i, link)| {
            json!({
                "axis": axis(i),
                "place": link.place,
                "first": link.first,
                "second": link.second,
            })
        })
        .collect();
    let bodies: Vec<_> = (0..count)
        .map(|i| json!({ "mass": mass(i), "link": LINK, "center": CENTER, "inertia": INERTIA }))
        .collect();
    json!({ "gravity": GRAVITY, "links": links, "bodies": bodies })
}

/// States, pseudo-random: coordinates, velocities and accelerations.
pub(super) fn states(links: usize) -> Vec<Vec<f64>> {
    let mut uniform = uniform();
    let mut row = || {
        let component = |i| {
            let size = if i < links { 3.0 } else { 1.0 };
            size * (2.0 * uniform() - 1.0)
        };
        (0..3 * links).map(component).collect()
    };
    (0..256).map(|_| row()).collect()
}
