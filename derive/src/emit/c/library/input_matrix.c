/* Computes the input matrix of the first-order system, unless it is NULL. */
static void $_input_matrix_at(const $_point *at, double *input_matrix)
{
    int i;
    if (!input_matrix) {
        return;
    }
    for (i = 0; i < @N * @M; ++i) {
        input_matrix[i] = 0.0;
    }
    $_input_jacobian_at(at, input_matrix + @N * @M);
}
