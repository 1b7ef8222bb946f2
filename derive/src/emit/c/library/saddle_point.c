/* The factors of the matrix of the saddle point problem for accelerations x and multipliers l, M x - G' l = f, -G x = c. */
typedef struct {
    $_elimination elimination;
    /* -G, row by row. */
    double constraints[@C * @N];
    /* With pivoting: 1 for a constraint that depends on others, 0 for the others. */
    double dependent[@C];
    /* The gradients of dependent constraints as combinations of those of independent ones. */
    double combinations[@C * @C];
    /* The weights of the squares of multipliers. */
    double compliances[@C];
    int is_redundant;
} $_factors;

static double $_length(const double *x)
{
    double sum = 0.0;
    int i;
    for (i = 0; i < @N; ++i) {
        sum += x[i] * x[i];
    }
    return sum == 0.0 ? 0.0 : sqrt(sum);
}

/* Chooses independent constraints by Gram-Schmidt orthogonalization with row pivoting, in the metric of the diagonal of the mass
   matrix (A. Bjorck, Numerical Methods for Least Squares Problems, 1996, 2.4 and 2.7). */
static void $_choose_constraints(const double *diagonal, $_factors *f)
{
    double rows[@C * @N], scales[@C], coefficients[@C * @C], triangle[@C * @C], parts[@C];
    int chosen[@C], used[@C];
    int i, j, k, step;
    for (j = 0; j < @N; ++j) {
        double width = 0.0;
        if (diagonal[j] > 0.0) {
            width = sqrt(diagonal[j]);
        } else {
            for (i = 0; i < @C; ++i) {
                width = fmax(width, fabs(f->constraints[i * @N + j]));
            }
            width = width == 0.0 ? 1.0 : width;
        }
        for (i = 0; i < @C; ++i) {
            rows[i * @N + j] = -f->constraints[i * @N + j] / width;
        }
    }
    for (i = 0; i < @C; ++i) {
        const double length = $_length(rows + i * @N);
        scales[i] = 1.0 / (length == 0.0 ? 1.0 : length);
        used[i] = 0;
        for (j = 0; j < @N; ++j) {
            rows[i * @N + j] *= scales[i];
        }
    }
    for (step = 0; step < @C; ++step) {
        double longest = -1.0, scale, direction[@N];
        int best = 0, is_new;
        for (i = 0; i < @C; ++i) {
            const double length = used[i] ? -1.0 : $_length(rows + i * @N);
            if (length > longest) {
                best = i;
            }
            longest = fmax(longest, length);
        }
        is_new = longest > 1e-10;
        scale = 1.0 / (longest == 0.0 ? 1.0 : longest);
        chosen[step] = is_new ? best : -1;
        if (is_new) {
            used[best] = 1;
        }
        for (j = 0; j < @N; ++j) {
            direction[j] = is_new ? rows[best * @N + j] * scale : 0.0;
        }
        for (i = 0; i < @C; ++i) {
            double part = 0.0;
            if (!used[i] || (is_new && i == best)) {
                for (j = 0; j < @N; ++j) {
                    part += rows[i * @N + j] * direction[j];
                }
            }
            coefficients[i * @C + step] = part;
            for (j = 0; j < @N; ++j) {
                rows[i * @N + j] -= part * direction[j];
            }
        }
    }
    f->is_redundant = 0;
    for (i = 0; i < @C; ++i) {
        f->dependent[i] = used[i] ? 0.0 : 1.0;
        f->is_redundant = f->is_redundant || !used[i];
    }
    for (step = 0; step < @C; ++step) {
        for (k = 0; k < @C; ++k) {
            triangle[step * @C + k] = chosen[step] < 0 ? 0.0 : coefficients[chosen[step] * @C + k];
        }
    }
    for (i = 0; i < @C; ++i) {
        for (k = @C - 1; k >= 0; --k) {
            const double pivot = triangle[k * @C + k];
            double later = 0.0;
            for (j = k + 1; j < @C; ++j) {
                later += parts[j] * triangle[j * @C + k];
            }
            parts[k] = (coefficients[i * @C + k] - later) / (pivot == 0.0 ? 1.0 : pivot);
        }
        for (j = 0; j < @C; ++j) {
            double part = 0.0;
            for (step = 0; step < @C; ++step) {
                if (chosen[step] == j) {
                    part += parts[step];
                }
            }
            f->combinations[i * @C + j] = used[i] ? 0.0 : part * scales[j] / scales[i];
        }
    }
}

/* Factors the matrix, whose lower triangle alone is read, with compliances that weigh the multipliers where constraints depend on
   each other; without any, they are equal. */
static void $_factor(const double *lower, const double *compliances, $_factors *f)
{
    double independent[@K * @K], diagonal[@N];
    int i, j;
    for (j = 0; j < @C; ++j) {
        f->dependent[j] = 0.0;
        for (i = 0; i < @N; ++i) {
            f->constraints[j * @N + i] = lower[(@N + j) * @K + i];
        }
    }
    if ($_factor_ldlt(lower, @K, @N, 1e-2, &f->elimination)) {
        return;
    }
    for (i = 0; i < @N; ++i) {
        diagonal[i] = lower[i * @K + i];
    }
    $_choose_constraints(diagonal, f);
    memcpy(independent, lower, sizeof independent);
    for (j = 0; j < @C; ++j) {
        const double compliance = compliances ? compliances[j] : 1.0;
        f->compliances[j] = compliance / (compliance > 0.0 ? 1.0 : 0.0);
        for (i = 0; i < @N; ++i) {
            if (f->dependent[j] != 0.0) {
                independent[(@N + j) * @K + i] = 0.0;
            }
        }
        independent[(@N + j) * @K + @N + j] = -f->dependent[j];
    }
    $_factor_lu(independent, @K, &f->elimination);
}

/* Replaces multipliers, which are zero for dependent constraints, by those of least norm with the same reactions. */
static void $_least_norm(const $_factors *f, double *multipliers)
{
    const double *const x = f->combinations, *const c = f->compliances;
    double normal[@C * @C], of_dependent[@C];
    $_elimination elimination;
    int i, j, k;
    for (i = 0; i < @C; ++i) {
        double right = 0.0;
        for (j = 0; j < @C; ++j) {
            double sum = i == j ? c[i] : 0.0;
            for (k = 0; k < @C; ++k) {
                sum += x[i * @C + k] * c[k] * x[j * @C + k];
            }
            normal[i * @C + j] = sum;
        }
        for (k = 0; k < @C; ++k) {
            right += x[i * @C + k] * c[k] * multipliers[k];
        }
        of_dependent[i] = right;
    }
    if (!$_factor_ldlt(normal, @C, @C, 0.0, &elimination)) {
        $_factor_lu(normal, @C, &elimination);
    }
    $_substitute(&elimination, @C, 0, of_dependent);
    for (i = 0; i < @C; ++i) {
        double taken = 0.0;
        for (k = 0; k < @C; ++k) {
            taken += x[k * @C + i] * of_dependent[k];
        }
        multipliers[i] = multipliers[i] - taken + of_dependent[i];
    }
}

/* Solves for one right-hand side, which is overwritten; the multipliers of dependent constraints are zero. */
static void $_solve_independent(const $_factors *f, double *x)
{
    double residuals[@K] = {0.0};
    int i, j;
    if (f->elimination.is_pivoted) {
        for (j = 0; j < @C; ++j) {
            x[@N + j] = f->dependent[j] != 0.0 ? 0.0 : x[@N + j];
        }
        $_substitute(&f->elimination, @K, 0, x);
        return;
    }
    for (j = 0; j < @C; ++j) {
        residuals[@N + j] = x[@N + j];
    }
    $_substitute(&f->elimination, @K, 0, x);
    /* One step of iterative refinement by the residuals of the constraints. */
    for (j = 0; j < @C; ++j) {
        for (i = 0; i < @N; ++i) {
            residuals[@N + j] -= f->constraints[j * @N + i] * x[i];
        }
    }
    $_substitute(&f->elimination, @K, @N, residuals);
    for (i = 0; i < @K; ++i) {
        x[i] += residuals[i];
    }
}

/* Solves for one right-hand side, which is overwritten. */
static void $_solve(const $_factors *f, double *x)
{
    $_solve_independent(f, x);
    if (f->elimination.is_pivoted && f->is_redundant) {
        $_least_norm(f, x + @N);
    }
}
