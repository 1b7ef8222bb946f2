//! The recursions of textbooks for the arm, as straight-line C: inverse dynamics by Newton and Euler (Luh, Walker and Paul, On-line
//! computational scheme for mechanical manipulators, 1980), accelerations by composite bodies (Walker and Orin, Efficient
//! dynamic computer simulation of robotic mechanisms, 1982) with `LDLᵀ`, and by articulated bodies (Featherstone, The
//! calculation of robot dynamics using articulated-body inertias, 1983). All act on what moves along the axes of the
//! links, with accelerations of origins and with base inertial parameters.

#![allow(clippy::needless_range_loop)] // Indices are those of the formulas.

mod articulated_bodies;
mod composite_bodies;

use super::arm::{GRAVITY, Link, axis, links};
use super::straight_line::{Code, ONE, Value, Vector, ZERO, minus};

/// Rows.
type Block = [Vector; 3];

/// An algorithm.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Algorithm {
    /// Inverse dynamics.
    NewtonEuler,
    /// Accelerations.
    CompositeBodies,
    /// Accelerations.
    ArticulatedBodies,
}

/// The statements of an algorithm, and how many additions, multiplications and divisions they are.
pub(super) fn write(algorithm: Algorithm, count: usize) -> (String, usize) {
    let mut program = Program::new(count);
    match algorithm {
        Algorithm::NewtonEuler => program.inverse_dynamics(),
        Algorithm::CompositeBodies => program.composite_bodies(),
        Algorithm::ArticulatedBodies => program.articulated_bodies(),
    }
    program.code.finish()
}

/// A moment about the origin of a link, and a force.
#[derive(Clone, Copy)]
struct Wrench {
    moment: Vector,
    force: Vector,
}

struct Program {
    code: Code,
    links: Vec<Link>,
    /// Cosine and sine of each angle.
    turns: Vec<[Value; 2]>,
}

/// The other two axes, in order.
const fn others(k: usize) -> [usize; 2] {
    [(k + 1) % 3, (k + 2) % 3]
}

const NONE: Vector = [ZERO; 3];

impl Program {
    fn new(count: usize) -> Self {
        let mut code = Code::default();
        // The first angle changes nothing.
        let mut turns = vec![[ONE, ZERO]];
        for i in 1..count {
            turns.push(["c", "s"].map(|name| code.define(&format!("{name}[{i}]"))));
        }
        Self {
            code,
            links: links(count),
            turns,
        }
    }

    fn input(&mut self, index: usize) -> Value {
        self.code.define(&format!("x[{index}]"))
    }

    /// Along the axes of the link before.
    fn outward(&mut self, i: usize, x: Vector) -> Vector {
        let [c, s] = self.turns[i];
        let [a, b] = others(axis(i));
        let mut turned = x;
        turned[a] = self.code.sum(&[(c, x[a]), (minus(s), x[b])]);
        turned[b] = self.code.sum(&[(s, x[a]), (c, x[b])]);
        turned
    }

    /// Along the axes of the link.
    fn inward(&mut self, i: usize, x: Vector) -> Vector {
        let [c, s] = self.turns[i];
        let [a, b] = others(axis(i));
        let mut turned = x;
        turned[a] = self.code.sum(&[(c, x[a]), (s, x[b])]);
        turned[b] = self.code.sum(&[(minus(s), x[a]), (c, x[b])]);
        turned
    }

    fn place(&self, i: usize) -> Vector {
        self.links[i].place.map(Value::Constant)
    }

    /// R B Rᵀ of a symmetric block.
    fn turned_symmetric(&mut self, i: usize, block: Block) -> Block {
        let [c, s] = self.turns[i];
        let k = axis(i);
        let [a, b] = others(k);
        let code = &mut self.code;
        let square = code.product(c, c);
        let product = code.product(c, s);
        let double_sine = code.add(product, product);
        let double_cosine =
            code.sum(&[(Value::Constant(2.0), square), (Value::Constant(-1.0), ONE)]);
        let difference = code.subtract(block[a][a], block[b][b]);
        let change = code.sum(&[(square, difference), (minus(double_sine), block[a][b])]);
        let across = code.sum(&[(product, difference), (double_cosine, block[a][b])]);
        let mut turned = block;
        turned[a][a] = code.add(block[b][b], change);
        turned[b][b] = code.subtract(block[a][a], change);
        (turned[a][b], turned[b][a]) = (across, across);
        let side = [block[0][k], block[1][k], block[2][k]];
        let side = self.outward(i, side);
        for x in [a, b] {
            (turned[x][k], turned[k][x]) = (side[x], side[x]);
        }
        turned
    }

    /// What is at the origin of a link, at that of the link before.
    fn carried(&mut self, i: usize, wrench: Wrench) -> Wrench {
        let force = self.outward(i, wrench.force);
        let moment = self.outward(i, wrench.moment);
        let place = self.place(i);
        Wrench {
            moment: self.code.plus_cross(moment, place, force),
            force,
        }
    }

    /// The wrench that the motion of each link takes.
    fn wrenches(&mut self, with_accelerations: bool) -> Vec<Wrench> {
        let n = self.links.len();
        let (mut w, mut turning) = (NONE, NONE);
        let mut acceleration = [ZERO, ZERO, Value::Constant(GRAVITY)];
        let mut field = [NONE; 3];
        let mut wrenches = Vec::new();
        for i in 0..n {
            let k = axis(i);
            let rate = self.input(n + i);
            let place = self.place(i);
            for x in 0..3 {
                let row = field[x];
                let terms = [
                    (acceleration[x], ONE),
                    (row[0], place[0]),
                    (row[1], place[1]),
                    (row[2], place[2]),
                ];
                acceleration[x] = self.code.sum(&terms);
            }
            acceleration = self.inward(i, acceleration);
            w = self.inward(i, w);
            turning = self.inward(i, turning);
            let [a, b] = others(k);
            turning[a] = self.code.sum(&[(turning[a], ONE), (w[b], rate)]);
            turning[b] = self.code.sum(&[(turning[b], ONE), (minus(w[a]), rate)]);
            if with_accelerations {
                let own = self.input(2 * n + i);
                turning[k] = self.code.add(turning[k], own);
            }
            w[k] = self.code.add(w[k], rate);
            field = self.field(w, turning);
            wrenches.push(self.wrench(i, field, acceleration));
        }
        wrenches
    }

    /// [α ×] + [ω ×]².
    fn field(&mut self, w: Vector, turning: Vector) -> Block {
        let code = &mut self.code;
        let squares = w.map(|x| code.product(x, x));
        let mut field = [NONE; 3];
        for k in 0..3 {
            let [i, j] = others(k);
            field[k][k] = minus(code.add(squares[i], squares[j]));
            let product = code.product(w[i], w[j]);
            field[j][i] = code.add(product, turning[k]);
            field[i][j] = code.subtract(product, turning[k]);
        }
        field
    }

    fn wrench(&mut self, i: usize, field: Block, acceleration: Vector) -> Wrench {
        let first = self.links[i].first.map(Value::Constant);
        let second = self.links[i].second.map(|row| row.map(Value::Constant));
        let code = &mut self.code;
        let force = field
            .map(|row| code.sum(&[(row[0], first[0]), (row[1], first[1]), (row[2], first[2])]));
        let moment = [0, 1, 2].map(|k: usize| {
            let [i, j] = others(k);
            let stretch = code.subtract(field[j][j], field[i][i]);
            code.sum(&[
                (second[i][j], stretch),
                (second[k][i], field[j][k]),
                (minus(second[k][j]), field[i][k]),
                (second[i][i], field[j][i]),
                (minus(second[j][j]), field[i][j]),
                (first[i], acceleration[j]),
                (minus(first[j]), acceleration[i]),
            ])
        });
        Wrench { moment, force }
    }

    fn plus(&mut self, x: Wrench, y: Wrench) -> Wrench {
        Wrench {
            moment: self.code.plus(x.moment, y.moment),
            force: self.code.plus(x.force, y.force),
        }
    }

    fn inverse_dynamics(&mut self) {
        let mut wrenches = self.wrenches(true);
        for i in (0..wrenches.len()).rev() {
            self.code.output(i, wrenches[i].moment[axis(i)]);
            if i > 0 {
                let carried = self.carried(i, wrenches[i]);
                wrenches[i - 1] = self.plus(wrenches[i - 1], carried);
            }
        }
    }
}
