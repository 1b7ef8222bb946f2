/* The factors of a symmetric matrix with n rows: L D L', or with pivoting P M = L U. Matrices are stored row by row. */
typedef struct {
    double entries[@K * @K];
    double reciprocals[@K];
    int interchanges[@K];
    int is_pivoted;
} $_elimination;

/* Factors a matrix, whose lower triangle alone is read, as L D L'. Returns whether the first pivots, of this number, are positive,
   the others negative, and none of them less than a part of the diagonal entry. */
static int $_factor_ldlt(const double *matrix, int n, int positive, double least, $_elimination *f)
{
    int i, j, k, is_stable = 1;
    f->is_pivoted = 0;
    for (j = 0; j < n; ++j) {
        double pivot = matrix[j * n + j], diagonal = pivot;
        for (k = 0; k < j; ++k) {
            /* The columns to the left hold L D until the row is scaled here. */
            const double scaled = f->entries[j * n + k];
            const double unscaled = scaled * f->reciprocals[k];
            f->entries[j * n + k] = unscaled;
            pivot -= unscaled * scaled;
            if (k + 1 == positive) {
                diagonal = pivot;
            }
        }
        for (i = j + 1; i < n; ++i) {
            double entry = matrix[i * n + j];
            for (k = 0; k < j; ++k) {
                entry -= f->entries[i * n + k] * f->entries[j * n + k];
            }
            f->entries[i * n + j] = entry;
        }
        f->reciprocals[j] = 1.0 / pivot;
        is_stable = is_stable && (j < positive ? pivot : -pivot) > 0.0;
        is_stable = is_stable && (least <= 0.0 || pivot / diagonal > least);
    }
    return is_stable;
}

/* Factors a symmetric matrix, whose lower triangle alone is read, with scaled partial pivoting (Golub and Van Loan, Matrix
   Computations, 4th edition, 2013, 3.4). Rows are compared as the matrix is equilibrated (D. Ruiz, RAL-TR-2001-034, 2001). */
static void $_factor_lu(const double *matrix, int n, $_elimination *f)
{
    double scales[@K], largest[@K];
    int i, j, k, sweep;
    f->is_pivoted = 1;
    for (i = 0; i < n; ++i) {
        scales[i] = 1.0;
        for (j = 0; j < n; ++j) {
            f->entries[i * n + j] = i > j ? matrix[i * n + j] : matrix[j * n + i];
        }
    }
    for (sweep = 0; sweep < 6; ++sweep) {
        for (i = 0; i < n; ++i) {
            double most = 0.0;
            for (j = 0; j < n; ++j) {
                most = fmax(most, fabs(f->entries[i * n + j] * scales[j]));
            }
            largest[i] = most;
        }
        for (i = 0; i < n; ++i) {
            const double size = largest[i] * scales[i];
            scales[i] /= size == 0.0 ? 1.0 : sqrt(size);
        }
    }
    for (j = 0; j < n; ++j) {
        int row = j;
        double most = fabs(f->entries[j * n + j]) * scales[j], pivot, reciprocal;
        for (i = j + 1; i < n; ++i) {
            const double weight = fabs(f->entries[i * n + j]) * scales[i];
            if (weight > most) {
                row = i;
            }
            most = fmax(most, weight);
        }
        f->interchanges[j] = row;
        if (row != j) {
            const double scale = scales[j];
            scales[j] = scales[row];
            scales[row] = scale;
            for (k = 0; k < n; ++k) {
                const double entry = f->entries[j * n + k];
                f->entries[j * n + k] = f->entries[row * n + k];
                f->entries[row * n + k] = entry;
            }
        }
        pivot = f->entries[j * n + j];
        f->reciprocals[j] = 1.0 / pivot;
        reciprocal = pivot == 0.0 ? 1.0 : 1.0 / pivot;
        for (i = j + 1; i < n; ++i) {
            const double multiplier = f->entries[i * n + j] * reciprocal;
            f->entries[i * n + j] = multiplier;
            for (k = j + 1; k < n; ++k) {
                f->entries[i * n + k] -= multiplier * f->entries[j * n + k];
            }
        }
    }
}

/* Solves for one right-hand side, which is overwritten. Without pivoting its first rows are known to be zero, of this number. */
static void $_substitute(const $_elimination *f, int n, int zeros, double *x)
{
    int i, k;
    if (f->is_pivoted) {
        for (i = 0; i < n; ++i) {
            const int row = f->interchanges[i];
            const double entry = x[i];
            x[i] = x[row];
            x[row] = entry;
        }
        for (i = 0; i < n; ++i) {
            for (k = 0; k < i; ++k) {
                x[i] -= f->entries[i * n + k] * x[k];
            }
        }
        for (i = n - 1; i >= 0; --i) {
            for (k = i + 1; k < n; ++k) {
                x[i] -= f->entries[i * n + k] * x[k];
            }
            x[i] *= f->reciprocals[i];
        }
        return;
    }
    for (i = zeros; i < n; ++i) {
        for (k = zeros; k < i; ++k) {
            x[i] = $_mul_add(-f->entries[i * n + k], x[k], x[i]);
        }
    }
    for (i = n - 1; i >= 0; --i) {
        x[i] *= f->reciprocals[i];
        for (k = i + 1; k < n; ++k) {
            x[i] = $_mul_add(-f->entries[k * n + i], x[k], x[i]);
        }
    }
}
