/* Computes the state matrix of the first-order system, and the derivatives of the accelerations by the time, unless these are NULL. */
static void $_state_matrix_at(const $_point *at, double *state_matrix, double *time_derivative)
{
    double position[@N * @N], velocity[@N * @N], time[@N];
    int i, j;
    if (!state_matrix && !time_derivative) {
        return;
    }
    $_linearize_at(at, position, velocity, time);
    for (i = 0; i < @N; ++i) {
        for (j = 0; state_matrix && j < @N; ++j) {
            double *const upper = state_matrix, *const lower = state_matrix + 2 * @N * @N;
            upper[i * 2 * @N + j] = 0.0;
            upper[i * 2 * @N + @N + j] = i == j ? 1.0 : 0.0;
            lower[i * 2 * @N + j] = position[i * @N + j];
            lower[i * 2 * @N + @N + j] = velocity[i * @N + j];
        }
        if (time_derivative) {
            time_derivative[i] = time[i];
        }
    }
}
