//! Mechanical systems that several tests are about.

use super::{Draft, Quantity};
use crate::{Model, Node};

/// A pendulum on a pivot that moves up and down as a sin(w t), from positions: parameters m, l, g, a, w.
pub fn driven_pendulum() -> Model {
    let draft = Draft::new(1);
    let [m, l, g, a, w] = draft.ps();
    let (q, t) = (draft.q(0), draft.time());
    let x = l * q.sin();
    let y = a * (w * t).sin() - l * q.cos();
    let kinetic = m * (x.dot().squared() + y.dot().squared()) / 2;
    draft.natural(kinetic, m * g * y)
}

/// Rates of three coordinates about three axes.
pub type Rates<'d> = [Quantity<'d>; 3];

/// The angular velocity (4.4) about the body's axes, in Euler's angles φ, θ, ψ.
pub fn euler_rates(draft: &Draft) -> Rates<'_> {
    let [phi, theta, psi] = draft.qs();
    [
        phi.dot() * theta.sin() * psi.sin() + theta.dot() * psi.cos(),
        phi.dot() * theta.sin() * psi.cos() - theta.dot() * psi.sin(),
        phi.dot() * theta.cos() + psi.dot(),
    ]
}

/// The angular velocity about the body's axes, in Cardan's angles about x, y, z.
pub fn cardan_rates(draft: &Draft) -> Rates<'_> {
    let [alpha, beta, gamma] = draft.qs();
    [
        alpha.dot() * beta.cos() * gamma.cos() + beta.dot() * gamma.sin(),
        beta.dot() * gamma.cos() - alpha.dot() * beta.cos() * gamma.sin(),
        alpha.dot() * beta.sin() + gamma.dot(),
    ]
}

/// The angular velocity about the line of nodes and its companions: sin θ φ̇, θ̇, ψ̇ + cos θ φ̇.
pub fn node_rates(draft: &Draft) -> Rates<'_> {
    let [phi, theta, psi] = draft.qs();
    [
        theta.sin() * phi.dot(),
        theta.dot(),
        phi.dot() * theta.cos() + psi.dot(),
    ]
}

/// ½ Σ Iₖ wₖ² with the parameters of these numbers as inertias.
pub fn kinetic<'d>(draft: &'d Draft, rates: &[Quantity<'d>], inertias: &[u32]) -> Quantity<'d> {
    let each = rates.iter().zip(inertias);
    draft.sum(each.map(|(w, i)| draft.p(*i) * w.squared())) / 2
}

/// The free rigid body of (4.5): parameters I₁, I₂, I₃; coordinates φ, θ, ψ.
pub fn rigid_body() -> Model {
    let draft = Draft::new(3);
    let energy = kinetic(&draft, &euler_rates(&draft), &[0, 1, 2]);
    draft.natural(energy, draft.zero())
}

/// A top with the inertias of these numbers, under gravity P₃ cos θ.
pub fn top(rates: fn(&Draft) -> Rates<'_>, inertias: [u32; 3]) -> Model {
    let draft = Draft::new(3);
    let energy = kinetic(&draft, &rates(&draft), &inertias);
    draft.natural(energy, weight(&draft))
}

/// P₃ cos θ.
fn weight(draft: &Draft) -> Quantity<'_> {
    draft.p(3) * draft.q(1).cos()
}

/// How the top's energy is written.
#[derive(Clone, Copy, Debug)]
pub enum Spelling {
    /// ½ Σ Iₖ wₖ².
    Squares,
    /// w₂² as the sum of its terms.
    SecondExpanded,
    /// All three squares as sums of their terms.
    Expanded,
    /// ½ Σ wₖ (Iₖ wₖ), products of inertia left out.
    Tensor,
}

/// The general top under gravity.
pub fn general_top(spelling: Spelling) -> Model {
    let draft = Draft::new(3);
    let mut terms = Vec::new();
    for (k, w) in (0..).zip(euler_rates(&draft)) {
        let inertia = draft.p(k);
        let is_expanded = match spelling {
            Spelling::Squares => false,
            Spelling::SecondExpanded => k == 1,
            Spelling::Expanded => true,
            Spelling::Tensor => {
                terms.push(w * (inertia * w));
                continue;
            }
        };
        if is_expanded {
            terms.extend(expanded_square(&draft, w).map(|square| inertia * square));
        } else {
            terms.push(inertia * w.squared());
        }
    }
    draft.natural(draft.sum(terms) / 2, weight(&draft))
}

/// (a + b)² as a², b² and 2 a b.
fn expanded_square<'d>(draft: &'d Draft, sum: Quantity<'d>) -> [Quantity<'d>; 3] {
    let Node::Sum(terms) = draft.graph().node(sum.expression()).clone() else {
        panic!("not a sum");
    };
    let [a, b] = [0, 1].map(|i| draft.make(|graph| graph.scale(terms[i].0, &terms[i].1)));
    [a.squared(), b.squared(), 2 * (a * b)]
}

/// A chain of bodies on massless links.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::struct_excessive_bools)] // Any of them with any other is a chain.
pub struct Chain {
    pub links: u32,
    /// Angles from link to link instead of from the vertical.
    pub relative: bool,
    /// Each link has a mass and a length of its own.
    pub different: bool,
    /// The energies of the bodies are added from the last to the first.
    pub reversed: bool,
    /// The pivot moves along a sin(w t).
    pub driven: bool,
}

impl Chain {
    /// Equal links, their angles from the vertical.
    pub fn of(links: u32) -> Self {
        Self {
            links,
            relative: false,
            different: false,
            reversed: false,
            driven: false,
        }
    }

    pub fn model(self) -> Model {
        let draft = Draft::new(self.links);
        let [mut x, mut y] = [self.pivot(&draft), draft.zero()];
        let mut angle = draft.zero();
        let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
        let g = draft.p(100);
        for k in 0..self.links {
            let own = if self.different { 2 * k } else { 0 };
            let [m, l] = [own, own + 1].map(|i| draft.p(i));
            let q = draft.q(k);
            angle = if self.relative { angle + q } else { q };
            x = x + l * angle.sin();
            y = y - l * angle.cos();
            kinetic.push(point_mass(&draft, m, &[x, y]));
            potential.push(m * g * y);
        }
        if self.reversed {
            kinetic.reverse();
        }
        draft.natural(draft.sum(kinetic), draft.sum(potential))
    }

    fn pivot(self, draft: &Draft) -> Quantity<'_> {
        if !self.driven {
            return draft.zero();
        }
        let [a, w] = [101, 102].map(|i| draft.p(i));
        a * (w * draft.time()).sin()
    }
}

/// ½ m Σ ẋᵢ² of a point.
fn point_mass<'d>(draft: &'d Draft, m: Quantity<'d>, position: &[Quantity<'d>]) -> Quantity<'d> {
    m * draft.sum(position.iter().map(|x| x.dot().squared())) / 2
}

/// A pole on a cart that an input pushes: coordinates x, θ.
pub fn cart_pole() -> Model {
    let draft = Draft::new(2);
    let [cart, pole, l, g] = draft.ps();
    let [x, theta] = draft.qs();
    let tip = [x + l * theta.sin(), l * theta.cos()];
    let kinetic = point_mass(&draft, cart, &[x]) + point_mass(&draft, pole, &tip);
    let push = draft.input().expression();
    let mut model = draft.natural(kinetic, pole * g * tip[1]);
    model.forces[0] = push;
    model
}

/// A planar point in polar coordinates r, φ: T = ½ m (ṙ² + r² φ̇²), V = −1/r.
pub fn polar() -> Model {
    let draft = Draft::new(2);
    let (m, [r, phi]) = (draft.p(0), draft.qs());
    let speed = r.dot().squared() + r.squared() * phi.dot().squared();
    draft.natural(m * speed / 2, -r.recip())
}

/// A charged point in a magnetic field: V = −½ b (x ẏ − y ẋ) + x y, with drag and an explicit time.
pub fn charged() -> Model {
    let draft = Draft::new(2);
    let [m, b] = draft.ps();
    let [x, y] = draft.qs();
    let speed = x.dot().squared() + y.dot().squared();
    let magnetic = b * draft.time() * (y * x.dot() - x * y.dot());
    let drag = (speed / 2).expression();
    let mut model = draft.natural(m * speed / 2, magnetic + x * y);
    model.dissipation = drag;
    model
}

/// L = ẋẏ − xy.
pub fn indefinite() -> Model {
    let draft = Draft::new(2);
    let [x, y] = draft.qs();
    draft.natural(x.dot() * y.dot(), x * y)
}

/// L = ½ ẋ² + ¼ ẋ⁴ − x², whose mass depends on the velocity.
pub fn stiffening() -> Model {
    let draft = Draft::new(1);
    let x = draft.q(0);
    let kinetic = x.dot().squared() / 2 + x.dot().powi(4) / 4;
    draft.natural(kinetic, x.squared())
}
