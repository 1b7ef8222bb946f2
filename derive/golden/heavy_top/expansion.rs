/**# The equations of motion

M q̈ = f, by d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with

```text
q = (φ, θ, ψ)
w₁ = θ̇ cos ψ + φ̇ sin θ sin ψ
w₂ = φ̇ sin θ cos ψ − θ̇ sin ψ
w₃ = ψ̇ + φ̇ cos θ
T = ½ i₂ w₂² + ½ i₁ w₁² + ½ i₃ w₃²
V = m g l cos θ
p[φ] = i₂ w₂ sin θ cos ψ + i₁ w₁ sin θ sin ψ + i₃ w₃ cos θ
p[θ] = i₁ w₁ cos ψ − i₂ w₂ sin ψ
p[ψ] = i₃ w₃
M[φ, φ] = i₂ sin²θ cos²ψ + i₁ sin²θ sin²ψ + i₃ cos²θ
M[θ, φ] = i₁ sin θ sin ψ cos ψ − i₂ sin θ sin ψ cos ψ
M[θ, θ] = i₂ sin²ψ + i₁ cos²ψ
M[ψ, φ] = i₃ cos θ
M[ψ, ψ] = i₃
f[φ] = i₂ ψ̇ w₂ sin θ sin ψ − i₂ θ̇ w₂ cos θ cos ψ − i₂ (φ̇ θ̇ cos θ cos ψ − θ̇ ψ̇ cos ψ − φ̇ ψ̇ sin θ sin ψ) sin θ cos ψ − i₁ θ̇ w₁ cos θ sin ψ − i₁ ψ̇ w₁ sin θ cos ψ − i₁ (φ̇ θ̇ cos θ sin ψ − θ̇ ψ̇ sin ψ + φ̇ ψ̇ sin θ cos ψ) sin θ sin ψ + i₃ θ̇ w₃ sin θ + i₃ φ̇ θ̇ sin θ cos θ
f[θ] = i₂ ψ̇ w₂ cos ψ + i₂ (φ̇ θ̇ cos θ cos ψ − θ̇ ψ̇ cos ψ − φ̇ ψ̇ sin θ sin ψ) sin ψ + i₁ ψ̇ w₁ sin ψ − i₁ (φ̇ θ̇ cos θ sin ψ − θ̇ ψ̇ sin ψ + φ̇ ψ̇ sin θ cos ψ) cos ψ + i₂ φ̇ w₂ cos θ cos ψ + i₁ φ̇ w₁ cos θ sin ψ − i₃ φ̇ w₃ sin θ + m g l sin θ
f[ψ] = i₃ φ̇ θ̇ sin θ − i₂ w₁ w₂ + i₁ w₁ w₂
```

# Operations

| method | + − | × | ÷ | √ | sin, cos | others |
|---|---|---|---|---|---|---|
| `lagrangian` | 6 | 16 | 0 | 0 | 2 | 0 |
| `energy` | 6 | 16 | 0 | 0 | 2 | 0 |
| `momenta` | 6 | 15 | 0 | 0 | 2 | 0 |
| `mass_matrix` | 4 | 13 | 0 | 0 | 2 | 0 |
| `forcing` | 22 | 45 | 0 | 0 | 2 | 0 |
| `generalized_forces` | 0 | 0 | 0 | 0 | 0 | 0 |
| `accelerations` | 32 | 68 | 5 | 0 | 2 | 0 |
| `inverse_dynamics` | 34 | 63 | 0 | 0 | 2 | 0 |
| `linearize` | 162 | 251 | 3 | 0 | 2 | 0 |
*/
impl HeavyTop {
    /// The names of the coordinates, in order.
    pub const COORDINATES: [&'static str; 3usize] = ["phi", "theta", "psi"];
    ///The index of the coordinate `phi`.
    pub const PHI: usize = 0usize;
    ///The index of the coordinate `theta`.
    pub const THETA: usize = 1usize;
    ///The index of the coordinate `psi`.
    pub const PSI: usize = 2usize;
    /// The equations of motion as they were derived.
    pub const EQUATIONS: &'static str = "q = (φ, θ, ψ)\nw₁ = θ\u{307} cos ψ + φ\u{307} sin θ sin ψ\nw₂ = φ\u{307} sin θ cos ψ − θ\u{307} sin ψ\nw₃ = ψ\u{307} + φ\u{307} cos θ\nT = ½ i₂ w₂² + ½ i₁ w₁² + ½ i₃ w₃²\nV = m g l cos θ\np[φ] = i₂ w₂ sin θ cos ψ + i₁ w₁ sin θ sin ψ + i₃ w₃ cos θ\np[θ] = i₁ w₁ cos ψ − i₂ w₂ sin ψ\np[ψ] = i₃ w₃\nM[φ, φ] = i₂ sin²θ cos²ψ + i₁ sin²θ sin²ψ + i₃ cos²θ\nM[θ, φ] = i₁ sin θ sin ψ cos ψ − i₂ sin θ sin ψ cos ψ\nM[θ, θ] = i₂ sin²ψ + i₁ cos²ψ\nM[ψ, φ] = i₃ cos θ\nM[ψ, ψ] = i₃\nf[φ] = i₂ ψ\u{307} w₂ sin θ sin ψ − i₂ θ\u{307} w₂ cos θ cos ψ − i₂ (φ\u{307} θ\u{307} cos θ cos ψ − θ\u{307} ψ\u{307} cos ψ − φ\u{307} ψ\u{307} sin θ sin ψ) sin θ cos ψ − i₁ θ\u{307} w₁ cos θ sin ψ − i₁ ψ\u{307} w₁ sin θ cos ψ − i₁ (φ\u{307} θ\u{307} cos θ sin ψ − θ\u{307} ψ\u{307} sin ψ + φ\u{307} ψ\u{307} sin θ cos ψ) sin θ sin ψ + i₃ θ\u{307} w₃ sin θ + i₃ φ\u{307} θ\u{307} sin θ cos θ\nf[θ] = i₂ ψ\u{307} w₂ cos ψ + i₂ (φ\u{307} θ\u{307} cos θ cos ψ − θ\u{307} ψ\u{307} cos ψ − φ\u{307} ψ\u{307} sin θ sin ψ) sin ψ + i₁ ψ\u{307} w₁ sin ψ − i₁ (φ\u{307} θ\u{307} cos θ sin ψ − θ\u{307} ψ\u{307} sin ψ + φ\u{307} ψ\u{307} sin θ cos ψ) cos ψ + i₂ φ\u{307} w₂ cos θ cos ψ + i₁ φ\u{307} w₁ cos θ sin ψ − i₃ φ\u{307} w₃ sin θ + m g l sin θ\nf[ψ] = i₃ φ\u{307} θ\u{307} sin θ − i₂ w₁ w₂ + i₁ w₁ w₂\n";
    /// The operation counts of the methods.
    pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::Operations {
        lagrangian: ::lagrangian::OperationCount {
            additions: 6usize,
            multiplications: 16usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        energy: ::lagrangian::OperationCount {
            additions: 6usize,
            multiplications: 16usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        momenta: ::lagrangian::OperationCount {
            additions: 6usize,
            multiplications: 15usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        mass_matrix: ::lagrangian::OperationCount {
            additions: 4usize,
            multiplications: 13usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        forcing: ::lagrangian::OperationCount {
            additions: 22usize,
            multiplications: 45usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        generalized_forces: ::lagrangian::OperationCount {
            additions: 0usize,
            multiplications: 0usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 0usize,
            functions: 0usize,
        },
        accelerations: ::lagrangian::OperationCount {
            additions: 32usize,
            multiplications: 68usize,
            divisions: 5usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        inverse_dynamics: ::lagrangian::OperationCount {
            additions: 34usize,
            multiplications: 63usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
        linearize: ::lagrangian::OperationCount {
            additions: 162usize,
            multiplications: 251usize,
            divisions: 3usize,
            square_roots: 0usize,
            sines_and_cosines: 2usize,
            functions: 0usize,
        },
    };
}
#[automatically_derived]
impl ::lagrangian::System<3usize> for HeavyTop {
    const COORDINATES: [&'static str; 3usize] = Self::COORDINATES;
    const ANGLES: [bool; 3usize] = [false, true, true];
    const IGNORABLE: [bool; 3usize] = [true, false, false];
    const SINGULARITIES: [&'static [usize]; 3usize] = [&[1], &[1], &[1]];
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Lagrangian<3usize, __S> for HeavyTop {
    fn lagrangian(&self, state: &::lagrangian::State<__S, 3usize>) -> __S {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = __S::sines_and_cosines([
            psi,
            theta,
        ]);
        let x0 = phi_dot * sin_theta;
        let w2 = cos_psi * x0 - theta_dot * sin_psi;
        let w1 = theta_dot * cos_psi + sin_psi * x0;
        let w3 = psi_dot + phi_dot * cos_theta;
        let x1 = __S::from_f64(0.5) * (w2 * w2 * i2 + w1 * w1 * i1 + w3 * w3 * i3)
            - cos_theta * m * g * l;
        x1
    }
    fn energy(&self, state: &::lagrangian::State<__S, 3usize>) -> __S {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = __S::sines_and_cosines([
            psi,
            theta,
        ]);
        let x0 = phi_dot * sin_theta;
        let w2 = cos_psi * x0 - theta_dot * sin_psi;
        let w1 = theta_dot * cos_psi + sin_psi * x0;
        let w3 = psi_dot + phi_dot * cos_theta;
        let x1 = __S::from_f64(0.5) * (w2 * w2 * i2 + w1 * w1 * i1 + w3 * w3 * i3)
            + cos_theta * m * g * l;
        x1
    }
    fn forcing(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = theta_dot * cos_psi;
        let x1 = psi_dot * sin_theta;
        let x2 = phi_dot * (x0 * cos_theta - sin_psi * x1) - psi_dot * x0;
        let x3 = cos_psi * i2;
        let x4 = theta_dot * sin_psi;
        let x5 = phi_dot * (x4 * cos_theta + cos_psi * x1) - psi_dot * x4;
        let x6 = sin_psi * i1;
        let x7 = phi_dot * cos_theta;
        let w3 = psi_dot + x7;
        let x8 = phi_dot * sin_theta;
        let w2 = cos_psi * x8 - x4;
        let x9 = sin_psi * i2;
        let w1 = x0 + sin_psi * x8;
        let x10 = cos_psi * i1;
        let x11 = theta_dot * (i3 * (w3 + x7)) + psi_dot * (w2 * x9 - w1 * x10) - x2 * x3
            - x5 * x6;
        let x12 = w2 * x3 + w1 * x6;
        let x13 = x2 * x9 + sin_theta * m * g * l
            + phi_dot * (cos_theta * x12 - sin_theta * w3 * i3) + psi_dot * x12;
        ::lagrangian::__private::SVector::from([
            sin_theta * x11 + theta_dot * (cos_theta * -x12),
            x13 - x5 * x10,
            theta_dot * i3 * x8 + w1 * (w2 * (i1 - i2)),
        ])
    }
    fn generalized_forces(
        &self,
        _state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        ::lagrangian::__private::SVector::from([
            __S::from_f64(0.0),
            __S::from_f64(0.0),
            __S::from_f64(0.0),
        ])
    }
    fn accelerations(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = cos_psi * i2;
        let x1 = cos_psi * (i1 - i2);
        let x2 = sin_psi * i2;
        let x3 = cos_psi * i1;
        let x4 = sin_psi * x2 + cos_psi * x3;
        let x5 = __S::from_f64(1.0) / x4;
        let x6 = x5 * x1;
        let x7 = cos_psi * x0 + sin_psi * (sin_psi * (i1 - x1 * x6));
        let x8 = theta_dot * cos_psi;
        let x9 = psi_dot * sin_theta;
        let x10 = phi_dot * (x8 * cos_theta - sin_psi * x9) - psi_dot * x8;
        let x11 = theta_dot * sin_psi;
        let x12 = phi_dot * (x11 * cos_theta + cos_psi * x9) - psi_dot * x11;
        let x13 = phi_dot * cos_theta;
        let w3 = psi_dot + x13;
        let x14 = phi_dot * sin_theta;
        let w2 = cos_psi * x14 - x11;
        let w1 = x8 + sin_psi * x14;
        let x15 = w1 * i1;
        let x16 = theta_dot * (i3 * (w3 + x13)) + psi_dot * (w2 * x2 - cos_psi * x15)
            - x10 * x0 - sin_psi * i1 * x12;
        let x17 = i3 * x14;
        let x18 = w2 * x15 + (theta_dot * x17 - w1 * w2 * i2);
        let x19 = w2 * x0;
        let x20 = sin_psi * x15;
        let x21 = sin_theta * x16 + cos_theta * (theta_dot * -(x19 + x20) - x18);
        let x22 = psi_dot * x19 + x10 * x2 + (psi_dot * x20 - x12 * x3)
            + (x13 * x19 + x13 * x20 - (w3 * x17 - sin_theta * m * g * l));
        let x23 = (x21 - sin_theta * sin_psi * x22 * x6) * (__S::from_f64(1.0) / x7);
        let x24 = __S::from_f64(1.0) / sin_theta;
        let x25 = x23 * (x24 * x24);
        ::lagrangian::__private::if_positive(
            [sin_theta * (sin_theta * x7), x4, i3],
            ::lagrangian::__private::SVector::from([
                x25,
                x5 * (x22 - sin_psi * x1 * x23 / sin_theta),
                (x18 - cos_theta * i3 * x25) / i3,
            ]),
            || {
                let mass = ::lagrangian::Lagrangian::<
                    3usize,
                    __S,
                >::mass_matrix(self, state);
                ::lagrangian::Factorization::new(mass)
                    .solve(
                        &::lagrangian::Lagrangian::<3usize, __S>::forcing(self, state),
                    )
            },
        )
    }
    fn inverse_dynamics(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
        accelerations: &::lagrangian::__private::SVector<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let phi_ddot: __S = accelerations[0];
        let theta_ddot: __S = accelerations[1];
        let psi_ddot: __S = accelerations[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = cos_psi * cos_psi;
        let x1 = sin_psi * sin_psi;
        let x2 = phi_ddot
            * (cos_theta * cos_theta * i3
                + sin_theta * (sin_theta * (i2 * x0 + i1 * x1)));
        let x3 = theta_dot * sin_psi;
        let x4 = phi_dot * sin_theta;
        let w2 = cos_psi * x4 - x3;
        let x5 = w2 * i2;
        let x6 = psi_dot * sin_theta;
        let x7 = i1 * (phi_dot * (x3 * cos_theta + cos_psi * x6) - psi_dot * x3);
        let x8 = i1 - i2;
        let x9 = cos_psi * x8;
        let x10 = phi_dot * cos_theta;
        let w3 = psi_dot + x10;
        let x11 = theta_dot * cos_psi;
        let x12 = i2 * (phi_dot * (x11 * cos_theta - sin_psi * x6) - psi_dot * x11);
        let w1 = x11 + sin_psi * x4;
        let x13 = w1 * i1;
        let x14 = sin_psi * (x7 + theta_ddot * x9 - psi_dot * x5)
            + theta_dot * (i3 * -(w3 + x10)) + cos_psi * (x12 + psi_dot * x13);
        let x15 = x2 + sin_theta * x14
            + cos_theta * (psi_ddot * i3 + theta_dot * (cos_psi * x5 + sin_psi * x13));
        let x16 = -w3;
        let x17 = theta_ddot * (i2 * x1 + i1 * x0)
            + sin_psi * (phi_ddot * sin_theta * x9 + w1 * (i1 * x16) - x12);
        let x18 = x17 + cos_psi * (x7 + w2 * (i2 * x16))
            + sin_theta * (phi_dot * w3 * i3 - m * g * l);
        ::lagrangian::__private::SVector::from([
            x15,
            x18,
            i3 * (psi_ddot + phi_ddot * cos_theta - theta_dot * x4) + w1 * (w2 * -x8),
        ])
    }
    fn linearize(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::Linearization<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = cos_theta * i3;
        let x1 = cos_psi * i2;
        let x2 = cos_psi * x1;
        let x3 = sin_psi * i1;
        let x4 = sin_psi * x3;
        let x5 = x2 + x4;
        let x6 = i1 - i2;
        let x7 = cos_psi * x6;
        let x8 = sin_psi * i2;
        let x9 = cos_psi * i1;
        let x10 = sin_psi * x8 + cos_psi * x9;
        let x11 = theta_dot * cos_psi;
        let x12 = sin_theta * sin_psi;
        let x13 = x11 * cos_theta - psi_dot * x12;
        let x14 = phi_dot * x13 - psi_dot * x11;
        let x15 = theta_dot * sin_psi;
        let x16 = x15 * cos_theta;
        let x17 = sin_theta * cos_psi;
        let x18 = psi_dot * x17;
        let x19 = x16 + x18;
        let x20 = phi_dot * x19 - psi_dot * x15;
        let x21 = phi_dot * cos_theta;
        let w3 = psi_dot + x21;
        let w2 = phi_dot * x17 - x15;
        let x22 = w2 * x8;
        let w1 = x11 + phi_dot * x12;
        let x23 = w1 * x9;
        let x24 = theta_dot * (i3 * (w3 + x21)) + psi_dot * (x22 - x23) - x14 * x1
            - x20 * x3;
        let x25 = w2 * x1;
        let x26 = w1 * x3;
        let x27 = x25 + x26;
        let x28 = -x27;
        let x29 = l * (m * g);
        let x30 = sin_theta * i3;
        let x31 = w3 * x30;
        let x32 = x14 * x8 + sin_theta * x29 + phi_dot * (cos_theta * x27 - x31)
            + psi_dot * x27 - x20 * x9;
        let x33 = phi_dot * x30;
        let x34 = w2 * x6;
        let factors = ::lagrangian::Factorization::new(
            ::lagrangian::__private::SMatrix::from([
                [
                    cos_theta * x0 + sin_theta * (sin_theta * x5),
                    sin_theta * (sin_psi * x7),
                    x0,
                ],
                [__S::from_f64(0.0), x10, __S::from_f64(0.0)],
                [__S::from_f64(0.0), __S::from_f64(0.0), i3],
            ]),
        );
        let accelerations = factors
            .solve(
                &::lagrangian::__private::SVector::from([
                    sin_theta * x24 + theta_dot * (cos_theta * x28),
                    x32,
                    theta_dot * x33 + w1 * x34,
                ]),
            );
        let phi_ddot: __S = accelerations[0];
        let theta_ddot: __S = accelerations[1];
        let psi_ddot: __S = accelerations[2];
        let x35 = phi_ddot * sin_theta;
        let x36 = theta_ddot * cos_psi;
        let x37 = x6 * x36;
        let x38 = i1 * x20 + x37
            + phi_dot * (theta_dot * cos_theta * x3 + psi_dot * (sin_theta * x7))
            - psi_dot * w2 * i2;
        let x39 = w3 * i3;
        let x40 = sin_psi * x38 + theta_dot * (phi_dot * (cos_theta * (x2 - i3)) - x39);
        let x41 = x40 + cos_psi * (i2 * x14 + psi_dot * w1 * i1)
            - __S::from_f64(2.0) * ((i3 - x2 - x4) * x35);
        let x42 = psi_dot * cos_theta;
        let x43 = -(theta_dot * x17 + sin_psi * x42);
        let x44 = cos_psi * x42 - sin_theta * x15;
        let x45 = theta_dot * x30;
        let x46 = phi_dot * (x43 * x1 + x44 * x3 + __S::from_f64(2.0) * x45)
            + theta_dot * x28 - psi_ddot * i3;
        let x47 = -x5;
        let x48 = phi_dot * (cos_theta * x47);
        let x49 = psi_dot * x47;
        let x50 = x44 * x9 + cos_theta * (x39 + x48 + x49) + sin_theta * (x27 - x33)
            - x43 * x8;
        let x51 = phi_ddot * x6;
        let x52 = w2 * x3;
        let x53 = x21 * x22 + w1 * x21 * x1 - (x21 * x52 + x21 * x23);
        let x54 = -x6;
        let x55 = psi_dot * (w1 * x54);
        let x56 = x14 * x6;
        let x57 = sin_psi
            * (x55 + x56
                + x6 * (__S::from_f64(2.0) * (phi_ddot * x17) - theta_ddot * sin_psi));
        let x58 = sin_theta * (x57 + cos_psi * (x37 + psi_dot * x34 + x20 * x6));
        let x59 = w1 * x6;
        let x60 = w2 * x54;
        let x61 = sin_psi
            * (psi_dot * x60 + x20 * x54
                + x6 * -(phi_ddot * x12 + __S::from_f64(2.0) * x36));
        let x62 = x61 + cos_psi * (x17 * x51 + x55 + x56) + x53;
        let x63 = sin_theta * x1;
        let x64 = x13 * x1 + sin_psi * (i1 * (x19 + x16 + x18) - psi_dot * x63);
        let x65 = sin_theta
            * (x64 + theta_dot * (cos_theta * (x2 - __S::from_f64(2.0) * i3)));
        let x66 = cos_theta * x25 + cos_theta * x26 - (x31 + x21 * x30);
        let x67 = sin_theta * x22 + w1 * x63 - (sin_theta * x52 + sin_theta * x23);
        let x68 = x21 - psi_dot;
        let x69 = sin_theta * (psi_dot * x10 + x68 * x5)
            + theta_dot * (sin_psi * (cos_psi * (cos_theta * x6))) + x66;
        let x70 = x21 + (psi_dot - x68);
        let x71 = x26 - (x33 - x25) - (w1 * x8 + w2 * x9);
        ::lagrangian::Linearization {
            position: -factors
                .solve(
                    &::lagrangian::__private::SMatrix::from([
                        [__S::from_f64(0.0), __S::from_f64(0.0), __S::from_f64(0.0)],
                        [
                            cos_theta * x41 + sin_theta * x46,
                            phi_dot * x50 + cos_theta * (sin_psi * cos_psi * x51 - x29),
                            i3 * -(theta_dot * x21 + x35) + x53,
                        ],
                        [
                            x58
                                + theta_dot * (cos_theta * (sin_psi * x34 + cos_psi * x59)),
                            x62,
                            w1 * x59 + w2 * x60,
                        ],
                    ]),
                ),
            velocity: -factors
                .solve(
                    &::lagrangian::__private::SMatrix::from([
                        [
                            x65,
                            x19 * x9 + sin_theta * (x48 + x49) - x13 * x8 - x66,
                            x67 - x45,
                        ],
                        [x69, sin_psi * (cos_psi * (i1 * -x70 + i2 * x70)), x71],
                        [-(x45 + x67), -x71, __S::from_f64(0.0)],
                    ]),
                ),
            time: -factors
                .solve(
                    &::lagrangian::__private::SVector::from([
                        __S::from_f64(0.0),
                        __S::from_f64(0.0),
                        __S::from_f64(0.0),
                    ]),
                ),
        }
    }
    fn momenta(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let w3 = psi_dot + phi_dot * cos_theta;
        let x0 = w3 * i3;
        let x1 = phi_dot * sin_theta;
        let w2 = cos_psi * x1 - theta_dot * sin_psi;
        let x2 = w2 * i2;
        let w1 = theta_dot * cos_psi + sin_psi * x1;
        let x3 = w1 * i1;
        ::lagrangian::__private::SVector::from([
            cos_theta * x0 + sin_theta * (cos_psi * x2 + sin_psi * x3),
            cos_psi * x3 - sin_psi * x2,
            x0,
        ])
    }
    fn mass_matrix(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SMatrix<__S, 3usize, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = cos_theta * i3;
        let x1 = cos_psi * cos_psi;
        let x2 = sin_psi * sin_psi;
        let x3 = sin_theta * (sin_psi * (cos_psi * (i1 - i2)));
        ::lagrangian::__private::SMatrix::from([
            [cos_theta * x0 + sin_theta * (sin_theta * (i2 * x1 + i1 * x2)), x3, x0],
            [x3, i2 * x2 + i1 * x1, __S::from_f64(0.0)],
            [x0, __S::from_f64(0.0), i3],
        ])
    }
    fn relative_pivots(
        &self,
        state: &::lagrangian::State<__S, 3usize>,
    ) -> ::lagrangian::__private::SVector<__S, 3usize> {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = __S::sines_and_cosines([
            theta,
            psi,
        ]);
        let x0 = sin_theta * sin_theta;
        let x1 = sin_psi * sin_psi;
        let x2 = x0 * x1;
        let x3 = i1 - i2;
        let x4 = cos_psi * cos_psi;
        let x5 = x3 * x4;
        let x6 = i2 * x1;
        let x7 = i1 * x4;
        let x8 = x6 + x7;
        let x9 = __S::from_f64(1.0) / x8;
        let x10 = x5 * (x3 * x9);
        let x11 = x10 * x2;
        let x12 = i2 * x4;
        let x13 = x12 * x0;
        let x14 = i1 * x2;
        let x15 = x13 + x14;
        let x16 = cos_theta
            * (sin_psi * (sin_psi * (__S::from_f64(2.0) * (i1 - x10)))
                + __S::from_f64(2.0) * x12);
        let x17 = sin_psi * (sin_psi * (__S::from_f64(2.0) * (x5 / (x8 * x8) - x9)));
        let x18 = __S::from_f64(2.0) * x3;
        let x19 = x3 * (x3 * (x17 + __S::from_f64(2.0) * (x9 * x4))) - x18;
        let x20 = __S::from_f64(1.0).min(psi.abs());
        let x21 = (sin_theta * (sin_theta * (sin_psi * (cos_psi * x19)))).abs() * x20;
        let x22 = x6.abs() + x7.abs() + x20 * (sin_psi * (cos_psi * -x18)).abs();
        ::lagrangian::__private::relative_pivots(
            [x15 - x11, x8, i3],
            [
                x13.abs() + x14.abs() + x11.abs()
                    + (sin_theta * x16).abs() * __S::from_f64(1.0).min(theta.abs())
                    + x21,
                x22,
                i3.abs(),
            ],
            [cos_theta * cos_theta * i3 + x15, x8, i3],
        )
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Energies<3usize, __S> for HeavyTop {
    fn kinetic_energy(&self, state: &::lagrangian::State<__S, 3usize>) -> __S {
        let theta: __S = state.q[1];
        let psi: __S = state.q[2];
        let phi_dot: __S = state.v[0];
        let theta_dot: __S = state.v[1];
        let psi_dot: __S = state.v[2];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = __S::sines_and_cosines([
            psi,
            theta,
        ]);
        let x0 = phi_dot * sin_theta;
        let w2 = cos_psi * x0 - theta_dot * sin_psi;
        let w1 = theta_dot * cos_psi + sin_psi * x0;
        let w3 = psi_dot + phi_dot * cos_theta;
        __S::from_f64(0.5) * (w2 * w2 * i2 + w1 * w1 * i1 + w3 * w3 * i3)
    }
    fn potential_energy(&self, state: &::lagrangian::State<__S, 3usize>) -> __S {
        let theta: __S = state.q[1];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        theta.cos() * m * g * l
    }
}
