use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        r = [x, y, 0.0],
        inertia = [[x, y], [y, x]],
        powers = sqr(x) + squared(x) + x.square() + pow(x, 2) + power(x, 2) + Pow(x, 2) + cube(x),
        roots = cbrt(x) + rsqrt(x) + root(x, 3) + hypot(x, y),
        logarithms = log(x) + log2(x) + log10(x) + log1p(x) + expm1(x) + exp2(x) + Exp(x),
        inverses = arcsin(x) + arccos(x) + arctan(x) + arcsinh(x) + arctan2(y, x) + tan2(y, x),
        reciprocals = sec(x) + csc(x) + cot(x) + sech(x) + coth(x) + acot(x),
        degrees = sind(x) + deg2rad(x) + radians(x),
        signs = sgn(x) + fabs(x) + copysign(x, y) + abs2(x),
        steps = Heaviside(x) + unit_step(x) + floor(x) + fmod(x, 1.0) + relu(x),
        cases = Piecewise(x, y) + ifelse(x, y) + clip(x, 0.0, 1.0) + fmax(x, y),
        steep = sigmoid(x) + DiracDelta(x),
        rates = diff(x, t) + Derivative(x, t) + vel(x) + x.dt() + gradient(x) + time(),
        lengths = mag(r) + r.length() + norm2(r),
        products = inner(r, r) + skew(r) + unit(r) + kron(r, r),
        matrices = det(inertia) + inv(inertia) + eye(3) + zeros(3) + vec3(x, y, x) + tr(inertia),
        rotations = rotx(x) + R_z(x) + quat(x),
        sums = range(3) + sum(x, 0, 4) + linspace(0, 1) + SIN(x),
        numbers = e.powf(x) + M_PI * x + TAU,
        quantities = r.x() + inertia.t() + x.velocity + x.sqrt + math.pi + Math.sin(x) + x.into(),
    ),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
)]
struct Particle {
    m: f64,
}

fn main() {}
