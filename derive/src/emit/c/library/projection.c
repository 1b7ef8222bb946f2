/* Adds the smallest change in the metric of M that takes residuals away to first order. */
static void $_correct(const $_factors *factors, const double *residuals, double *x)
{
    double change[@K] = {0.0};
    int i;
    for (i = 0; i < @C; ++i) {
        change[@N + i] = residuals[i];
    }
    $_solve(factors, change);
    for (i = 0; i < @N; ++i) {
        x[i] += change[i];
    }
}

/* Projects coordinates by Newton's method with the factors at the state, then velocities with the constraints at the projected
   coordinates (E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration, 2nd edition, 2006, IV.4). */
static void $_project_at(const $_point *at, double *q, double *v)
{
    $_point projected = *at;
    $_factors factors;
    double residuals[@C];
    int sweep;
    projected.q = q;
    projected.v = v;
    $_factor_at(&projected, NULL, &factors);
    for (sweep = 0; sweep < @P; ++sweep) {
        $_constraint_positions_at(&projected, residuals);
        $_correct(&factors, residuals, q);
    }
    for (sweep = 0; sweep < 3; ++sweep) {
        $_constraint_velocities_at(&projected, residuals);
        $_correct(&factors, residuals, v);
    }
}
