/**# The equations of motion

d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with

```text
q = x
T = ½ m ẋ²
V = ½ k x²

Momenta p = ∂L/∂q̇:
p_x = m ẋ

Energy function h = Σ p q̇ − L:
h = T + V
dh/dt = −ẋ friction(ẋ/width, weight) − 0.1 weight·ẋ side(x)

Lagrange's equations d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6):
m ẍ + k x = −friction(ẋ/width, weight) − 0.1 weight·side(x)

Solved for the accelerations:
ẍ = −friction(ẋ/width, weight)/m − 0.1 (10 k x + weight·side(x))/m
```

# Operations

| method | + − | × | ÷ | √ | sin, cos | others |
|---|---|---|---|---|---|---|
| `lagrangian` | 1 | 5 | 0 | 0 | 0 | 0 |
| `energy` | 1 | 5 | 0 | 0 | 0 | 0 |
| `momenta` | 0 | 1 | 0 | 0 | 0 | 0 |
| `mass_matrix` | 0 | 0 | 0 | 0 | 0 | 0 |
| `forcing` | 3 | 3 | 1 | 0 | 0 | 2 |
| `generalized_forces` | 2 | 2 | 1 | 0 | 0 | 2 |
| `prepare` | 0 | 2 | 2 | 0 | 0 | 0 |
| `accelerations` | 3 | 5 | 0 | 0 | 0 | 2 |
| `inverse_dynamics` | 3 | 4 | 0 | 0 | 0 | 2 |
| `linearize` | 5 | 11 | 2 | 0 | 0 | 3 |
*/
impl Slider {
    /// The names of the coordinates, in order.
    pub const COORDINATES: [&'static str; 1usize] = ["x"];
    ///The index of the coordinate `x`.
    pub const X: usize = 0usize;
    /// The equations of motion as they were derived, in lines of Unicode.
    pub const EQUATIONS: &'static str = "q = x\nT = ½ m x\u{307}²\nV = ½ k x²\n\nMomenta p = ∂L/∂q\u{307}:\np_x = m x\u{307}\n\nEnergy function h = Σ p q\u{307} − L:\nh = T + V\ndh/dt = −x\u{307} friction(x\u{307}/width, weight) − 0.1 weight·x\u{307} side(x)\n\nLagrange's equations d/dt (∂L/∂q\u{307}) − ∂L/∂q = Q (4.6):\nm x\u{308} + k x = −friction(x\u{307}/width, weight) − 0.1 weight·side(x)\n\nSolved for the accelerations:\nx\u{308} = −friction(x\u{307}/width, weight)/m − 0.1 (10 k x + weight·side(x))/m\n";
    /// The same in displays of LaTeX, for `amsmath`, `KaTeX` and `MathJax`.
    pub const LATEX: &'static str = "\\begin{align*}\nq &= x\n\\end{align*}\n\\begin{align*}\nT &= \\frac{1}{2} m \\dot{x}^{2} \\\\\nV &= \\frac{1}{2} k x^{2}\n\\end{align*}\nMomenta $p = \\partial L/\\partial \\dot q$:\n\\begin{align*}\np_{x} &= m \\dot{x}\n\\end{align*}\nEnergy function $h = \\sum p \\dot q - L$:\n\\begin{align*}\nh &= T + V \\\\\n\\frac{dh}{dt} &= -\\dot{x} \\operatorname{friction}\\left(\\frac{\\dot{x}}{\\mathrm{width}}, \\mathrm{weight}\\right) - 0.1 \\mathrm{weight}\\,\\dot{x} \\operatorname{side}\\left(x\\right)\n\\end{align*}\nLagrange's equations $\\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot q} - \\frac{\\partial L}{\\partial q} = Q$ (4.6):\n\\begin{align*}\nm \\ddot{x} + k x &= -\\operatorname{friction}\\left(\\frac{\\dot{x}}{\\mathrm{width}}, \\mathrm{weight}\\right) - 0.1 \\mathrm{weight}\\,\\operatorname{side}\\left(x\\right)\n\\end{align*}\nSolved for the accelerations:\n\\begin{align*}\n\\ddot{x} &= -\\frac{\\operatorname{friction}\\left(\\frac{\\dot{x}}{\\mathrm{width}}, \\mathrm{weight}\\right)}{m} - \\frac{0.1 \\left(10 k x + \\mathrm{weight}\\,\\operatorname{side}\\left(x\\right)\\right)}{m}\n\\end{align*}\n";
    /// The operation counts of the methods.
    pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::__private::operations([
        [1, 1, 0, 0, 3, 2, 0, 3, 3, 5],
        [5, 5, 1, 0, 3, 2, 2, 5, 4, 11],
        [0, 0, 0, 0, 1, 1, 2, 0, 0, 2],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 2, 2, 0, 2, 2, 3],
    ]);
    #[doc(hidden)]
    fn __mentions(&self) {
        let [friction, side] = [(); 2usize];
        let _ = (&self.m, Self::X);
        let _ = (&self.k, Self::X);
        let _ = (
            friction,
            Self::X,
            &self.width,
            &self.weight,
            &self.weight,
            side,
            Self::X,
        );
        let _ = (Self::X,);
        let _ = |v: (), load: ()| (v, load, v, load, v, load, friction, v);
        let _ = |x: ()| (x, x);
    }
}
#[automatically_derived]
impl ::lagrangian::GeneralizedCoordinates<1> for Slider {
    const COORDINATES: [&'static str; 1] = Self::COORDINATES;
    const STAYS_REGULAR: bool = true;
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Quantities<1, __S> for Slider {
    type Inputs = ::lagrangian::__private::SVector<__S, 0>;
    fn inputs(&self) -> ::lagrangian::__private::SVector<__S, 0> {
        ::lagrangian::__private::vector([])
    }
    fn lagrangian(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 8],
    ) -> __S {
        let [m, k, ..] = *prepared;
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let x0 = (-k).mul_add(x * x, m * (x_dot * x_dot));
        __S::from_f64(0.5) * x0
    }
    fn energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let k: __S = ::lagrangian::__private::parameter(self.k);
        let x0 = k.mul_add(x * x, m * (x_dot * x_dot));
        __S::from_f64(0.5) * x0
    }
    fn momenta(
        &self,
        state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let x_dot: __S = state.x.v[0];
        let m: __S = prepared[0];
        ::lagrangian::__private::vector([m * x_dot])
    }
    fn mass_matrix(
        &self,
        _state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SMatrix<__S, 1, 1> {
        let m: __S = prepared[0];
        ::lagrangian::__private::matrix([[m]])
    }
    fn forcing(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let [_, _, weight, width, ..] = *prepared;
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let x0 = self.__value_of_friction::<__S>(x_dot / width, weight);
        let k: __S = prepared[1];
        let x1 = weight * self.__value_of_side::<__S>(x);
        ::lagrangian::__private::vector([
            -k.mul_add(x, __S::ratio(1.0, 10.0).mul_add(x1, x0)),
        ])
    }
    fn generalized_forces(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let weight: __S = ::lagrangian::__private::parameter(self.weight);
        let width: __S = ::lagrangian::__private::parameter(self.width);
        let x0 = self.__value_of_friction::<__S>(x_dot / width, weight);
        let x1 = weight * self.__value_of_side::<__S>(x);
        ::lagrangian::__private::vector([-__S::ratio(1.0, 10.0).mul_add(x1, x0)])
    }
    type Prepared = [__S; 8];
    fn prepare(&self) -> [__S; 8] {
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let k: __S = ::lagrangian::__private::parameter(self.k);
        let weight: __S = ::lagrangian::__private::parameter(self.weight);
        let width: __S = ::lagrangian::__private::parameter(self.width);
        [
            m,
            k,
            weight,
            width,
            __S::from_f64(1.0) / width,
            k * __S::from_f64(10.0),
            __S::ratio(1.0, 10.0) / m,
            weight * __S::ratio(1.0, 10.0),
        ]
    }
    #[inline(always)]
    fn accelerations(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let [_, _, weight, _, c0, ..] = *prepared;
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let x0 = self.__value_of_friction::<__S>(x_dot * c0, weight);
        let x1 = self.__value_of_side::<__S>(x);
        let [_, _, _, _, _, c1, c2, ..] = *prepared;
        let x2 = x.mul_add(c1, weight * x1);
        ::lagrangian::__private::vector([-(__S::from_f64(10.0).mul_add(x0, x2) * c2)])
    }
    fn inverse_dynamics(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
        accelerations: &::lagrangian::__private::SVector<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let [_, _, weight, _, c0, ..] = *prepared;
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let x0 = self.__value_of_friction::<__S>(x_dot * c0, weight);
        let [m, k, _, _, _, _, _, c3] = *prepared;
        let x_ddot: __S = accelerations[0];
        let x1 = self.__value_of_side::<__S>(x).mul_add(c3, x0);
        ::lagrangian::__private::vector([m.mul_add(x_ddot, k.mul_add(x, x1))])
    }
    fn relative_pivots(
        &self,
        _state: &::lagrangian::State<__S, 1>,
        prepared: &[__S; 8],
    ) -> ::lagrangian::__private::SVector<__S, 1> {
        let m: __S = prepared[0];
        ::lagrangian::__private::relative_pivots([m], [m.abs()], [], [&[0]])
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::Lagrangian<1, __S> for Slider {
    type Model = Self;
    fn model(&self) -> &Self {
        self
    }
}
#[automatically_derived]
impl ::lagrangian::__private::SharesLanes for Slider {}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::StateJacobian<1, __S>
for Slider {
    fn linearize(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> ::lagrangian::Linearization<__S, 1> {
        let x: __S = state.x.q[0];
        let x_dot: __S = state.x.v[0];
        let weight: __S = ::lagrangian::__private::parameter(self.weight);
        let width: __S = ::lagrangian::__private::parameter(self.width);
        let x0 = __S::from_f64(1.0) / width;
        let x1 = x_dot * x0;
        let x2 = self.__value_of_friction::<__S>(x1, weight);
        let x3 = self.__value_of_side::<__S>(x);
        let m: __S = ::lagrangian::__private::parameter(self.m);
        let k: __S = ::lagrangian::__private::parameter(self.k);
        let x4 = k.mul_add(x, x2);
        let x5 = __S::from_f64(1.0) / m;
        let x6 = __S::from_f64(10.0).mul_add(x4, weight * x3) * x5;
        let x7 = __S::ratio(1.0, 10.0) * x6;
        let x8 = x1.sech();
        ::lagrangian::Linearization {
            position: ::lagrangian::__private::matrix([[-(k * x5)]]),
            velocity: ::lagrangian::__private::matrix([
                [-(weight * x0 * x5 * (x8 * x8))],
            ]),
            time: ::lagrangian::__private::SVector::zeros(),
        }
    }
}
#[automatically_derived]
impl<__S: ::lagrangian::Scalar> ::lagrangian::quantities::Energies<1, __S> for Slider {
    fn kinetic_energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let x_dot: __S = state.x.v[0];
        let m: __S = ::lagrangian::__private::parameter(self.m);
        __S::from_f64(0.5) * (m * (x_dot * x_dot))
    }
    fn potential_energy(
        &self,
        state: &::lagrangian::State<__S, 1>,
        _inputs: &::lagrangian::__private::SVector<__S, 0>,
    ) -> __S {
        let x: __S = state.x.q[0];
        let k: __S = ::lagrangian::__private::parameter(self.k);
        __S::from_f64(0.5) * (k * (x * x))
    }
}
impl Slider {
    #[inline]
    fn __value_of_friction<AnyScalar: ::lagrangian::Scalar>(
        &self,
        v: AnyScalar,
        load: AnyScalar,
    ) -> AnyScalar {
        v.tanh() * load
    }
    #[inline]
    fn __value_of_side<AnyScalar: ::lagrangian::Scalar>(
        &self,
        x: AnyScalar,
    ) -> AnyScalar {
        x.signum()
    }
    #[inline]
    fn __derivative_of_friction_by_0<__S: ::lagrangian::Scalar>(
        &self,
        arguments: [__S; 2usize],
    ) -> __S {
        let v: __S = arguments[0];
        let x0 = v.sech();
        let load: __S = arguments[1];
        load * (x0 * x0)
    }
    #[inline]
    fn __derivative_of_friction_by_1<__S: ::lagrangian::Scalar>(
        &self,
        arguments: [__S; 2usize],
    ) -> __S {
        let v: __S = arguments[0];
        self.__value_of_friction::<__S>(v, __S::from_f64(1.0))
    }
    #[inline]
    fn __derivative_of_side_by_0<__S: ::lagrangian::Scalar>(
        &self,
        _arguments: [__S; 1usize],
    ) -> __S {
        __S::from_f64(0.0)
    }
}
#[automatically_derived]
impl ::lagrangian::ExternalFunctions for Slider {
    type Scalar = ::core::primitive::f64;
    const FUNCTIONS: &'static [::lagrangian::FunctionSignature] = &[
        ::lagrangian::FunctionSignature {
            name: "friction",
            arguments: &["v", "load"],
        },
        ::lagrangian::FunctionSignature {
            name: "side",
            arguments: &["x"],
        },
    ];
    fn function(
        &self,
        function: usize,
        arguments: &[::core::primitive::f64],
    ) -> ::core::primitive::f64 {
        match (function, arguments) {
            (0, &[x0, x1]) => self.__value_of_friction(x0, x1),
            (1, &[x0]) => self.__value_of_side(x0),
            _ => {
                <::core::primitive::f64 as ::lagrangian::Scalar>::from_f64(
                    ::core::primitive::f64::NAN,
                )
            }
        }
    }
    fn derivative(
        &self,
        function: usize,
        argument: usize,
        arguments: &[::core::primitive::f64],
    ) -> ::core::option::Option<::core::primitive::f64> {
        match (function, argument, arguments) {
            (0, 0, &[x0, x1]) => {
                ::core::option::Option::Some(
                    self.__derivative_of_friction_by_0([x0, x1]),
                )
            }
            (0, 1, &[x0, x1]) => {
                ::core::option::Option::Some(
                    self.__derivative_of_friction_by_1([x0, x1]),
                )
            }
            (1, 0, &[x0]) => {
                ::core::option::Option::Some(self.__derivative_of_side_by_0([x0]))
            }
            _ => ::core::option::Option::None,
        }
    }
}
