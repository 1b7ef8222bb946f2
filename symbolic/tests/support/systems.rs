//! Mechanical systems that several tests are about.

use lagrangian_symbolic::{Expression, Model, Node, Rational, Symbol};

use super::draft::Draft;

/// A pendulum on a pivot that moves up and down as a sin(w t), from positions: parameters m, l, g, a, w.
pub(crate) fn driven_pendulum() -> Model {
    let mut draft = Draft::new(1);
    let [m, l, g, a, w] = core::array::from_fn(|i| draft.parameter(u32::try_from(i).unwrap()));
    let t = draft.graph.symbol(Symbol::Time);
    let q = draft.q(0);
    let (sin, cos) = (draft.sin(q), draft.cos(q));
    let x = draft.times(&[l, sin]);
    let phase = draft.times(&[w, t]);
    let sin_phase = draft.sin(phase);
    let pivot = draft.times(&[a, sin_phase]);
    let drop = draft.times(&[l, cos]);
    let y = draft.graph.subtract(pivot, drop);
    let (vx, vy) = (draft.dot(x), draft.dot(y));
    let (vx2, vy2) = (draft.square(vx), draft.square(vy));
    let speed = draft.plus(&[vx2, vy2]);
    let twice = draft.times(&[m, speed]);
    let kinetic = draft.half(twice);
    let potential = draft.times(&[m, g, y]);
    draft.natural(kinetic, potential)
}

/// Some angles of a rigid body, and what belongs to each axis.
pub(crate) type Rates = [Expression; 3];

/// The angular velocity (4.4) about the body's axes, in Euler's angles φ, θ, ψ.
pub(crate) fn euler_rates(draft: &mut Draft) -> Rates {
    let (theta, psi) = (draft.q(1), draft.q(2));
    let (vphi, vtheta, vpsi) = (draft.v(0), draft.v(1), draft.v(2));
    let [(st, ct), (sp, cp)] = [theta, psi].map(|x| (draft.sin(x), draft.cos(x)));
    let (a, b) = (draft.times(&[vphi, st, sp]), draft.times(&[vtheta, cp]));
    let w1 = draft.plus(&[a, b]);
    let (a, b) = (draft.times(&[vphi, st, cp]), draft.times(&[vtheta, sp]));
    let w2 = draft.graph.subtract(a, b);
    let a = draft.times(&[vphi, ct]);
    [w1, w2, draft.plus(&[a, vpsi])]
}

/// The angular velocity about the body's axes, in Cardan's angles about x, y, z.
pub(crate) fn cardan_rates(draft: &mut Draft) -> Rates {
    let (beta, gamma) = (draft.q(1), draft.q(2));
    let (va, vb, vc) = (draft.v(0), draft.v(1), draft.v(2));
    let [(sb, cb), (sc, cc)] = [beta, gamma].map(|x| (draft.sin(x), draft.cos(x)));
    let (a, b) = (draft.times(&[va, cb, cc]), draft.times(&[vb, sc]));
    let w1 = draft.plus(&[a, b]);
    let (a, b) = (draft.times(&[va, cb, sc]), draft.times(&[vb, cc]));
    let w2 = draft.graph.subtract(b, a);
    let a = draft.times(&[va, sb]);
    [w1, w2, draft.plus(&[a, vc])]
}

/// The angular velocity about the line of nodes and its companions: sin θ φ̇, θ̇, ψ̇ + cos θ φ̇.
pub(crate) fn node_rates(draft: &mut Draft) -> Rates {
    let theta = draft.q(1);
    let (vphi, vtheta, vpsi) = (draft.v(0), draft.v(1), draft.v(2));
    let (st, ct) = (draft.sin(theta), draft.cos(theta));
    let a = draft.times(&[vphi, ct]);
    [draft.times(&[st, vphi]), vtheta, draft.plus(&[a, vpsi])]
}

/// ½ Σ Iₖ wₖ² with the parameters of these numbers as inertias.
pub(crate) fn kinetic(draft: &mut Draft, rates: &[Expression], inertias: &[u32]) -> Expression {
    let mut terms = Vec::new();
    for (rate, inertia) in rates.iter().zip(inertias) {
        let (inertia, square) = (draft.parameter(*inertia), draft.square(*rate));
        terms.push(draft.times(&[inertia, square]));
    }
    let twice = draft.plus(&terms);
    draft.half(twice)
}

/// The free rigid body of (4.5): parameters I₁, I₂, I₃; coordinates φ, θ, ψ.
pub(crate) fn rigid_body() -> (Model, Rates) {
    let mut draft = Draft::new(3);
    let w = euler_rates(&mut draft);
    let energy = kinetic(&mut draft, &w, &[0, 1, 2]);
    let zero = draft.graph.zero();
    (draft.natural(energy, zero), w)
}

/// A top with the inertias of these numbers, under gravity P₃ cos θ.
pub(crate) fn top(rates: fn(&mut Draft) -> Rates, inertias: [u32; 3]) -> Model {
    let mut draft = Draft::new(3);
    let w = rates(&mut draft);
    let energy = kinetic(&mut draft, &w, &inertias);
    heavy(draft, energy)
}

/// A model of this kinetic energy under gravity P₃ cos θ.
pub(crate) fn heavy(mut draft: Draft, kinetic: Expression) -> Model {
    let (weight, theta) = (draft.parameter(3), draft.q(1));
    let cosine = draft.cos(theta);
    let potential = draft.times(&[weight, cosine]);
    draft.natural(kinetic, potential)
}

/// How the top's energy is written.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Spelling {
    /// ½ Σ Iₖ wₖ².
    Squares,
    /// w₂² as the sum of its terms.
    SecondMultipliedOut,
    /// All three squares as sums of their terms.
    MultipliedOut,
    /// ½ Σ wₖ (Iₖ wₖ), products of inertia left out.
    Tensor,
}

/// The general top under gravity.
pub(crate) fn general_top(spelling: Spelling) -> Model {
    let mut draft = Draft::new(3);
    let w = euler_rates(&mut draft);
    let mut terms = Vec::new();
    for (k, rate) in (0..).zip(w) {
        let inertia = draft.parameter(k);
        let opens = match spelling {
            Spelling::Squares => false,
            Spelling::SecondMultipliedOut => k == 1,
            Spelling::MultipliedOut => true,
            Spelling::Tensor => {
                let momentum = draft.times(&[inertia, rate]);
                terms.push(draft.times(&[rate, momentum]));
                continue;
            }
        };
        if opens {
            for square in multiplied_out(&mut draft, rate) {
                terms.push(draft.times(&[inertia, square]));
            }
        } else {
            let square = draft.square(rate);
            terms.push(draft.times(&[inertia, square]));
        }
    }
    let twice = draft.plus(&terms);
    let energy = draft.half(twice);
    heavy(draft, energy)
}

/// (a + b)² as a², b² and 2 a b.
fn multiplied_out(draft: &mut Draft, sum: Expression) -> Vec<Expression> {
    let Node::Sum(terms) = draft.graph.node(sum).clone() else {
        panic!("not a sum");
    };
    let [a, b] = [0, 1].map(|i| draft.graph.scale(terms[i].0, &terms[i].1));
    let (first, second, mixed) = (draft.square(a), draft.square(b), draft.times(&[a, b]));
    vec![
        first,
        second,
        draft.graph.scale(mixed, &Rational::integer(2)),
    ]
}

/// A chain of bodies on massless links.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::struct_excessive_bools)] // Any of them with any other is a chain.
pub(crate) struct Chain {
    pub(crate) links: u32,
    /// Angles from link to link instead of from the vertical.
    pub(crate) relative: bool,
    /// Each link has a mass and a length of its own.
    pub(crate) different: bool,
    /// The energies of the bodies are added from the last to the first.
    pub(crate) reversed: bool,
    /// The pivot moves along a sin(w t).
    pub(crate) driven: bool,
}

impl Chain {
    /// Equal links, their angles from the vertical.
    pub(crate) fn of(links: u32) -> Self {
        Self {
            links,
            relative: false,
            different: false,
            reversed: false,
            driven: false,
        }
    }

    pub(crate) fn model(self) -> Model {
        let mut draft = Draft::new(self.links);
        let (mut x, mut y) = (self.pivot(&mut draft), draft.graph.zero());
        let mut angle = draft.graph.zero();
        let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
        let gravity = draft.parameter(100);
        for k in 0..self.links {
            let own = if self.different { 2 * k } else { 0 };
            let [mass, length] = [own, own + 1].map(|i| draft.parameter(i));
            let q = draft.q(k);
            angle = if self.relative {
                draft.plus(&[angle, q])
            } else {
                q
            };
            let (sin, cos) = (draft.sin(angle), draft.cos(angle));
            let (across, down) = (draft.times(&[length, sin]), draft.times(&[length, cos]));
            x = draft.plus(&[x, across]);
            y = draft.graph.subtract(y, down);
            kinetic.push(energy(&mut draft, mass, &[x, y]));
            potential.push(draft.times(&[mass, gravity, y]));
        }
        if self.reversed {
            kinetic.reverse();
        }
        let (kinetic, potential) = (draft.plus(&kinetic), draft.plus(&potential));
        draft.natural(kinetic, potential)
    }

    fn pivot(self, draft: &mut Draft) -> Expression {
        if !self.driven {
            return draft.graph.zero();
        }
        let (a, w) = (draft.parameter(101), draft.parameter(102));
        let time = draft.graph.symbol(Symbol::Time);
        let phase = draft.times(&[w, time]);
        let sine = draft.sin(phase);
        draft.times(&[a, sine])
    }
}

/// ½ m Σ ẋᵢ² of a point.
fn energy(draft: &mut Draft, mass: Expression, position: &[Expression]) -> Expression {
    let mut squares = Vec::new();
    for x in position {
        let rate = draft.dot(*x);
        squares.push(draft.square(rate));
    }
    let speed = draft.plus(&squares);
    let twice = draft.times(&[mass, speed]);
    draft.half(twice)
}

/// A pole on a cart that an input pushes: coordinates x, θ.
pub(crate) fn cart_pole() -> Model {
    let mut draft = Draft::new(2);
    let [cart, pole, length, gravity] = [0, 1, 2, 3].map(|i| draft.parameter(i));
    let (x, theta) = (draft.q(0), draft.q(1));
    let (sin, cos) = (draft.sin(theta), draft.cos(theta));
    let (across, height) = (draft.times(&[length, sin]), draft.times(&[length, cos]));
    let tip = draft.plus(&[x, across]);
    let first = energy(&mut draft, cart, &[x]);
    let second = energy(&mut draft, pole, &[tip, height]);
    let kinetic = draft.plus(&[first, second]);
    let potential = draft.times(&[pole, gravity, height]);
    let push = draft.graph.symbol(Symbol::Input(0));
    let mut model = draft.natural(kinetic, potential);
    model.forces[0] = push;
    model
}

/// A planar point in polar coordinates r, φ: T = ½ m (ṙ² + r² φ̇²), V = −1/r.
pub(crate) fn polar() -> Model {
    let mut draft = Draft::new(2);
    let (m, r) = (draft.parameter(0), draft.q(0));
    let (vr, vphi) = (draft.v(0), draft.v(1));
    let [r2, vr2, vphi2] = [r, vr, vphi].map(|x| draft.square(x));
    let across = draft.times(&[r2, vphi2]);
    let speed = draft.plus(&[vr2, across]);
    let twice = draft.times(&[m, speed]);
    let kinetic = draft.half(twice);
    let inverse = draft.graph.power(r, &Rational::MINUS_ONE);
    let potential = draft.graph.negate(inverse);
    draft.natural(kinetic, potential)
}

/// A charged point in a magnetic field: V = −½ b (x ẏ − y ẋ) + x y, with drag and an explicit time.
pub(crate) fn charged() -> Model {
    let mut draft = Draft::new(2);
    let (m, b) = (draft.parameter(0), draft.parameter(1));
    let (x, y, vx, vy) = (draft.q(0), draft.q(1), draft.v(0), draft.v(1));
    let (vx2, vy2) = (draft.square(vx), draft.square(vy));
    let speed = draft.plus(&[vx2, vy2]);
    let twice = draft.times(&[m, speed]);
    let kinetic = draft.half(twice);
    let (first, second) = (draft.times(&[x, vy]), draft.times(&[y, vx]));
    let moment = draft.graph.subtract(second, first);
    let time = draft.graph.symbol(Symbol::Time);
    let magnetic = draft.times(&[b, time, moment]);
    let static_part = draft.times(&[x, y]);
    let potential = draft.plus(&[magnetic, static_part]);
    let drag = draft.half(speed);
    let mut model = draft.natural(kinetic, potential);
    model.dissipation = drag;
    model
}

/// L = ẋẏ − xy.
pub(crate) fn indefinite() -> Model {
    let mut draft = Draft::new(2);
    let (x, y, vx, vy) = (draft.q(0), draft.q(1), draft.v(0), draft.v(1));
    let (kinetic, potential) = (draft.times(&[vx, vy]), draft.times(&[x, y]));
    draft.natural(kinetic, potential)
}

/// L = ½ ẋ² + ¼ ẋ⁴ − x², whose mass depends on the velocity.
pub(crate) fn stiffening() -> Model {
    let mut draft = Draft::new(1);
    let (x, v) = (draft.q(0), draft.v(0));
    let [x2, v2] = [x, v].map(|x| draft.square(x));
    let quarter = Rational::new(1, 4).unwrap();
    let fourth = draft.square(v2);
    let terms = [(v2, Rational::HALF), (fourth, quarter)];
    let kinetic = draft.graph.sum(terms);
    draft.natural(kinetic, x2)
}
