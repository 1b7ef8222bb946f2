//! The order conditions of Runge–Kutta methods.
//!
//! There is one condition for each rooted tree τ with at most p vertices: Σ bᵢ Φᵢ(τ) = 1/γ(τ). Hairer, Nørsett &
//! Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.2, theorem 2.13. There are 1, 1, 2, 4,
//! 9, 20, 48, 115 trees with 1 to 8 vertices.

use std::vec::Vec;

use crate::integrate::runge_kutta::CLASSICAL_FOURTH_ORDER;

/// A rooted tree: the subtrees at its root, by their indices in a list of all trees.
struct Tree {
    children: Vec<usize>,
    order: usize,
}

/// Returns all rooted trees with at most `order` vertices, each once, after its children.
fn trees(order: usize) -> Vec<Tree> {
    let mut trees: Vec<Tree> = Vec::new();
    for vertices in 1..=order {
        let mut forests = Vec::new();
        forests_of(&trees, vertices - 1, 0, &mut Vec::new(), &mut forests);
        trees.extend(forests.into_iter().map(|children| Tree {
            children,
            order: vertices,
        }));
    }
    trees
}

/// Collects all multisets of trees with `vertices` vertices in total, in ascending order from `least`.
fn forests_of(
    trees: &[Tree],
    vertices: usize,
    least: usize,
    begun: &mut Vec<usize>,
    forests: &mut Vec<Vec<usize>>,
) {
    if vertices == 0 {
        forests.push(begun.clone());
    }
    for (i, tree) in trees.iter().enumerate().skip(least) {
        if tree.order <= vertices {
            begun.push(i);
            forests_of(trees, vertices - tree.order, i, begun, forests);
            begun.pop();
        }
    }
}

#[allow(clippy::cast_precision_loss)] // At most 8.
fn density(trees: &[Tree], tree: &Tree) -> f64 {
    let children = tree.children.iter().map(|&i| density(trees, &trees[i]));
    tree.order as f64 * children.product::<f64>()
}

/// Returns the largest |Σ bᵢ Φᵢ(τ) − θ^|τ|/γ(τ)| over the trees with exactly `order` vertices. Within a step, at the
/// fraction θ, the weights bᵢ are the weights of the dense output.
pub(crate) fn residual(matrix: &[&[f64]], weights: &[f64], theta: f64, order: usize) -> f64 {
    let trees = trees(order);
    let mut elementary: Vec<Vec<f64>> = Vec::new();
    let mut worst: f64 = 0.0;
    for tree in &trees {
        let row_sum = |row: &&[f64], child: usize| -> f64 {
            row.iter().zip(&elementary[child]).map(|(a, x)| a * x).sum()
        };
        let at_stage = |row| tree.children.iter().map(|&c| row_sum(row, c)).product();
        let stages: Vec<f64> = matrix.iter().map(at_stage).collect();
        if tree.order == order {
            let sum: f64 = weights.iter().zip(&stages).map(|(b, x)| b * x).sum();
            let exact = theta.powi(i32::try_from(order).unwrap()) / density(&trees, tree);
            worst = worst.max((sum - exact).abs());
        }
        elementary.push(stages);
    }
    worst
}

#[test]
fn trees_are_counted_as_in_the_literature() {
    let trees = trees(8);
    let counts: Vec<usize> = (1..=8)
        .map(|n| trees.iter().filter(|tree| tree.order == n).count())
        .collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn classical_runge_kutta_fulfils_the_conditions_of_order_four() {
    let method = CLASSICAL_FOURTH_ORDER;
    for order in 1..=4 {
        assert!(residual(&method.matrix, &method.weights, 1.0, order) < 2.0 * f64::EPSILON);
    }
    assert!(residual(&method.matrix, &method.weights, 1.0, 5) > 1e-3);
}

#[test]
fn nodes_are_row_sums() {
    let method = CLASSICAL_FOURTH_ORDER;
    for (node, row) in method.nodes.iter().zip(method.matrix) {
        assert!((node - row.iter().sum::<f64>()).abs() < f64::EPSILON);
    }
}
