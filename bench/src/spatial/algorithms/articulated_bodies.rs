//! Accelerations by articulated bodies.

use super::{Block, NONE, Program, Wrench, others};
use crate::spatial::arm::{Link, axis};
use crate::spatial::straight_line::{Code, ONE, Value, Vector, ZERO, minus};

impl Program {
    pub(super) fn articulated_bodies(&mut self) {
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
