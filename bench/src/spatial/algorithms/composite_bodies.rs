//! Accelerations by composite bodies and `LDLᵀ`.

use super::{NONE, Program, Wrench, others};
use crate::spatial::arm::axis;
use crate::spatial::straight_line::{ONE, Value, ZERO, minus};

impl Program {
    pub(super) fn composite_bodies(&mut self) {
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
}
