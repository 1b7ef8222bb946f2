
$_EXPORT casadi_int $_linear_model_n_in(void) { return 4; }
$_EXPORT casadi_int $_linear_model_n_out(void) { return 2; }
$_EXPORT const char *$_linear_model_name_in(casadi_int i) { return $_argument(i); }
$_EXPORT const char *$_linear_model_name_out(casadi_int i) { return i == 0 ? "A" : i == 1 ? "B" : NULL; }
$_EXPORT const casadi_int *$_linear_model_sparsity_in(casadi_int i) { return $_sparsity(i); }
$_EXPORT const casadi_int *$_linear_model_sparsity_out(casadi_int i)
{
    static const casadi_int of_state[3] = {2 * @N, 2 * @N, 1};
    static const casadi_int of_inputs[3] = {2 * @N, @M, 1}, none[3] = {2 * @N, 0, 0};
    return i == 0 ? of_state : i == 1 ? (@M > 0 ? of_inputs : none) : NULL;
}
$_EXPORT int $_linear_model_work(casadi_int *arg, casadi_int *res, casadi_int *iw, casadi_int *w)
{
    return $_sizes(arg, res, iw, w);
}

$_EXPORT int $_linear_model(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)
{
    double a[4 * @N * @N], b[2 * @N * @M + 1] = {0.0};
    $_arguments at;
    (void)iw;
    (void)w;
    (void)mem;
    $_read(&at, arg);
    $_linearize(@POINT, a, @INPUTSNULL);
    $_by_columns(res[0], a, 2 * @N, 2 * @N);
    $_by_columns(res[1], b, 2 * @N, @M);
    return 0;
}
