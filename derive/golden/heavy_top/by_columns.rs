/**# The equations of motion

d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with

```text
q = (φ, θ, ψ)
w₁ = φ̇ sin θ sin ψ + θ̇ cos ψ
w₂ = φ̇ sin θ cos ψ − θ̇ sin ψ
w₃ = φ̇ cos θ + ψ̇
T = ½ I₁ w₁² + ½ I₂ w₂² + ½ I₃ w₃²
V = m g l cos θ

Momenta p = ∂L/∂q̇:
p_φ = (I₁ w₁ sin ψ + I₂ w₂ cos ψ) sin θ + I₃ w₃ cos θ
p_θ = I₁ w₁ cos ψ − I₂ w₂ sin ψ
p_ψ = I₃ w₃
p_φ is constant.

Energy function h = Σ p q̇ − L:
h = T + V
h is constant.

Lagrange's equations d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6):
((I₁ sin²ψ + I₂ cos²ψ) sin²θ + I₃ cos²θ) φ̈ + (I₁ − I₂) θ̈ sin θ sin ψ cos ψ + I₃ ψ̈ cos θ + 2 (I₁ sin²ψ + I₂ cos²ψ − I₃) φ̇ θ̇ sin θ cos θ + 2 (I₁ − I₂) φ̇ ψ̇ sin²θ sin ψ cos ψ + (I₁ − I₂) θ̇² cos θ sin ψ cos ψ − ((I₁ − I₂) sin²ψ + (I₂ − I₁) cos²ψ + I₃) θ̇ ψ̇ sin θ = 0
(I₁ − I₂) φ̈ sin θ sin ψ cos ψ + (I₁ cos²ψ + I₂ sin²ψ) θ̈ − (I₁ sin²ψ + I₂ cos²ψ − I₃) φ̇² sin θ cos θ + ((I₂ − I₁) sin²ψ + (I₁ − I₂) cos²ψ + I₃) φ̇ ψ̇ sin θ + 2 (I₂ − I₁) θ̇ ψ̇ sin ψ cos ψ − m g l sin θ = 0
I₃ φ̈ cos θ + I₃ ψ̈ + (I₂ − I₁) w₁ w₂ − I₃ φ̇ θ̇ sin θ = 0

Boltzmann–Hamel equations, Euler's (3.5)–(3.7) for a rigid body, and kinematics:
I₁ ẇ₁ = (I₂ − I₃) w₂ w₃ + m g l sin θ cos ψ
I₂ ẇ₂ = (I₃ − I₁) w₁ w₃ − m g l sin θ sin ψ
I₃ ẇ₃ = (I₁ − I₂) w₁ w₂
φ̇ = (w₁ sin ψ + w₂ cos ψ)/sin θ
θ̇ = w₁ cos ψ − w₂ sin ψ
ψ̇ = w₃ − (w₁ sin ψ + w₂ cos ψ) cos(θ)/sin θ
```

# Operations

| method | + − | × | ÷ | √ | sin, cos | others |
|---|---|---|---|---|---|---|
| `lagrangian` | 6 | 16 | 0 | 0 | 2 | 0 |
| `energy` | 6 | 16 | 0 | 0 | 2 | 0 |
| `momenta` | 6 | 15 | 0 | 0 | 2 | 0 |
| `mass_matrix` | 33 | 60 | 0 | 0 | 8 | 0 |
| `forcing` | 19 | 40 | 0 | 0 | 2 | 0 |
| `generalized_forces` | 0 | 0 | 0 | 0 | 0 | 0 |
| `prepare` | 4 | 3 | 5 | 0 | 0 | 0 |
| `accelerations` | 16 | 27 | 1 | 0 | 2 | 0 |
| `inverse_dynamics` | 23 | 45 | 0 | 0 | 2 | 0 |
| `linearize` | 766 | 1147 | 19 | 0 | 24 | 0 |

`mass_matrix` is computed column by column: the momenta at unit velocities, less those at rest.

`linearize` is computed column by column: M δq̈ = −δ(M q̈ − f), with `inverse_dynamics` on dual numbers, and M factored numerically.
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
    /// The names of the constants of motion, in order.
    pub const CONSTANTS_OF_MOTION: [&'static str; 2usize] = ["p_phi", "energy"];
    /// The indices of the ignorable coordinates, in order.
    pub const IGNORABLE_COORDINATES: &'static [usize] = &[0];
    /// Whether the energy function is a constant of motion.
    pub const CONSERVES_ENERGY: bool = true;
    /// The equations of motion as they were derived, in lines of Unicode.
    pub const EQUATIONS: &'static str = "q = (φ, θ, ψ)\nw₁ = φ\u{307} sin θ sin ψ + θ\u{307} cos ψ\nw₂ = φ\u{307} sin θ cos ψ − θ\u{307} sin ψ\nw₃ = φ\u{307} cos θ + ψ\u{307}\nT = ½ I₁ w₁² + ½ I₂ w₂² + ½ I₃ w₃²\nV = m g l cos θ\n\nMomenta p = ∂L/∂q\u{307}:\np_φ = (I₁ w₁ sin ψ + I₂ w₂ cos ψ) sin θ + I₃ w₃ cos θ\np_θ = I₁ w₁ cos ψ − I₂ w₂ sin ψ\np_ψ = I₃ w₃\np_φ is constant.\n\nEnergy function h = Σ p q\u{307} − L:\nh = T + V\nh is constant.\n\nLagrange's equations d/dt (∂L/∂q\u{307}) − ∂L/∂q = Q (4.6):\n((I₁ sin²ψ + I₂ cos²ψ) sin²θ + I₃ cos²θ) φ\u{308} + (I₁ − I₂) θ\u{308} sin θ sin ψ cos ψ + I₃ ψ\u{308} cos θ + 2 (I₁ sin²ψ + I₂ cos²ψ − I₃) φ\u{307} θ\u{307} sin θ cos θ + 2 (I₁ − I₂) φ\u{307} ψ\u{307} sin²θ sin ψ cos ψ + (I₁ − I₂) θ\u{307}² cos θ sin ψ cos ψ − ((I₁ − I₂) sin²ψ + (I₂ − I₁) cos²ψ + I₃) θ\u{307} ψ\u{307} sin θ = 0\n(I₁ − I₂) φ\u{308} sin θ sin ψ cos ψ + (I₁ cos²ψ + I₂ sin²ψ) θ\u{308} − (I₁ sin²ψ + I₂ cos²ψ − I₃) φ\u{307}² sin θ cos θ + ((I₂ − I₁) sin²ψ + (I₁ − I₂) cos²ψ + I₃) φ\u{307} ψ\u{307} sin θ + 2 (I₂ − I₁) θ\u{307} ψ\u{307} sin ψ cos ψ − m g l sin θ = 0\nI₃ φ\u{308} cos θ + I₃ ψ\u{308} + (I₂ − I₁) w₁ w₂ − I₃ φ\u{307} θ\u{307} sin θ = 0\n\nBoltzmann–Hamel equations, Euler's (3.5)–(3.7) for a rigid body, and kinematics:\nI₁ w\u{307}₁ = (I₂ − I₃) w₂ w₃ + m g l sin θ cos ψ\nI₂ w\u{307}₂ = (I₃ − I₁) w₁ w₃ − m g l sin θ sin ψ\nI₃ w\u{307}₃ = (I₁ − I₂) w₁ w₂\nφ\u{307} = (w₁ sin ψ + w₂ cos ψ)/sin θ\nθ\u{307} = w₁ cos ψ − w₂ sin ψ\nψ\u{307} = w₃ − (w₁ sin ψ + w₂ cos ψ) cos(θ)/sin θ\n";
    /// The same in displays of LaTeX, for `amsmath`, `KaTeX` and `MathJax`.
    pub const LATEX: &'static str = "\\begin{align*}\nq &= (\\varphi, \\theta, \\psi)\n\\end{align*}\n\\begin{align*}\nw_{1} &= \\dot{\\varphi} \\sin \\theta \\sin \\psi + \\dot{\\theta} \\cos \\psi \\\\\nw_{2} &= \\dot{\\varphi} \\sin \\theta \\cos \\psi - \\dot{\\theta} \\sin \\psi \\\\\nw_{3} &= \\dot{\\varphi} \\cos \\theta + \\dot{\\psi}\n\\end{align*}\n\\begin{align*}\nT &= \\frac{1}{2} I_{1} w_{1}^{2} + \\frac{1}{2} I_{2} w_{2}^{2} + \\frac{1}{2} I_{3} w_{3}^{2} \\\\\nV &= m g l \\cos \\theta\n\\end{align*}\nMomenta $p = \\partial L/\\partial \\dot q$:\n\\begin{align*}\np_{\\varphi} &= \\left(I_{1} w_{1} \\sin \\psi + I_{2} w_{2} \\cos \\psi\\right) \\sin \\theta + I_{3} w_{3} \\cos \\theta \\\\\np_{\\theta} &= I_{1} w_{1} \\cos \\psi - I_{2} w_{2} \\sin \\psi \\\\\np_{\\psi} &= I_{3} w_{3}\n\\end{align*}\n$p_{\\varphi}$ is constant.\nEnergy function $h = \\sum p \\dot q - L$:\n\\begin{align*}\nh &= T + V\n\\end{align*}\n$h$ is constant.\nLagrange's equations $\\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot q} - \\frac{\\partial L}{\\partial q} = Q$ (4.6):\n\\begin{align*}\n&\\left(\\left(I_{1} \\sin^{2} \\psi + I_{2} \\cos^{2} \\psi\\right) \\sin^{2} \\theta + I_{3} \\cos^{2} \\theta\\right) \\ddot{\\varphi} + \\left(I_{1} - I_{2}\\right) \\ddot{\\theta} \\sin \\theta \\sin \\psi \\cos \\psi + I_{3} \\ddot{\\psi} \\cos \\theta \\\\\n&\\quad + 2 \\left(I_{1} \\sin^{2} \\psi + I_{2} \\cos^{2} \\psi - I_{3}\\right) \\dot{\\varphi} \\dot{\\theta} \\sin \\theta \\cos \\theta + 2 \\left(I_{1} - I_{2}\\right) \\dot{\\varphi} \\dot{\\psi} \\sin^{2} \\theta \\sin \\psi \\cos \\psi \\\\\n&\\quad + \\left(I_{1} - I_{2}\\right) \\dot{\\theta}^{2} \\cos \\theta \\sin \\psi \\cos \\psi - \\left(\\left(I_{1} - I_{2}\\right) \\sin^{2} \\psi + \\left(I_{2} - I_{1}\\right) \\cos^{2} \\psi + I_{3}\\right) \\dot{\\theta} \\dot{\\psi} \\sin \\theta = 0 \\\\\n&\\left(I_{1} - I_{2}\\right) \\ddot{\\varphi} \\sin \\theta \\sin \\psi \\cos \\psi + \\left(I_{1} \\cos^{2} \\psi + I_{2} \\sin^{2} \\psi\\right) \\ddot{\\theta} \\\\\n&\\quad - \\left(I_{1} \\sin^{2} \\psi + I_{2} \\cos^{2} \\psi - I_{3}\\right) \\dot{\\varphi}^{2} \\sin \\theta \\cos \\theta \\\\\n&\\quad + \\left(\\left(I_{2} - I_{1}\\right) \\sin^{2} \\psi + \\left(I_{1} - I_{2}\\right) \\cos^{2} \\psi + I_{3}\\right) \\dot{\\varphi} \\dot{\\psi} \\sin \\theta + 2 \\left(I_{2} - I_{1}\\right) \\dot{\\theta} \\dot{\\psi} \\sin \\psi \\cos \\psi \\\\\n&\\quad - m g l \\sin \\theta = 0 \\\\\n&I_{3} \\ddot{\\varphi} \\cos \\theta + I_{3} \\ddot{\\psi} + \\left(I_{2} - I_{1}\\right) w_{1} w_{2} - I_{3} \\dot{\\varphi} \\dot{\\theta} \\sin \\theta = 0\n\\end{align*}\nBoltzmann--Hamel equations, Euler's (3.5)--(3.7) for a rigid body, and kinematics:\n\\begin{align*}\nI_{1} \\dot{w}_{1} &= \\left(I_{2} - I_{3}\\right) w_{2} w_{3} + m g l \\sin \\theta \\cos \\psi \\\\\nI_{2} \\dot{w}_{2} &= \\left(I_{3} - I_{1}\\right) w_{1} w_{3} - m g l \\sin \\theta \\sin \\psi \\\\\nI_{3} \\dot{w}_{3} &= \\left(I_{1} - I_{2}\\right) w_{1} w_{2} \\\\\n\\dot{\\varphi} &= \\frac{w_{1} \\sin \\psi + w_{2} \\cos \\psi}{\\sin \\theta} \\\\\n\\dot{\\theta} &= w_{1} \\cos \\psi - w_{2} \\sin \\psi \\\\\n\\dot{\\psi} &= w_{3} - \\frac{\\left(w_{1} \\sin \\psi + w_{2} \\cos \\psi\\right) \\cos \\theta}{\\sin \\theta}\n\\end{align*}\n";
    /// The operation counts of the methods.
    pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::__private::operations([
        [6, 6, 6, 33, 19, 0, 4, 16, 23, 766],
        [16, 16, 15, 60, 40, 0, 3, 27, 45, 1147],
        [0, 0, 0, 0, 0, 0, 5, 1, 0, 19],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [2, 2, 2, 8, 2, 0, 0, 2, 2, 24],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    ]);
    #[doc(hidden)]
    fn __mentions(&self) {
        let [w1, w2, w3] = [(); 3usize];
        let _ = (&self.i1, w1, &self.i2, w2, &self.i3, w3);
        let _ = (&self.m, &self.g, &self.l, Self::THETA);
        let _ = (Self::PHI, Self::THETA, Self::PSI, Self::THETA, Self::PSI);
        let _ = (Self::PHI, Self::THETA, Self::PSI, Self::THETA, Self::PSI);
        let _ = (Self::PHI, Self::THETA, Self::PSI);
    }
}
#[automatically_derived]
impl ::lagrangian::GeneralizedCoordinates<3> for HeavyTop {
    const COORDINATES: [&'static str; 3] = Self::COORDINATES;
    const ANGLES: [bool; 3] = [false, true, true];
    const PERIODS: [u32; 3] = [1, 1, 1];
    const IGNORABLE: [bool; 3] = [true, false, false];
    const SINGULARITIES: [&'static [usize]; 3] = [&[1], &[1], &[1]];
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Quantities<3, __S>
for HeavyTop {
    type Inputs = ::lagrangian::__private::SVector<__S, 0>;
    fn inputs(&self) -> ::lagrangian::__private::SVector<__S, 0> {
        ::lagrangian::__private::vector([])
    }
    fn lagrangian(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 13],
    ) -> __S {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let [i1, i2, i3, m, g, l, ..] = *prepared;
        let x0 = phi_dot * sin_theta;
        let w2 = (-theta_dot).mul_add(sin_psi, cos_psi * x0);
        let w1 = sin_psi.mul_add(x0, theta_dot * cos_psi);
        let w3 = phi_dot.mul_add(cos_theta, psi_dot);
        let x1 = i1.mul_add(w1 * w1, i2 * (w2 * w2));
        let x2 = i3.mul_add(w3 * w3, x1);
        (-(m * g * l)).mul_add(cos_theta, __S::from_f64(0.5) * x2)
    }
    fn energy(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = phi_dot * sin_theta;
        let w2 = (-theta_dot).mul_add(sin_psi, cos_psi * x0);
        let w1 = sin_psi.mul_add(x0, theta_dot * cos_psi);
        let w3 = phi_dot.mul_add(cos_theta, psi_dot);
        let x1 = i1.mul_add(w1 * w1, i2 * (w2 * w2));
        let x2 = i3.mul_add(w3 * w3, x1);
        (m * g * l).mul_add(cos_theta, __S::from_f64(0.5) * x2)
    }
    fn momenta(
        &self,
        state: &::lagrangian::State<__S, 3>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SVector<__S, 3> {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([theta, psi]);
        let ([sin_theta, sin_psi], [cos_theta, cos_psi]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let [i1, i2, i3, ..] = *prepared;
        let w3 = phi_dot.mul_add(cos_theta, psi_dot);
        let x0 = i3 * w3;
        let x1 = phi_dot * sin_theta;
        let w2 = (-theta_dot).mul_add(sin_psi, cos_psi * x1);
        let x2 = i2 * w2;
        let w1 = sin_psi.mul_add(x1, theta_dot * cos_psi);
        let x3 = i1 * w1;
        ::lagrangian::__private::vector([
            sin_theta.mul_add(sin_psi.mul_add(x3, cos_psi * x2), cos_theta * x0),
            (-sin_psi).mul_add(x2, cos_psi * x3),
            x0,
        ])
    }
    fn mass_matrix(
        &self,
        state: &::lagrangian::State<__S, 3>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SMatrix<__S, 3, 3> {
        ::lagrangian::__private::mass_matrix_by_columns(
            state,
            |state| ::lagrangian::quantities::Quantities::<
                3,
                __S,
            >::momenta(self, state, prepared),
        )
    }
    fn forcing(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SVector<__S, 3> {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let [i1, i2, i3, m, g, l, ..] = *prepared;
        let x0 = theta_dot * sin_psi;
        let x1 = phi_dot * sin_theta;
        let w2 = cos_psi.mul_add(x1, -x0);
        let x2 = theta_dot * cos_psi;
        let x3 = psi_dot * sin_theta;
        let w1 = sin_psi.mul_add(x1, x2);
        let x4 = phi_dot * cos_theta;
        let x5 = (-psi_dot).mul_add(w1, x2 * x4);
        let x6 = i2 * cos_psi;
        let x7 = psi_dot.mul_add(w2, x0 * x4);
        let x8 = i1 * sin_psi;
        let w3 = psi_dot + x4;
        let x9 = (-x5).mul_add(x6, i3 * (theta_dot * (w3 + x4)));
        let x10 = sin_theta * (-x7).mul_add(x8, x9);
        let x11 = (-(i2 * w2)).mul_add((-sin_psi).mul_add(x3, x2 * cos_theta), x10);
        let x12 = i3 * x1;
        let x13 = (m * g * l).mul_add(sin_theta, i2 * sin_psi * x5);
        let x14 = w3.mul_add(w1.mul_add(x8, w2 * x6) - x12, x13);
        ::lagrangian::__private::vector([
            (-(i1 * w1)).mul_add(cos_psi.mul_add(x3, x0 * cos_theta), x11),
            (-(i1 * cos_psi)).mul_add(x7, x14),
            w1.mul_add(w2 * (i1 - i2), theta_dot * x12),
        ])
    }
    type Prepared = [__S; 13];
    fn prepare(&self) -> [__S; 13] {
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m * g;
        let x1 = l * x0;
        [
            i1,
            i2,
            i3,
            m,
            g,
            l,
            (i1 - i3) / i2,
            x1 / i2,
            (i3 - i2) / i1,
            x1 / i1,
            (i1 - i2) / i3,
            x0 * l,
            i2 - i1,
        ]
    }
    #[inline(always)]
    fn accelerations(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SVector<__S, 3> {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let [_, _, _, _, _, _, c0, c1, c2, c3, c4, ..] = *prepared;
        let x0 = phi_dot * cos_theta;
        let x1 = theta_dot * cos_psi;
        let x2 = phi_dot * sin_theta;
        let w1 = sin_psi.mul_add(x2, x1);
        let w3 = psi_dot + x0;
        let x3 = -(sin_theta * sin_psi).mul_add(c1, w1 * w3 * c0);
        let x4 = (-x1).mul_add(x0, psi_dot.mul_add(w1, x3));
        let x5 = theta_dot * sin_psi;
        let w2 = cos_psi.mul_add(x2, -x5);
        let x6 = (-(w2 * w3)).mul_add(c2, sin_theta * cos_psi * c3);
        let x7 = (-psi_dot).mul_add(w2, (-x5).mul_add(x0, x6));
        let x8 = -sin_psi.mul_add(x7, cos_psi * x4) * (__S::from_f64(1.0) / sin_theta);
        ::lagrangian::__private::vector([
            -x8,
            (-sin_psi).mul_add(x4, cos_psi * x7),
            cos_theta.mul_add(x8, (w1 * w2).mul_add(c4, theta_dot * x2)),
        ])
    }
    fn inverse_dynamics(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        accelerations: &::lagrangian::__private::SVector<__S, 3>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SVector<__S, 3> {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let [phi_ddot, theta_ddot, psi_ddot] = accelerations.data.0[0];
        let [i1, i2, i3, _, _, _, _, _, _, _, _, c5, c6] = *prepared;
        let x0 = theta_dot * sin_psi;
        let x1 = phi_dot * sin_theta;
        let w2 = cos_psi.mul_add(x1, -x0);
        let x2 = theta_dot * cos_psi;
        let x3 = psi_dot * sin_theta;
        let x4 = (-sin_psi).mul_add(x3, x2 * cos_theta);
        let w1 = sin_psi.mul_add(x1, x2);
        let x5 = cos_psi.mul_add(x3, x0 * cos_theta);
        let x6 = i3 * (-theta_dot).mul_add(x1, phi_ddot.mul_add(cos_theta, psi_ddot));
        let w3 = phi_dot.mul_add(cos_theta, psi_dot);
        let x7 = (-theta_dot).mul_add(psi_dot, phi_ddot * sin_theta);
        let x8 = (-theta_ddot).mul_add(sin_psi, cos_psi.mul_add(x7, phi_dot * x4));
        let x9 = i2 * cos_psi;
        let x10 = sin_psi.mul_add(x7, phi_dot.mul_add(x5, theta_ddot * cos_psi));
        let x11 = i1 * sin_psi;
        let x12 = (-(i3 * theta_dot)).mul_add(w3, x10.mul_add(x11, x8 * x9));
        let x13 = (i1 * w1).mul_add(x5, i2 * w2 * x4);
        let x14 = (-w1).mul_add(x11, (-w2).mul_add(x9, i3 * x1));
        let x15 = (-sin_theta).mul_add(c5, w3.mul_add(x14, i1 * cos_psi * x10));
        ::lagrangian::__private::vector([
            sin_theta.mul_add(x12, cos_theta.mul_add(x6, x13)),
            (-(i2 * sin_psi)).mul_add(x8, x15),
            w1.mul_add(w2 * c6, x6),
        ])
    }
    fn relative_pivots(
        &self,
        state: &::lagrangian::State<__S, 3>,
        prepared: &[__S; 13],
    ) -> ::lagrangian::__private::SVector<__S, 3> {
        let [i1, i2, i3, ..] = *prepared;
        let theta: __S = state.x.q[1];
        let (sin_theta, cos_theta) = theta.sin_cos();
        let x0 = __S::from_f64(1.0).min(theta.abs());
        ::lagrangian::__private::relative_pivots(
            [-sin_theta, i2, i1, i3],
            [cos_theta.abs().mul_add(x0, sin_theta.abs()), i2.abs(), i1.abs(), i3.abs()],
            [],
            [&[0, 1, 2], &[0, 1, 2], &[3]],
        )
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Lagrangian<3, __S> for HeavyTop {
    type Model = Self;
    fn model(&self) -> &Self {
        self
    }
}
#[automatically_derived]
impl ::lagrangian::__private::SharesLanes for HeavyTop {}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::StateJacobian<3, __S>
for HeavyTop {
    fn linearize(
        &self,
        state: &::lagrangian::State<__S, 3>,
        inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> ::lagrangian::Linearization<__S, 3> {
        let accelerations = ::lagrangian::quantities::Quantities::<
            3,
            __S,
        >::accelerations(
            self,
            state,
            inputs,
            &::lagrangian::quantities::Quantities::<3, __S>::prepare(self),
        );
        let factors = ::lagrangian::Factorization::new(
            ::lagrangian::quantities::Quantities::<
                3,
                __S,
            >::mass_matrix(
                self,
                state,
                &::lagrangian::quantities::Quantities::<3, __S>::prepare(self),
            ),
        );
        let prepared = ::lagrangian::quantities::Quantities::<
            3usize,
            ::lagrangian::Dual<__S, 1>,
        >::prepare(self);
        let inputs = ::lagrangian::__private::constants(inputs);
        ::lagrangian::__private::linearization_by_columns(
            state,
            &accelerations,
            &factors,
            |state, accelerations| ::lagrangian::quantities::Quantities::<
                3usize,
                ::lagrangian::Dual<__S, 1>,
            >::inverse_dynamics(self, state, &inputs, accelerations, &prepared),
        )
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Energies<3, __S> for HeavyTop {
    fn kinetic_energy(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let [_, theta, psi] = state.x.q.data.0[0];
        let (sines, cosines) = __S::sines_and_cosines([psi, theta]);
        let ([sin_psi, sin_theta], [cos_psi, cos_theta]) = (sines, cosines);
        let [phi_dot, theta_dot, psi_dot] = state.x.v.data.0[0];
        let i1: __S = ::lagrangian::__private::parameter(self.i1);
        let i2: __S = ::lagrangian::__private::parameter(self.i2);
        let i3: __S = ::lagrangian::__private::parameter(self.i3);
        let x0 = phi_dot * sin_theta;
        let w2 = (-theta_dot).mul_add(sin_psi, cos_psi * x0);
        let w1 = sin_psi.mul_add(x0, theta_dot * cos_psi);
        let w3 = phi_dot.mul_add(cos_theta, psi_dot);
        let x1 = i1.mul_add(w1 * w1, i2 * (w2 * w2));
        __S::from_f64(0.5) * i3.mul_add(w3 * w3, x1)
    }
    fn potential_energy(
        &self,
        state: &::lagrangian::State<__S, 3>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let theta: __S = state.x.q[1];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        m * g * l * theta.cos()
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::ConstantsOfMotion<3, 2, __S> for HeavyTop {
    const CONSTANTS_OF_MOTION: [&'static str; 2] = Self::CONSTANTS_OF_MOTION;
    const IGNORABLE_COORDINATES: &'static [usize] = Self::IGNORABLE_COORDINATES;
}
