//! The terms of the equations of Andrews' squeezing mechanism: M, f, the constraints and their derivatives.

use lagrangian::Scalar;

const M: [f64; 7] = [
    0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498,
];
const I: [f64; 7] = [
    2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5,
];
const A: [f64; 2] = [-0.06934, -0.00227];
const B: [f64; 2] = [-0.03635, 0.03273];
const C: [f64; 2] = [0.014, 0.072];
const STIFFNESS: f64 = 4530.0;
const REST: f64 = 0.07785;
const MOMENT: f64 = 0.033;
const D: f64 = 0.028;
const DA: f64 = 0.0115;
const E: f64 = 0.02;
const EA: f64 = 0.01421;
const RR: f64 = 0.007;
const RA: f64 = 0.00092;
const SS: f64 = 0.035;
const SA: f64 = 0.01874;
const SB: f64 = 0.01043;
const SC: f64 = 0.018;
const SD: f64 = 0.02;
const TA: f64 = 0.02308;
const TB: f64 = 0.00916;
const U: f64 = 0.04;
const UA: f64 = 0.01228;
const UB: f64 = 0.00449;
const ZF: f64 = 0.02;
const ZT: f64 = 0.04;
const FA: f64 = 0.01421;

/// The sines and cosines at a configuration.
pub(crate) struct Angles<S> {
    beta: [S; 2],
    theta: [S; 2],
    beta_theta: [S; 2],
    gamma: [S; 2],
    phi: [S; 2],
    delta: [S; 2],
    phi_delta: [S; 2],
    omega: [S; 2],
    epsilon: [S; 2],
    omega_epsilon: [S; 2],
}

fn of<S: Scalar>(x: f64) -> S {
    S::from_f64(x)
}

impl<S: Scalar> Angles<S> {
    #[inline(always)]
    pub(crate) fn at([be, th, ga, ph, de, om, ep]: &[S; 7]) -> Self {
        let pair = |x: S| {
            let (s, c) = x.sin_cos();
            [s, c]
        };
        Self {
            beta: pair(*be),
            theta: pair(*th),
            beta_theta: pair(*be + *th),
            gamma: pair(*ga),
            phi: pair(*ph),
            delta: pair(*de),
            phi_delta: pair(*ph + *de),
            omega: pair(*om),
            epsilon: pair(*ep),
            omega_epsilon: pair(*om + *ep),
        }
    }
    /// M w.
    #[inline(always)]
    pub(crate) fn momenta(&self, w: &[S; 7]) -> [S; 7] {
        let m = self.mass();
        [
            m[0] * w[0] + m[1] * w[1],
            m[1] * w[0] + m[2] * w[1],
            m[3] * w[2],
            m[4] * w[3] + m[5] * w[4],
            m[5] * w[3] + m[6] * w[4],
            m[7] * w[5] + m[8] * w[6],
            m[8] * w[5] + m[9] * w[6],
        ]
    }
    /// M11, M21, M22, M33, M44, M54, M55, M66, M76, M77.
    #[inline(always)]
    pub(crate) fn mass(&self) -> [S; 10] {
        let c = self.theta[1] * of::<S>(DA * RR);
        let sp = self.phi[0] * of::<S>(ZT * (E - EA));
        let so = self.omega[0] * of::<S>(U * (ZF - FA));
        const P: f64 = (E - EA) * (E - EA);
        const Z: f64 = (ZF - FA) * (ZF - FA);
        [
            c * of::<S>(-2.0 * M[1])
                + of::<S>(M[0] * RA * RA + M[1] * (RR * RR + DA * DA) + I[0] + I[1]),
            c * of::<S>(-M[1]) + of::<S>(M[1] * DA * DA + I[1]),
            of(M[1] * DA * DA + I[1]),
            of(M[2] * (SA * SA + SB * SB) + I[2]),
            of(M[3] * P + I[3]),
            sp * of::<S>(M[3]) + of::<S>(M[3] * P + I[3]),
            sp * of::<S>(2.0 * M[3])
                + of::<S>(M[3] * (ZT * ZT + P) + M[4] * (TA * TA + TB * TB) + I[3] + I[4]),
            of(M[5] * Z + I[5]),
            so * of::<S>(-M[5]) + of::<S>(M[5] * Z + I[5]),
            so * of::<S>(-2.0 * M[5])
                + of::<S>(M[5] * (Z + U * U) + M[6] * (UA * UA + UB * UB) + I[5] + I[6]),
        ]
    }
    #[inline(always)]
    pub(crate) fn forces(&self, v: &[S; 7]) -> [S; 7] {
        let [bep, thp, _, php, dep, omp, epp] = *v;
        let two = of::<S>(2.0);
        let [sg, cg] = self.gamma;
        let (rx, ry) = (
            cg * of::<S>(SD) + sg * of::<S>(SC),
            sg * of::<S>(SD) - cg * of::<S>(SC),
        );
        let (dx, dy) = (rx + of::<S>(B[0] - C[0]), ry + of::<S>(B[1] - C[1]));
        let length = (dx * dx + dy * dy).sqrt();
        let force = (of::<S>(REST) / length - S::one()) * of::<S>(STIFFNESS);
        let a = self.theta[0] * of::<S>(M[1] * DA * RR);
        let b = self.phi[1] * of::<S>(M[3] * ZT * (E - EA));
        let c = self.omega[1] * of::<S>(M[5] * U * (ZF - FA));
        [
            of::<S>(MOMENT) - a * thp * (thp + two * bep),
            a * bep * bep,
            force * (dy * rx - dx * ry),
            b * dep * dep,
            -b * php * (php + two * dep),
            -c * epp * epp,
            c * omp * (omp + two * epp),
        ]
    }
    /// The columns of G: of β and θ in all loops, of γ in the first, of φ and δ in the second, of Ω and ε in the third.
    #[inline(always)]
    pub(crate) fn gradient(&self) -> [[S; 2]; 7] {
        let scaled = |[s, c]: [S; 2], l: f64| [s * of::<S>(l), c * of::<S>(l)];
        let [rs, rc] = scaled(self.beta, RR);
        let [ds, dc] = scaled(self.beta_theta, D);
        let [gs, gc] = scaled(self.gamma, SS);
        let [es, ec] = scaled(self.phi_delta, E);
        let [ts, tc] = scaled(self.delta, ZT);
        let [zs, zc] = scaled(self.omega_epsilon, ZF);
        let [us, uc] = scaled(self.epsilon, U);
        [
            [ds - rs, rc - dc],
            [ds, -dc],
            [-gc, -gs],
            [-ec, -es],
            [ts - ec, -es - tc],
            [zs, -zc],
            [zs - uc, -zc - us],
        ]
    }
    /// Gᵀ λ.
    #[inline(always)]
    pub(crate) fn reactions(&self, l: &[S; 6]) -> [S; 7] {
        let g = self.gradient();
        let (x, y) = (l[0] + l[2] + l[4], l[1] + l[3] + l[5]);
        let dot = |g: [S; 2], x: S, y: S| g[0] * x + g[1] * y;
        [
            dot(g[0], x, y),
            dot(g[1], x, y),
            dot(g[2], l[0], l[1]),
            dot(g[3], l[2], l[3]),
            dot(g[4], l[2], l[3]),
            dot(g[5], l[4], l[5]),
            dot(g[6], l[4], l[5]),
        ]
    }
    /// G v.
    #[inline(always)]
    pub(crate) fn rates(&self, v: &[S; 7]) -> [S; 6] {
        let g = self.gradient();
        std::array::from_fn(|i| {
            let k = i % 2;
            let joint = g[0][k] * v[0] + g[1][k] * v[1];
            joint
                + match i / 2 {
                    0 => g[2][k] * v[2],
                    1 => g[3][k] * v[3] + g[4][k] * v[4],
                    _ => g[5][k] * v[5] + g[6][k] * v[6],
                }
        })
    }
    /// The residuals of the loops.
    #[inline(always)]
    pub(crate) fn loops(&self) -> [S; 6] {
        let [jx, jy] = self.joint(S::one(), S::one());
        let l = self.levers([S::one(); 5]);
        [
            jx - l[0][0] - of::<S>(B[0]),
            jy - l[0][1] - of::<S>(B[1]),
            jx - l[1][0] - of::<S>(A[0]),
            jy - l[1][1] - of::<S>(A[1]),
            jx - l[2][0] - of::<S>(A[0]),
            jy - l[2][1] - of::<S>(A[1]),
        ]
    }
    /// −γ: the second derivative of the loops at w = 0.
    #[inline(always)]
    pub(crate) fn curvatures(&self, v: &[S; 7]) -> [S; 6] {
        let square = |x: S| x * x;
        let [jx, jy] = self.joint(square(v[0]), square(v[0] + v[1]));
        let l = self.levers([
            square(v[2]),
            square(v[4]),
            square(v[3] + v[4]),
            square(v[6]),
            square(v[5] + v[6]),
        ]);
        [
            l[0][0] - jx,
            l[0][1] - jy,
            l[1][0] - jx,
            l[1][1] - jy,
            l[2][0] - jx,
            l[2][1] - jy,
        ]
    }
    #[inline(always)]
    fn joint(&self, a: S, b: S) -> [S; 2] {
        let (a, b) = (a * of::<S>(RR), b * of::<S>(D));
        [
            self.beta[1] * a - self.beta_theta[1] * b,
            self.beta[0] * a - self.beta_theta[0] * b,
        ]
    }
    #[inline(always)]
    fn levers(&self, [a, b, c, d, e]: [S; 5]) -> [[S; 2]; 3] {
        let (a, b, c, d, e) = (
            a * of::<S>(SS),
            b * of::<S>(ZT),
            c * of::<S>(E),
            d * of::<S>(U),
            e * of::<S>(ZF),
        );
        [
            [self.gamma[0] * a, -self.gamma[1] * a],
            [
                self.delta[1] * b + self.phi_delta[0] * c,
                self.delta[0] * b - self.phi_delta[1] * c,
            ],
            [
                self.epsilon[0] * d + self.omega_epsilon[1] * e,
                self.omega_epsilon[0] * e - self.epsilon[1] * d,
            ],
        ]
    }
}
