/**# The equations of motion

d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with

```text
q = θ
T = ½ m l² θ̇²
V = −m g l cos θ

Momenta p = ∂L/∂q̇:
p_θ = m l² θ̇

Energy function h = Σ p q̇ − L:
h = T + V
dh/dt = torque·θ̇ − friction·θ̇²

Lagrange's equations d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6):
m l² θ̈ + m g l sin θ = torque − friction·θ̇

Solved for the accelerations:
θ̈ = ((torque − friction·θ̇)/(m l) − g sin θ)/l
```

# Operations

| method | + − | × | ÷ | √ | sin, cos | others |
|---|---|---|---|---|---|---|
| `lagrangian` | 1 | 6 | 0 | 0 | 1 | 0 |
| `energy` | 1 | 6 | 0 | 0 | 1 | 0 |
| `momenta` | 0 | 3 | 0 | 0 | 0 | 0 |
| `mass_matrix` | 0 | 2 | 0 | 0 | 0 | 0 |
| `forcing` | 2 | 4 | 0 | 0 | 1 | 0 |
| `generalized_forces` | 1 | 1 | 0 | 0 | 0 | 0 |
| `prepare` | 0 | 7 | 1 | 0 | 0 | 0 |
| `accelerations` | 2 | 3 | 0 | 0 | 1 | 0 |
| `inverse_dynamics` | 3 | 3 | 0 | 0 | 1 | 0 |
| `linearize` | 4 | 9 | 3 | 0 | 1 | 0 |
*/
impl DrivenPendulum {
    /// The names of the coordinates, in order.
    pub const COORDINATES: [&'static str; 1usize] = ["theta"];
    ///The index of the coordinate `theta`.
    pub const THETA: usize = 0usize;
    /// The names of the inputs, in order.
    pub const INPUTS: [&'static str; 1usize] = ["torque"];
    ///The index of the input `torque`.
    pub const TORQUE: usize = 0usize;
    ///The inputs as the fields have them.
    pub fn inputs(
        &self,
    ) -> ::lagrangian::__private::SVector<::core::primitive::f64, 1usize> {
        ::lagrangian::quantities::Quantities::<1usize, _>::inputs(self)
    }
    /// The equations of motion as they were derived, in lines of Unicode.
    pub const EQUATIONS: &'static str = "q = θ\nT = ½ m l² θ\u{307}²\nV = −m g l cos θ\n\nMomenta p = ∂L/∂q\u{307}:\np_θ = m l² θ\u{307}\n\nEnergy function h = Σ p q\u{307} − L:\nh = T + V\ndh/dt = torque·θ\u{307} − friction·θ\u{307}²\n\nLagrange's equations d/dt (∂L/∂q\u{307}) − ∂L/∂q = Q (4.6):\nm l² θ\u{308} + m g l sin θ = torque − friction·θ\u{307}\n\nSolved for the accelerations:\nθ\u{308} = ((torque − friction·θ\u{307})/(m l) − g sin θ)/l\n";
    /// The same in displays of LaTeX, for `amsmath`, `KaTeX` and `MathJax`.
    pub const LATEX: &'static str = "\\begin{align*}\nq &= \\theta\n\\end{align*}\n\\begin{align*}\nT &= \\frac{1}{2} m l^{2} \\dot{\\theta}^{2} \\\\\nV &= -m g l \\cos \\theta\n\\end{align*}\nMomenta $p = \\partial L/\\partial \\dot q$:\n\\begin{align*}\np_{\\theta} &= m l^{2} \\dot{\\theta}\n\\end{align*}\nEnergy function $h = \\sum p \\dot q - L$:\n\\begin{align*}\nh &= T + V \\\\\n\\frac{dh}{dt} &= \\mathrm{torque}\\,\\dot{\\theta} - \\mathrm{friction}\\,\\dot{\\theta}^{2}\n\\end{align*}\nLagrange's equations $\\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot q} - \\frac{\\partial L}{\\partial q} = Q$ (4.6):\n\\begin{align*}\nm l^{2} \\ddot{\\theta} + m g l \\sin \\theta &= \\mathrm{torque} - \\mathrm{friction}\\,\\dot{\\theta}\n\\end{align*}\nSolved for the accelerations:\n\\begin{align*}\n\\ddot{\\theta} &= \\frac{\\frac{\\mathrm{torque} - \\mathrm{friction}\\,\\dot{\\theta}}{m l} - g \\sin \\theta}{l}\n\\end{align*}\n";
    /// The operation counts of the methods.
    pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::__private::operations([
        [1, 1, 0, 0, 2, 1, 0, 2, 3, 4],
        [6, 6, 3, 2, 4, 1, 7, 3, 3, 9],
        [0, 0, 0, 0, 0, 0, 1, 0, 0, 3],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [1, 1, 0, 0, 1, 0, 0, 1, 1, 1],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    ]);
    #[doc(hidden)]
    fn __mentions(&self) {
        let [x, y] = [(); 2usize];
        let _ = (&self.m, x, y);
        let _ = (&self.m, &self.g, y);
        let _ = (&self.friction, Self::THETA);
        let _ = (&self.l, Self::THETA);
        let _ = (&self.l, Self::THETA);
        let _ = (y,);
        let _ = (x,);
        let _ = (&self.torque,);
        let _ = (Self::THETA,);
    }
}
#[automatically_derived]
impl ::lagrangian::GeneralizedCoordinates<1> for DrivenPendulum {
    const COORDINATES: [&'static str; 1] = Self::COORDINATES;
    const ANGLES: [bool; 1] = [true];
    const PERIODS: [u32; 1] = [1];
    const STAYS_REGULAR: bool = true;
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Quantities<1, __S>
for DrivenPendulum {
    type Inputs = ::lagrangian::__private::SVector<__S, 1>;
    fn inputs(&self) -> ::lagrangian::__private::SVector<__S, 1> {
        ::lagrangian::__private::vector([
            ::lagrangian::__private::parameter(self.torque),
        ])
    }
    fn lagrangian(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 1>,
        prepared: &[__S; 8],
    ) -> __S {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let l: __S = prepared[2];
        let x0 = l * (theta_dot * theta_dot);
        let [m, g, ..] = *prepared;
        let x1 = g.mul_add(theta.cos(), __S::from_f64(0.5) * x0);
        m * (l * x1)
    }
    fn energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> __S {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = l * (theta_dot * theta_dot);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let x1 = (-g).mul_add(theta.cos(), __S::from_f64(0.5) * x0);
        m * (l * x1)
    }
    fn momenta(
        &self,
        state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let [m, _, l, ..] = *prepared;
        let theta_dot: __S = state.x.v[0];
        ::lagrangian::__private::vector([m * (l * l) * theta_dot])
    }
    fn mass_matrix(
        &self,
        _state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SMatrix<__S, 1, 1> {
        let [m, _, l, ..] = *prepared;
        ::lagrangian::__private::matrix([[m * (l * l)]])
    }
    fn forcing(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let friction: __S = prepared[3];
        let [m, g, l, ..] = *prepared;
        let torque: __S = inputs[0];
        let x0 = (-friction).mul_add(theta_dot, torque);
        ::lagrangian::__private::vector([(-(m * g * l)).mul_add(theta.sin(), x0)])
    }
    fn generalized_forces(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let theta_dot: __S = state.x.v[0];
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        ::lagrangian::__private::vector([(-friction).mul_add(theta_dot, torque)])
    }
    type Prepared = [__S; 8];
    fn prepare(&self) -> [__S; 8] {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let x0 = m * l;
        [
            m,
            g,
            l,
            friction,
            m * g * l,
            __S::from_f64(1.0) / (m * (l * l)),
            g * x0,
            l * x0,
        ]
    }
    #[inline(always)]
    fn accelerations(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let friction: __S = prepared[3];
        let [_, _, _, _, c0, c1, ..] = *prepared;
        let torque: __S = inputs[0];
        let x0 = (-theta.sin()).mul_add(c0, (-friction).mul_add(theta_dot, torque));
        ::lagrangian::__private::vector([x0 * c1])
    }
    fn inverse_dynamics(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
        accelerations: &::lagrangian::__private::SVector<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let friction: __S = prepared[3];
        let [_, _, _, _, _, _, c2, c3] = *prepared;
        let theta_ddot: __S = accelerations[0];
        let torque: __S = inputs[0];
        let x0 = theta_ddot.mul_add(c3, theta.sin() * c2);
        ::lagrangian::__private::vector([friction.mul_add(theta_dot, x0) - torque])
    }
    fn relative_pivots(
        &self,
        _state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let [m, _, l, ..] = *prepared;
        let x0 = m * (l * l);
        ::lagrangian::__private::relative_pivots([x0], [x0.abs()], [], [&[0]])
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Lagrangian<1, __S> for DrivenPendulum {
    type Model = Self;
    fn model(&self) -> &Self {
        self
    }
}
#[automatically_derived]
impl ::lagrangian::__private::SharesLanes for DrivenPendulum {}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::StateJacobian<1, __S>
for DrivenPendulum {
    fn linearize(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> ::lagrangian::Linearization<__S, 1> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let (sin_theta, cos_theta) = theta.sin_cos();
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let torque: __S = inputs[0];
        let x0 = (-friction).mul_add(theta_dot, torque);
        let x1 = __S::from_f64(1.0) / l;
        let x2 = x1 * (__S::from_f64(1.0) / m * x1);
        ::lagrangian::Linearization {
            position: ::lagrangian::__private::matrix([[-(g * cos_theta / l)]]),
            velocity: ::lagrangian::__private::matrix([[-(friction * x2)]]),
            time: ::lagrangian::__private::SVector::zeros(),
        }
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Energies<1, __S>
for DrivenPendulum {
    fn kinetic_energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> __S {
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m * (l * l) * (theta_dot * theta_dot);
        __S::from_f64(0.5) * x0
    }
    fn potential_energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> __S {
        let theta: __S = state.x.q[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        -(m * g * l * theta.cos())
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Inputs<1, 1, __S>
for DrivenPendulum {
    const INPUTS: [&'static str; 1usize] = Self::INPUTS;
    fn input_jacobian(
        &self,
        _state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> ::lagrangian::__private::SMatrix<__S, 1, 1> {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        ::lagrangian::__private::matrix([[__S::from_f64(1.0) / (m * (l * l))]])
    }
}
///The outputs of [`DrivenPendulum`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::cmp::Eq,
)]
pub struct DrivenPendulumOutputs<__S> {
    ///The output `height`.
    pub height: __S,
    ///The output `acceleration`.
    pub acceleration: __S,
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Outputs<1, __S>
for DrivenPendulum {
    type Outputs = DrivenPendulumOutputs<__S>;
    fn outputs(
        &self,
        state: &::lagrangian::State<__S, 1>,
        inputs: &::lagrangian::__private::SVector<__S, 1>,
    ) -> Self::Outputs {
        let accelerations = ::lagrangian::quantities::Quantities::<
            1,
            __S,
        >::accelerations(
            self,
            state,
            inputs,
            &::lagrangian::quantities::Quantities::<1, __S>::prepare(self),
        );
        let theta: __S = state.x.q[0];
        let (sin_theta, cos_theta) = theta.sin_cos();
        let theta_dot: __S = state.x.v[0];
        let theta_ddot: __S = accelerations[0];
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let y = -(l * cos_theta);
        DrivenPendulumOutputs {
            height: y,
            acceleration: l
                * (-sin_theta).mul_add(theta_dot * theta_dot, cos_theta * theta_ddot),
        }
    }
}
