
/* Computes the derivatives of dx by the parameters, column by column; those by numbers of the struct that the model does not use are
   zero. */
static void $_by_parameters($_arguments at, casadi_real *columns)
{
    memset(columns, 0, 2 * @N * @Q * sizeof *columns);
    (void)at;
