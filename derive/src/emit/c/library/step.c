/* Computes the increments of coordinates and velocities over one step of the classical method of Runge and Kutta of order 4. */
static void $_increments(const $_point *at, double h, double *of_q, double *of_v)
{
    static const double nodes[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double q[@N], v[@N], dq[@N] = {0.0}, dv[@N] = {0.0}, x[@K];
    $_point inner = *at;
    int i, stage;
    inner.q = q;
    inner.v = v;
    for (i = 0; i < @N; ++i) {
        of_q[i] = 0.0;
        of_v[i] = 0.0;
    }
    for (stage = 0; stage < 4; ++stage) {
        inner.t = at->t + nodes[stage] * h;
        for (i = 0; i < @N; ++i) {
            q[i] = $_mul_add($_mul_add(dq[i], nodes[stage], 0.0), h, at->q[i]);
            v[i] = $_mul_add($_mul_add(dv[i], nodes[stage], 0.0), h, at->v[i]);
        }
        $_accelerations_at(&inner, x);
        for (i = 0; i < @N; ++i) {
            dq[i] = v[i];
            dv[i] = x[i];
            of_q[i] = $_mul_add(dq[i], weights[stage], of_q[i]);
            of_v[i] = $_mul_add(dv[i], weights[stage], of_v[i]);
        }
    }
    for (i = 0; i < @N; ++i) {
        of_q[i] *= h;
        of_v[i] *= h;
    }
}
