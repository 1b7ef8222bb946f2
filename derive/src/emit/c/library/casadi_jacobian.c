
$_EXPORT casadi_int jac_$_dynamics_n_in(void) { return 5; }
$_EXPORT casadi_int jac_$_dynamics_n_out(void) { return 4; }
$_EXPORT const char *jac_$_dynamics_name_in(casadi_int i) { return i == 4 ? "out_dx" : $_argument(i); }
$_EXPORT const char *jac_$_dynamics_name_out(casadi_int i)
{
    static const char *const names[4] = {"jac_dx_t", "jac_dx_x", "jac_dx_u", "jac_dx_p"};
    return i >= 0 && i < 4 ? names[i] : NULL;
}
$_EXPORT const casadi_int *jac_$_dynamics_sparsity_in(casadi_int i) { return $_sparsity(i == 4 ? 1 : i); }
$_EXPORT const casadi_int *jac_$_dynamics_sparsity_out(casadi_int i)
{
    static const casadi_int by_time[3] = {2 * @N, 1, 1}, by_state[3] = {2 * @N, 2 * @N, 1};
    static const casadi_int by_inputs[3] = {2 * @N, @M, 1}, by_parameters[3] = {2 * @N, @Q, 1};
    static const casadi_int none[3] = {2 * @N, 0, 0};
    switch (i) {
    case 0: return by_time;
    case 1: return by_state;
    case 2: return @M > 0 ? by_inputs : none;
    case 3: return @Q > 0 ? by_parameters : none;
    default: return NULL;
    }
}
$_EXPORT int jac_$_dynamics_work(casadi_int *arg, casadi_int *res, casadi_int *iw, casadi_int *w)
{
    return $_sizes(arg, res, iw, w);
}

$_EXPORT int jac_$_dynamics(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)
{
    double a[4 * @N * @N], b[2 * @N * @M + 1] = {0.0}, by_time[2 * @N] = {0.0};
    $_arguments at;
    (void)iw;
    (void)w;
    (void)mem;
    $_read(&at, arg);
    if (res[0] || res[1] || res[2]) {
        $_linearize(@POINT, a, @INPUTSby_time + @N);
        $_by_columns(res[0], by_time, 2 * @N, 1);
        $_by_columns(res[1], a, 2 * @N, 2 * @N);
        $_by_columns(res[2], b, 2 * @N, @M);
    }
    if (res[3]) {
        $_by_parameters(at, res[3]);
    }
    return 0;
}
