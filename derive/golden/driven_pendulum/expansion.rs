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
        ::lagrangian::Inputs::<1usize, 1usize, _>::inputs(self)
    }
    /// The equations of motion as they were derived, in lines of Unicode.
    pub const EQUATIONS: &'static str = "q = θ\nT = ½ m l² θ\u{307}²\nV = −m g l cos θ\n\nMomenta p = ∂L/∂q\u{307}:\np_θ = m l² θ\u{307}\n\nEnergy function h = Σ p q\u{307} − L:\nh = T + V\ndh/dt = torque·θ\u{307} − friction·θ\u{307}²\n\nLagrange's equations d/dt (∂L/∂q\u{307}) − ∂L/∂q = Q (4.6):\nm l² θ\u{308} + m g l sin θ = torque − friction·θ\u{307}\n\nSolved for the accelerations:\nθ\u{308} = ((torque − friction·θ\u{307})/(m l) − g sin θ)/l\n";
    /// The same in displays of LaTeX, for `amsmath`, `KaTeX` and `MathJax`.
    pub const LATEX: &'static str = "\\begin{align*}\nq &= \\theta\n\\end{align*}\n\\begin{align*}\nT &= \\frac{1}{2} m l^{2} \\dot{\\theta}^{2} \\\\\nV &= -m g l \\cos \\theta\n\\end{align*}\nMomenta $p = \\partial L/\\partial \\dot q$:\n\\begin{align*}\np_{\\theta} &= m l^{2} \\dot{\\theta}\n\\end{align*}\nEnergy function $h = \\sum p \\dot q - L$:\n\\begin{align*}\nh &= T + V \\\\\n\\frac{dh}{dt} &= \\mathrm{torque}\\,\\dot{\\theta} - \\mathrm{friction}\\,\\dot{\\theta}^{2}\n\\end{align*}\nLagrange's equations $\\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot q} - \\frac{\\partial L}{\\partial q} = Q$ (4.6):\n\\begin{align*}\nm l^{2} \\ddot{\\theta} + m g l \\sin \\theta &= \\mathrm{torque} - \\mathrm{friction}\\,\\dot{\\theta}\n\\end{align*}\nSolved for the accelerations:\n\\begin{align*}\n\\ddot{\\theta} &= \\frac{\\frac{\\mathrm{torque} - \\mathrm{friction}\\,\\dot{\\theta}}{m l} - g \\sin \\theta}{l}\n\\end{align*}\n";
    /// The operation counts of the methods.
    pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::Operations {
        lagrangian: ::lagrangian::OperationCount {
            additions: 1usize,
            multiplications: 6usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
        energy: ::lagrangian::OperationCount {
            additions: 1usize,
            multiplications: 6usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
        momenta: ::lagrangian::OperationCount {
            additions: 0usize,
            multiplications: 3usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 0usize,
            functions: 0usize,
        },
        mass_matrix: ::lagrangian::OperationCount {
            additions: 0usize,
            multiplications: 2usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 0usize,
            functions: 0usize,
        },
        forcing: ::lagrangian::OperationCount {
            additions: 2usize,
            multiplications: 4usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
        generalized_forces: ::lagrangian::OperationCount {
            additions: 1usize,
            multiplications: 1usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 0usize,
            functions: 0usize,
        },
        prepare: ::lagrangian::OperationCount {
            additions: 0usize,
            multiplications: 7usize,
            divisions: 1usize,
            square_roots: 0usize,
            sines_and_cosines: 0usize,
            functions: 0usize,
        },
        accelerations: ::lagrangian::OperationCount {
            additions: 2usize,
            multiplications: 3usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
        inverse_dynamics: ::lagrangian::OperationCount {
            additions: 3usize,
            multiplications: 3usize,
            divisions: 0usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
        linearize: ::lagrangian::OperationCount {
            additions: 4usize,
            multiplications: 9usize,
            divisions: 3usize,
            square_roots: 0usize,
            sines_and_cosines: 1usize,
            functions: 0usize,
        },
    };
    #[doc(hidden)]
    fn __mentions(&self) {
        let x = ();
        let y = ();
        let _ = (
            &self.m,
            x,
            y,
            &self.m,
            &self.g,
            y,
            &self.friction,
            Self::THETA,
            &self.l,
            Self::THETA,
            &self.l,
            Self::THETA,
            y,
            x,
            &self.torque,
            Self::THETA,
        );
    }
}
#[automatically_derived]
impl ::lagrangian::GeneralizedCoordinates<1usize> for DrivenPendulum {
    const COORDINATES: [&'static str; 1usize] = Self::COORDINATES;
    const ANGLES: [bool; 1usize] = [true];
    const PERIODS: [u32; 1usize] = [1];
    const IGNORABLE: [bool; 1usize] = [false];
    const SINGULARITIES: [&'static [usize]; 1usize] = [&[]];
    const STAYS_REGULAR: bool = true;
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Lagrangian<1usize, __S>
for DrivenPendulum {
    type Prepared = [__S; 4usize];
    fn prepare(&self) -> [__S; 4usize] {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m * l;
        [m * g * l, __S::from_f64(1.0) / (m * (l * l)), g * x0, l * x0]
    }
    fn lagrangian(&self, state: &::lagrangian::State<__S, 1usize>) -> __S {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::lagrangian_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn energy(&self, state: &::lagrangian::State<__S, 1usize>) -> __S {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::energy_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn forcing(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::forcing_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn generalized_forces(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::generalized_forces_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn accelerations(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::accelerations_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn linearize(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::Linearization<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::linearize_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
    fn accelerations_prepared(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        prepared: &[__S; 4usize],
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::accelerations_prepared_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
            prepared,
        )
    }
    fn inverse_dynamics(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        accelerations: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::inverse_dynamics_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
            accelerations,
        )
    }
    fn inverse_dynamics_prepared(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        accelerations: &::lagrangian::__private::SVector<__S, 1usize>,
        prepared: &[__S; 4usize],
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::inverse_dynamics_prepared_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
            accelerations,
            prepared,
        )
    }
    fn momenta(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        ::lagrangian::__private::vector([m * (l * l) * theta_dot])
    }
    fn mass_matrix(
        &self,
        _state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SMatrix<__S, 1usize, 1usize> {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        ::lagrangian::__private::matrix([[m * (l * l)]])
    }
    fn relative_pivots(
        &self,
        _state: &::lagrangian::State<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m * (l * l);
        ::lagrangian::__private::by_coordinate(
            [::lagrangian::__private::relative_pivot(x0, x0.abs())],
            [&[0]],
        )
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Energies<1usize, __S> for DrivenPendulum {
    fn kinetic_energy(&self, state: &::lagrangian::State<__S, 1usize>) -> __S {
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        __S::from_f64(0.5) * (m * (l * l) * (theta_dot * theta_dot))
    }
    fn potential_energy(&self, state: &::lagrangian::State<__S, 1usize>) -> __S {
        let theta: __S = state.x.q[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        -(m * g * l * theta.cos())
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Inputs<1usize, 1usize, __S>
for DrivenPendulum {
    const INPUTS: [&'static str; 1usize] = Self::INPUTS;
    fn inputs(&self) -> ::lagrangian::__private::SVector<__S, 1usize> {
        <::lagrangian::__private::SVector<
            __S,
            1usize,
        > as ::core::convert::From<
            [__S; 1usize],
        >>::from([::lagrangian::__private::parameter(self.torque)])
    }
    fn lagrangian_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        _inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> __S {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m
            * (l
                * g
                    .mul_add(
                        theta.cos(),
                        __S::from_f64(0.5) * (l * (theta_dot * theta_dot)),
                    ));
        x0
    }
    fn energy_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        _inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> __S {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let x0 = m
            * (l
                * (-g)
                    .mul_add(
                        theta.cos(),
                        __S::from_f64(0.5) * (l * (theta_dot * theta_dot)),
                    ));
        x0
    }
    fn forcing_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        ::lagrangian::__private::vector([
            (-(m * g * l)).mul_add(theta.sin(), (-friction).mul_add(theta_dot, torque)),
        ])
    }
    fn generalized_forces_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let theta_dot: __S = state.x.v[0];
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        ::lagrangian::__private::vector([(-friction).mul_add(theta_dot, torque)])
    }
    fn accelerations_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let prepared = ::lagrangian::Lagrangian::<1usize, __S>::prepare(self);
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::accelerations_prepared_with(self, state, inputs, &prepared)
    }
    #[inline(always)]
    fn accelerations_prepared_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
        prepared: &[__S; 4usize],
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        let c0: __S = prepared[0];
        let c1: __S = prepared[1];
        ::lagrangian::__private::vector([
            (-theta.sin()).mul_add(c0, (-friction).mul_add(theta_dot, torque)) * c1,
        ])
    }
    fn inverse_dynamics_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
        accelerations: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let prepared = ::lagrangian::Lagrangian::<1usize, __S>::prepare(self);
        ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::inverse_dynamics_prepared_with(self, state, inputs, accelerations, &prepared)
    }
    fn inverse_dynamics_prepared_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
        accelerations: &::lagrangian::__private::SVector<__S, 1usize>,
        prepared: &[__S; 4usize],
    ) -> ::lagrangian::__private::SVector<__S, 1usize> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let theta_ddot: __S = accelerations[0];
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        let c2: __S = prepared[2];
        let c3: __S = prepared[3];
        ::lagrangian::__private::vector([
            friction.mul_add(theta_dot, theta_ddot.mul_add(c3, theta.sin() * c2))
                - torque,
        ])
    }
    fn linearize_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::Linearization<__S, 1usize> {
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let g: __S = ::lagrangian::__private::parameter(self.g);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let friction: __S = ::lagrangian::__private::parameter(self.friction);
        let torque: __S = inputs[0];
        let (sin_theta, cos_theta) = theta.sin_cos();
        let x0 = __S::from_f64(1.0) / l;
        let x1 = x0 * (__S::from_f64(1.0) / m * x0);
        ::lagrangian::Linearization {
            position: ::lagrangian::__private::matrix([[-(g * cos_theta / l)]]),
            velocity: ::lagrangian::__private::matrix([[-(friction * x1)]]),
            time: ::lagrangian::__private::vector([__S::from_f64(0.0)]),
        }
    }
    fn input_jacobian_with(
        &self,
        _state: &::lagrangian::State<__S, 1usize>,
        _inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> ::lagrangian::__private::SMatrix<__S, 1usize, 1usize> {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let l: __S = ::lagrangian::__private::parameter(self.l);
        ::lagrangian::__private::matrix([[__S::from_f64(1.0) / (m * (l * l))]])
    }
}
#[automatically_derived]
impl ::lagrangian::Plant<1usize, 1usize> for DrivenPendulum {
    type Scalar = ::core::primitive::f64;
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
impl<__S: ::lagrangian::Scalar> ::lagrangian::Outputs<1usize, __S> for DrivenPendulum {
    type Outputs = DrivenPendulumOutputs<__S>;
    fn outputs(&self, state: &::lagrangian::State<__S, 1usize>) -> Self::Outputs {
        ::lagrangian::OutputsWith::<
            1usize,
            1usize,
            __S,
        >::outputs_with(
            self,
            state,
            &::lagrangian::Inputs::<1usize, 1usize, __S>::inputs(self),
        )
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::OutputsWith<1usize, 1usize, __S>
for DrivenPendulum {
    fn outputs_with(
        &self,
        state: &::lagrangian::State<__S, 1usize>,
        inputs: &::lagrangian::__private::SVector<__S, 1usize>,
    ) -> Self::Outputs {
        let accelerations = ::lagrangian::Inputs::<
            1usize,
            1usize,
            __S,
        >::accelerations_with(self, state, inputs);
        let theta: __S = state.x.q[0];
        let theta_dot: __S = state.x.v[0];
        let theta_ddot: __S = accelerations[0];
        let l: __S = ::lagrangian::__private::parameter(self.l);
        let (sin_theta, cos_theta) = theta.sin_cos();
        let y = -(l * cos_theta);
        DrivenPendulumOutputs {
            height: y,
            acceleration: l
                * (-sin_theta).mul_add(theta_dot * theta_dot, cos_theta * theta_ddot),
        }
    }
}
