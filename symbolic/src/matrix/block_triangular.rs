//! Symbolic solution of E x = a for a square matrix E in block-triangular form (Duff, Erisman and Reid, Direct
//! Methods for Sparse Matrices, 2nd edition 2017, chapter 6).
//!
//! Row and column singletons are removed one by one; the remainder falls into connected components, which are
//! solved by Cramer's rule. The determinants of these blocks are simplified first: for Euler angles the block is a
//! rotation up to a factor, and its determinant is −sin θ, with no digits lost where it is small.

use crate::limits::MAX_DIAGONAL_BLOCK;
use crate::matrix::components::components;
use crate::matrix::determinant::{determinant, sign, without};
use crate::{Expression, Graph, Rational};

/// A square matrix and its diagonal blocks in the order of solution.
#[derive(Clone, Debug)]
pub(crate) struct BlockTriangular {
    matrix: Vec<Vec<Expression>>,
    blocks: Vec<DiagonalBlock>,
}

/// Unknowns that are solved for together, from as many equations.
#[derive(Clone, Debug)]
struct DiagonalBlock {
    rows: Vec<usize>,
    columns: Vec<usize>,
    determinant: Expression,
}

impl BlockTriangular {
    /// The order of solution for `matrix`, unless it is not square or a block is too large or singular.
    pub(crate) fn new(graph: &mut Graph, matrix: Vec<Vec<Expression>>) -> Option<Self> {
        let size = matrix.len();
        if matrix.iter().any(|row| row.len() != size) {
            return None;
        }
        let occupied: Vec<Vec<bool>> = matrix
            .iter()
            .map(|row| row.iter().map(|x| !graph.is_zero(*x)).collect())
            .collect();
        let order = SingletonRemoval::new(&occupied).blocks();
        let mut blocks = Vec::with_capacity(order.len());
        for (rows, columns) in order {
            if rows.len() != columns.len() || rows.len() > MAX_DIAGONAL_BLOCK {
                return None;
            }
            let determinant = determinant(graph, &|i, j| matrix[i][j], &rows, &columns);
            let determinant = graph.simplest(determinant);
            if graph.is_zero(determinant) {
                return None;
            }
            blocks.push(DiagonalBlock {
                rows,
                columns,
                determinant,
            });
        }
        Some(Self { matrix, blocks })
    }

    /// The matrix E, row by row.
    pub(crate) fn matrix(&self) -> &[Vec<Expression>] {
        &self.matrix
    }

    /// The determinants of the diagonal blocks, each with its equations and its unknowns.
    pub(crate) fn determinants(&self) -> impl Iterator<Item = (Expression, &[usize], &[usize])> {
        let blocks = self.blocks.iter();
        blocks.map(|block| (block.determinant, &*block.rows, &*block.columns))
    }

    /// x in E x = a.
    pub(crate) fn solve(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let mut solution: Vec<Option<Expression>> = vec![None; right.len()];
        for block in &self.blocks {
            let mut rest = Vec::with_capacity(block.rows.len());
            for row in &block.rows {
                let mut terms = vec![(right[*row], Rational::ONE)];
                for (column, known) in solution.iter().enumerate() {
                    if let Some(known) = known {
                        let product = graph.multiply(self.matrix[*row][column], *known);
                        terms.push((product, Rational::MINUS_ONE));
                    }
                }
                rest.push(graph.sum(terms));
            }
            for (position, column) in block.columns.iter().enumerate() {
                let numerator = self.cramer(graph, block, position, &rest);
                solution[*column] = Some(graph.divide(numerator, block.determinant));
            }
        }
        solution
            .into_iter()
            .map(|x| x.unwrap_or(graph.zero()))
            .collect()
    }

    /// The determinant of a block with one column replaced, along that column.
    fn cramer(
        &self,
        graph: &mut Graph,
        block: &DiagonalBlock,
        position: usize,
        right: &[Expression],
    ) -> Expression {
        let columns = without(&block.columns, position);
        let mut terms = Vec::with_capacity(right.len());
        for (row, value) in right.iter().enumerate() {
            let rows = without(&block.rows, row);
            let minor = determinant(graph, &|i, j| self.matrix[i][j], &rows, &columns);
            terms.push((graph.multiply(minor, *value), sign(row + position)));
        }
        graph.sum(terms)
    }
}

/// The removal of row and column singletons.
struct SingletonRemoval<'a> {
    occupied: &'a [Vec<bool>],
    rows: Vec<usize>,
    columns: Vec<usize>,
}

type BlockIndices = (Vec<usize>, Vec<usize>);

impl<'a> SingletonRemoval<'a> {
    fn new(occupied: &'a [Vec<bool>]) -> Self {
        let all: Vec<usize> = (0..occupied.len()).collect();
        Self {
            occupied,
            rows: all.clone(),
            columns: all,
        }
    }

    /// The blocks in the order in which they can be solved.
    fn blocks(mut self) -> Vec<BlockIndices> {
        let (mut first, mut last) = (Vec::new(), Vec::new());
        loop {
            // An equation with one unknown is solved first; an unknown that occurs in one equation is solved last.
            if let Some((row, column)) = self.row_singleton() {
                self.take(row, column);
                first.push((vec![row], vec![column]));
            } else if let Some((row, column)) = self.column_singleton() {
                self.take(row, column);
                last.push((vec![row], vec![column]));
            } else {
                break;
            }
        }
        first.extend(self.components());
        first.extend(last.into_iter().rev());
        first
    }

    fn take(&mut self, row: usize, column: usize) {
        self.rows.retain(|x| *x != row);
        self.columns.retain(|x| *x != column);
    }

    fn row_singleton(&self) -> Option<(usize, usize)> {
        self.rows.iter().find_map(|row| {
            let mut unknowns = self
                .columns
                .iter()
                .filter(|column| self.occupied[*row][**column]);
            let column = unknowns.next()?;
            unknowns.next().is_none().then_some((*row, *column))
        })
    }

    fn column_singleton(&self) -> Option<(usize, usize)> {
        self.columns.iter().find_map(|column| {
            let mut equations = self.rows.iter().filter(|row| self.occupied[**row][*column]);
            let row = equations.next()?;
            equations.next().is_none().then_some((*row, *column))
        })
    }

    /// The connected components of the remaining equations and unknowns.
    fn components(&self) -> Vec<BlockIndices> {
        // Rows first, and columns behind them. A column without a row is a component that is not square, which the caller
        // rejects.
        let rows = self.rows.len();
        let found = components(rows + self.columns.len(), |i, j| {
            let (row, column) = (i.min(j), i.max(j));
            row < rows
                && column >= rows
                && self.occupied[self.rows[row]][self.columns[column - rows]]
        });
        let found = found.into_iter().map(|nodes| {
            let (first, others): (Vec<_>, Vec<_>) = nodes.into_iter().partition(|i| *i < rows);
            let columns = others.into_iter().map(|i| self.columns[i - rows]);
            let first = first.into_iter().map(|i| self.rows[i]);
            (first.collect(), columns.collect())
        });
        found.collect()
    }
}
