/* Adds an increment and then a correction to x as a compensated sum (W. Kahan, Comm. ACM 8, 1965, 40). */
static void $_add_corrected(double *x, double increment, double corrected)
{
    const double sum = *x + increment;
    const double lost = increment - (sum - *x);
    *x = sum + ((corrected - sum) + lost);
}

/* Adds increments to coordinates and velocities, and projects them onto the constraints. */
static void $_end_step(const $_point *at, double h, double *q, double *v, const double *of_q, const double *of_v)
{
    double projected_q[@N], projected_v[@N];
    $_point end = *at;
    int i;
    end.t = at->t + h;
    for (i = 0; i < @N; ++i) {
        projected_q[i] = q[i] + of_q[i];
        projected_v[i] = v[i] + of_v[i];
    }
    $_project_at(&end, projected_q, projected_v);
    for (i = 0; i < @N; ++i) {
        $_add_corrected(q + i, of_q[i], projected_q[i]);
        $_add_corrected(v + i, of_v[i], projected_v[i]);
    }
}
