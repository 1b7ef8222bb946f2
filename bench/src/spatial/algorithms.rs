//! The recursions of textbooks for the arm, as straight-line C: inverse dynamics by Newton and Euler (Luh, Walker and Paul, On-line
//! computational scheme for mechanical manipulators, 1980), accelerations by composite bodies (Walker and Orin, Efficient
//! dynamic computer simulation of robotic mechanisms, 1982) with `LDLᵀ`, and by articulated bodies (Featherstone, The
//! calculation of robot dynamics using articulated-body inertias, 1983). All act on what moves along the axes of the
//! links, with accelerations of origins and with base inertial parameters.

#![allow(clippy::needless_range_loop)] // Indices are those of the formulas.

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

    fn composite_bodies(&mut self) {
        let n = self.links.len();
        let mut wrenches = self.wrenches(false);
        let mut mass = vec![vec![ZERO; n]; n];
        let mut force = vec![ZERO; n];
        let mut columns: Vec<Wrench> = Vec::new();
        let (mut first, mut second) = (NONE, [NONE; 3]);
        for i in (0..n).rev() {
            let k = axis(i);
            let [a, b] = others(k);
            let own = self.links[i].first.map(Value::Constant);
            first = self.code.plus(first, own);
            for x in 0..3 {
                for y in x..3 {
                    let own = Value::Constant(self.links[i].second[x][y]);
                    second[x][y] = self.code.add(second[x][y], own);
                    second[y][x] = second[x][y];
                }
            }
            let mut column = Wrench {
                moment: NONE,
                force: NONE,
            };
            column.moment[k] = self.code.add(second[a][a], second[b][b]);
            column.moment[a] = minus(second[a][k]);
            column.moment[b] = minus(second[b][k]);
            column.force[a] = minus(first[b]);
            column.force[b] = first[a];
            columns.insert(0, column);
            for (j, column) in columns.iter().enumerate() {
                mass[i + j][i] = column.moment[k];
            }
            force[i] = wrenches[i].moment[k];
            if i == 0 {
                break;
            }
            let carried = self.carried(i, wrenches[i]);
            wrenches[i - 1] = self.plus(wrenches[i - 1], carried);
            for column in &mut columns {
                *column = self.carried(i, *column);
            }
            first = self.outward(i, first);
            second = self.turned_symmetric(i, second);
            let place = self.place(i);
            for x in 0..3 {
                for y in x..3 {
                    let terms = [
                        (second[x][y], ONE),
                        (first[x], place[y]),
                        (place[x], first[y]),
                    ];
                    second[x][y] = self.code.sum(&terms);
                    second[y][x] = second[x][y];
                }
            }
        }
        self.solve(mass, force);
    }

    /// M q̈ = −force by `LDLᵀ`.
    fn solve(&mut self, mut mass: Vec<Vec<Value>>, mut force: Vec<Value>) {
        let n = force.len();
        let code = &mut self.code;
        let mut reciprocals = vec![ZERO; n];
        // From the last row, as the links are.
        for k in (0..n).rev() {
            reciprocals[k] = code.reciprocal(mass[k][k]);
            for i in (0..k).rev() {
                let ratio = code.product(mass[k][i], reciprocals[k]);
                for j in 0..=i {
                    mass[i][j] = code.sum(&[(mass[i][j], ONE), (minus(ratio), mass[k][j])]);
                }
                force[i] = code.sum(&[(force[i], ONE), (minus(ratio), force[k])]);
            }
        }
        let mut found = Vec::new();
        for k in 0..n {
            let mut terms = vec![(minus(force[k]), ONE)];
            for (i, x) in found.iter().enumerate() {
                terms.push((minus(mass[k][i]), *x));
            }
            let sum = code.sum(&terms);
            let value = code.product(sum, reciprocals[k]);
            code.output(k, value);
            found.push(value);
        }
    }

    fn articulated_bodies(&mut self) {
        let n = self.links.len();
        let mut wrenches = self.wrenches(false);
        let mut body = ArticulatedBody::none();
        let mut gains = Vec::new();
        for i in (0..n).rev() {
            body.add(&mut self.code, &self.links[i]);
            let gain = self.eliminate(i, &mut body, &mut wrenches[i]);
            gains.push(gain);
            if i == 0 {
                break;
            }
            let carried = self.carried(i, wrenches[i]);
            wrenches[i - 1] = self.plus(wrenches[i - 1], carried);
            body = self.articulated(i, &body);
        }
        let (mut turning, mut acceleration) = (NONE, NONE);
        for (i, gain) in gains.into_iter().rev().enumerate() {
            let place = self.place(i);
            acceleration = self.code.plus_cross(acceleration, turning, place);
            turning = self.inward(i, turning);
            acceleration = self.inward(i, acceleration);
            let [a, b] = others(axis(i));
            let total = self.code.sum(&[
                (gain.force, ONE),
                (minus(gain.moment[a]), turning[a]),
                (minus(gain.moment[b]), turning[b]),
                (minus(gain.linear[0]), acceleration[0]),
                (minus(gain.linear[1]), acceleration[1]),
                (minus(gain.linear[2]), acceleration[2]),
            ]);
            let own = self.code.subtract(total, turning[axis(i)]);
            self.code.output(i, own);
            turning[axis(i)] = total;
        }
    }

    /// Takes out the coordinate of a joint.
    fn eliminate(&mut self, i: usize, body: &mut ArticulatedBody, wrench: &mut Wrench) -> Gain {
        let k = axis(i);
        let [a, b] = others(k);
        let code = &mut self.code;
        let reciprocal = code.reciprocal(body.angular[k][k]);
        let (moment, linear) = (body.angular[k], body.mixed[k]);
        let gain = Gain {
            moment: moment.map(|x| code.product(x, reciprocal)),
            linear: linear.map(|x| code.product(x, reciprocal)),
            force: minus(code.product(wrench.moment[k], reciprocal)),
        };
        if i == 0 {
            return gain;
        }
        for x in [a, b] {
            for y in [a, b] {
                if y == a && x == b {
                    body.angular[b][a] = body.angular[a][b];
                    continue;
                }
                let terms = [
                    (body.angular[x][y], ONE),
                    (minus(gain.moment[x]), moment[y]),
                ];
                body.angular[x][y] = code.sum(&terms);
            }
            for y in 0..3 {
                let terms = [(body.mixed[x][y], ONE), (minus(gain.moment[x]), linear[y])];
                body.mixed[x][y] = code.sum(&terms);
            }
            let terms = [(wrench.moment[x], ONE), (gain.force, moment[x])];
            wrench.moment[x] = code.sum(&terms);
        }
        for x in 0..3 {
            for y in x..3 {
                let terms = [(body.linear[x][y], ONE), (minus(gain.linear[x]), linear[y])];
                body.linear[x][y] = code.sum(&terms);
                body.linear[y][x] = body.linear[x][y];
            }
            let terms = [(wrench.force[x], ONE), (gain.force, linear[x])];
            wrench.force[x] = code.sum(&terms);
        }
        // The coordinate takes all moment about its axis: nothing is left of it.
        wrench.moment[k] = ZERO;
        for x in 0..3 {
            (body.angular[k][x], body.angular[x][k]) = (ZERO, ZERO);
            body.mixed[k][x] = ZERO;
        }
        gain
    }

    /// Along the axes and about the origin of the link before.
    fn articulated(&mut self, i: usize, body: &ArticulatedBody) -> ArticulatedBody {
        let angular = self.turned_symmetric(i, body.angular);
        let linear = self.turned_symmetric(i, body.linear);
        let mixed = self.turned(i, body.mixed);
        let place = self.place(i);
        let code = &mut self.code;
        let columns = [0, 1, 2].map(|y| {
            let column = [mixed[0][y], mixed[1][y], mixed[2][y]];
            code.plus_cross(column, place, linear[y])
        });
        let moved = [0, 1, 2].map(|x| [columns[0][x], columns[1][x], columns[2][x]]);
        // I + [p ×] Hᵀ-terms, from both sides.
        let mut sum = angular;
        for x in 0..3 {
            for y in x..3 {
                let [i, j] = others(x);
                let [k, l] = others(y);
                let terms = [
                    (angular[x][y], ONE),
                    (place[i], mixed[y][j]),
                    (minus(place[j]), mixed[y][i]),
                    (place[k], moved[x][l]),
                    (minus(place[l]), moved[x][k]),
                ];
                sum[x][y] = code.sum(&terms);
                sum[y][x] = sum[x][y];
            }
        }
        ArticulatedBody {
            angular: sum,
            mixed: moved,
            linear,
        }
    }

    /// R B Rᵀ.
    fn turned(&mut self, i: usize, block: Block) -> Block {
        let [c, s] = self.turns[i];
        let k = axis(i);
        let [a, b] = others(k);
        let column = self.outward(i, [block[0][k], block[1][k], block[2][k]]);
        let row = self.outward(i, block[k]);
        let code = &mut self.code;
        let square = code.product(c, c);
        let product = code.product(c, s);
        let difference = code.subtract(block[a][a], block[b][b]);
        let sum = code.add(block[a][b], block[b][a]);
        let change = code.sum(&[(square, difference), (minus(product), sum)]);
        let across = code.sum(&[(product, difference), (square, sum)]);
        let mut turned = block;
        turned[a][a] = code.add(block[b][b], change);
        turned[b][b] = code.subtract(block[a][a], change);
        turned[a][b] = code.subtract(across, block[b][a]);
        turned[b][a] = code.subtract(across, block[a][b]);
        for x in [a, b] {
            turned[x][k] = column[x];
            turned[k][x] = row[x];
        }
        turned
    }
}

/// How the acceleration of a coordinate follows from that of the link before.
struct Gain {
    moment: Vector,
    linear: Vector,
    force: Value,
}

/// An articulated-body inertia: of angular and linear acceleration.
struct ArticulatedBody {
    angular: Block,
    mixed: Block,
    linear: Block,
}

impl ArticulatedBody {
    const fn none() -> Self {
        Self {
            angular: [NONE; 3],
            mixed: [NONE; 3],
            linear: [NONE; 3],
        }
    }

    fn add(&mut self, code: &mut Code, link: &Link) {
        for k in 0..3 {
            let [i, j] = others(k);
            let diagonal = Value::Constant(link.second[i][i] + link.second[j][j]);
            self.angular[k][k] = code.add(self.angular[k][k], diagonal);
            let across = Value::Constant(-link.second[i][j]);
            self.angular[i][j] = code.add(self.angular[i][j], across);
            self.angular[j][i] = self.angular[i][j];
            let first = Value::Constant(link.first[k]);
            self.mixed[j][i] = code.add(self.mixed[j][i], first);
            self.mixed[i][j] = code.subtract(self.mixed[i][j], first);
        }
    }
}
