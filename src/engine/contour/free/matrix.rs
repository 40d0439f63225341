//! The little of linear algebra that systems of open elements need: which unknowns linear equations determine, and the
//! step that brings equations nearer to zero.
//!
//! Invariant: numbers only.

/// Coefficients that are smaller, as a share of the greatest one of their row, are rounding.
const SINGULAR: f64 = 1e-6;

/// A matrix by rows.
#[derive(Clone, Debug)]
pub(super) struct Matrix {
    rows: Vec<Vec<f64>>,
    columns: usize,
}

impl Matrix {
    /// Of columns of the same length.
    pub(super) fn of_columns(columns: &[Vec<f64>]) -> Self {
        let height = columns.first().map_or(0, Vec::len);
        let row = |row: usize| columns.iter().map(|column| column.get(row).copied().unwrap_or(0.0)).collect();
        Self { rows: (0..height).map(row).collect(), columns: columns.len() }
    }

    pub(super) const fn rows(&self) -> usize {
        self.rows.len()
    }

    pub(super) fn row(&self, row: usize) -> &[f64] {
        self.rows.get(row).map_or(&[], Vec::as_slice)
    }
}

/// The rank of linear equations, and which unknowns they determine.
pub(super) fn determined_columns(matrix: Matrix) -> (usize, Vec<bool>) {
    let columns = matrix.columns;
    let mut rows = matrix.rows;
    for row in &mut rows {
        let size = row.iter().fold(0.0_f64, |size, own| size.max(own.abs()));
        if size > 0.0 {
            row.iter_mut().for_each(|own| *own /= size);
        }
    }
    let mut pivots: Vec<usize> = Vec::new();
    while pivots.len() < rows.len().min(columns) {
        let rank = pivots.len();
        let left = rows.iter().enumerate().skip(rank);
        let all = left.flat_map(|(at, row)| row.iter().enumerate().map(move |(column, own)| (at, column, own.abs())));
        let open = all.filter(|(_, column, _)| !pivots.contains(column));
        let Some((at, column, size)) = open.max_by(|a, b| a.2.total_cmp(&b.2)) else { break };
        if size < SINGULAR {
            break;
        }
        rows.swap(rank, at);
        let pivot = rows[rank][column];
        rows[rank].iter_mut().for_each(|own| *own /= pivot);
        let reduced = rows[rank].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != rank) {
            let factor = row[column];
            if factor != 0.0 {
                row.iter_mut().zip(&reduced).for_each(|(own, by)| *own -= factor * by);
                row[column] = 0.0;
            }
        }
        pivots.push(column);
    }
    let free: Vec<usize> = (0..columns).filter(|column| !pivots.contains(column)).collect();
    let mut determined = vec![false; columns];
    for (column, row) in pivots.iter().zip(&rows) {
        determined[*column] = free.iter().all(|free| row[*free].abs() < SINGULAR);
    }
    (pivots.len(), determined)
}

/// The `x` for which the squares of `matrix · x - value` are least, damped; nothing where it has no numbers.
pub(super) fn least_squares(matrix: &Matrix, value: &[f64], damping: f64) -> Option<Vec<f64>> {
    let n = matrix.columns;
    let mut square = vec![vec![0.0; n]; n];
    let mut right = vec![0.0; n];
    for (row, value) in matrix.rows.iter().zip(value) {
        for (i, own) in row.iter().enumerate().filter(|(_, own)| **own != 0.0) {
            right[i] += own * value;
            square[i].iter_mut().zip(&row[..=i]).for_each(|(sum, other)| *sum += own * other);
        }
    }
    for (i, row) in square.iter_mut().enumerate() {
        row[i] += damping * row[i].max(1e-6) + 1e-15;
    }
    // Cholesky: the lower triangle becomes its own root.
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = square[i][..j].iter().zip(&square[j][..j]).map(|(a, b)| a * b).sum();
            let own = square[i][j] - sum;
            square[i][j] = if i == j { libm::sqrt(own.max(1e-18)) } else { own / square[j][j] };
        }
    }
    for i in 0..n {
        let sum: f64 = square[i][..i].iter().zip(&right[..i]).map(|(a, b)| a * b).sum();
        right[i] = (right[i] - sum) / square[i][i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| square[k][i] * right[k]).sum();
        right[i] = (right[i] - sum) / square[i][i];
    }
    right.iter().all(|own| own.is_finite()).then_some(right)
}
