//! The dynamics of a serial arm in plain numbers, along inertial axes: partial velocities and inertia forces (Kane and
//! Levinson, Dynamics: Theory and Applications, 1985, section 4.11). It shares nothing with what is derived: no
//! recursion in body axes, no elimination along the arm.

/// Three components.
pub(super) type V = [f64; 3];
/// Rows.
pub(super) type M = [V; 3];

/// Numbers that look random, the same on every run (Marsaglia, Xorshift RNGs, 2003).
pub(super) struct Numbers(u64);

impl Numbers {
    pub(super) fn new(seed: u64) -> Self {
        Self(0x0139_408d_cbbf_7a44 ^ (seed << 20))
    }

    /// Between −1 and 1.
    pub(super) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let high = u32::try_from(self.0 >> 32).unwrap_or(u32::MAX);
        f64::from(high) / f64::from(1_u32 << 31) - 1.0
    }

    fn vector(&mut self) -> V {
        [0; 3].map(|_| self.next())
    }
}

/// The parameters of an arm.
pub(super) struct Arm {
    mass: Vec<f64>,
    link: Vec<V>,
    center: Vec<V>,
    inertia: Vec<M>,
    gravity: f64,
}

impl Arm {
    pub(super) fn new(links: usize, numbers: &mut Numbers) -> Self {
        let inertia = (0..links).map(|_| {
            let [x, y, z] = numbers.vector().map(|x| 0.05 * x);
            let [a, b, c] = numbers.vector().map(|x| 0.4 + 0.1 * x);
            [[a, x, y], [x, b, z], [y, z, c]]
        });
        Self {
            inertia: inertia.collect(),
            mass: (0..links).map(|_| 1.5 + numbers.next()).collect(),
            link: (0..links).map(|_| numbers.vector()).collect(),
            center: (0..links).map(|_| numbers.vector()).collect(),
            gravity: 9.81,
        }
    }

    /// The parameters in the order of the fields of the declaration.
    pub(super) fn parameters(&self) -> Vec<f64> {
        let mut parameters = self.mass.clone();
        parameters.extend(self.link.iter().flatten());
        parameters.extend(self.center.iter().flatten());
        parameters.extend(self.inertia.iter().flatten().flatten());
        parameters.push(self.gravity);
        parameters
    }

    /// M, row by row, and the forces that M q̈ + b takes at rest of the accelerations: b.
    pub(super) fn equations(&self, q: &[f64], v: &[f64]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let n = self.mass.len();
        let mut turn: M = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (mut origin, mut origin_acceleration) = ([0.0; 3], [0.0, 0.0, self.gravity]);
        let (mut rate, mut rate_change) = ([0.0; 3], [0.0; 3]);
        let (mut axes, mut origins) = (Vec::new(), Vec::new());
        let (mut mass, mut bias) = (vec![vec![0.0; n]; n], vec![0.0; n]);
        for i in 0..n {
            let axis = [2, 1, 0, 1][i % 4];
            turn = times(&turn, &elementary(axis, q[i]));
            let axis = [0, 1, 2].map(|row: usize| turn[row][axis]);
            rate_change = add(rate_change, scaled(v[i], cross(rate, axis)));
            rate = add(rate, scaled(v[i], axis));
            axes.push(axis);
            origins.push(origin);
            let centre = apply(&turn, self.center[i]);
            let back = transposed(&turn);
            let tensor = times(&times(&turn, &self.inertia[i]), &back);
            let acceleration = add(origin_acceleration, swing(rate, rate_change, centre));
            let momentum = apply(&tensor, rate);
            let moment = add(apply(&tensor, rate_change), cross(rate, momentum));
            let place = add(origin, centre);
            let partial = |j: usize| cross(axes[j], subtract(place, origins[j]));
            for j in 0..=i {
                bias[j] += self.mass[i] * dot(partial(j), acceleration) + dot(axes[j], moment);
                for k in 0..=i {
                    mass[j][k] += self.mass[i] * dot(partial(j), partial(k))
                        + dot(axes[j], apply(&tensor, axes[k]));
                }
            }
            let link = apply(&turn, self.link[i]);
            origin_acceleration = add(origin_acceleration, swing(rate, rate_change, link));
            origin = add(origin, link);
        }
        (mass, bias)
    }
}

/// x in A x = b, by Gauss's elimination of a positive definite matrix.
pub(super) fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for i in 0..n {
        for j in i + 1..n {
            let factor = matrix[j][i] / matrix[i][i];
            let row = matrix[i].clone();
            for (entry, above) in matrix[j].iter_mut().zip(row).skip(i) {
                *entry -= factor * above;
            }
            right[j] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    right
}

/// α × r + ω × (ω × r).
fn swing(rate: V, rate_change: V, place: V) -> V {
    add(cross(rate_change, place), cross(rate, cross(rate, place)))
}

/// The rotation by an angle about a coordinate axis.
pub(super) fn elementary(axis: usize, angle: f64) -> M {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = [[0.0; 3]; 3];
    matrix[axis][axis] = 1.0;
    matrix[j][j] = angle.cos();
    matrix[k][k] = angle.cos();
    matrix[j][k] = -angle.sin();
    matrix[k][j] = angle.sin();
    matrix
}

pub(super) fn dot(x: V, y: V) -> f64 {
    x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
}

pub(super) fn add(x: V, y: V) -> V {
    [0, 1, 2].map(|i| x[i] + y[i])
}

pub(super) fn subtract(x: V, y: V) -> V {
    [0, 1, 2].map(|i| x[i] - y[i])
}

pub(super) fn scaled(factor: f64, x: V) -> V {
    x.map(|x| factor * x)
}

pub(super) fn cross(x: V, y: V) -> V {
    [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ]
}

pub(super) fn apply(matrix: &M, x: V) -> V {
    matrix.map(|row| dot(row, x))
}

pub(super) fn transposed(matrix: &M) -> M {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| matrix[j][i]))
}

fn times(x: &M, y: &M) -> M {
    let columns = transposed(y);
    x.map(|row| columns.map(|column| dot(row, column)))
}
