/*
 * The model $ as external functions of CasADi: compiled with $.c to a shared library,
 *
 *     cc -std=c99 -O2 -ffp-contract=off -fPIC -shared -o $.so $.c $_casadi.c -lm
 *
 * it is read by casadi.external("$_dynamics", "./$.so"). The functions take the time t, the state x = (q, v), the inputs u and the
 * parameters p, the numbers of their struct in order. $_dynamics returns dx = (v, a), and jac_$_dynamics its derivatives, which CasADi
 * finds by its name; $_linear_model returns A = d(dx)/dx and B = d(dx)/du.
 */
#include "$.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#ifndef casadi_real
#define casadi_real double
#endif
#ifndef casadi_int
#define casadi_int long long int
#endif
#if defined(_WIN32)
#define $_EXPORT __declspec(dllexport)
#else
#define $_EXPORT
#endif

/* The state, inputs and parameters of a call; those that are not given are zeros. */
typedef struct {
    double t, x[2 * @N], u[@M + 1], p[@Q + 1];
} $_arguments;

static void $_read($_arguments *to, const casadi_real **arg)
{
    double *const places[4] = {&to->t, to->x, to->u, to->p};
    static const size_t counts[4] = {1, 2 * @N, @M, @Q};
    int i;
    memset(to, 0, sizeof *to);
    for (i = 0; i < 4; ++i) {
        if (arg[i] && counts[i] > 0) {
            memcpy(places[i], arg[i], counts[i] * sizeof(double));
        }
    }
}

static const casadi_int *$_sparsity(casadi_int i)
{
    static const casadi_int one[3] = {1, 1, 1}, state[3] = {2 * @N, 1, 1};
    static const casadi_int none[4] = {0, 1, 0, 0}, inputs[3] = {@M, 1, 1}, parameters[3] = {@Q, 1, 1};
    switch (i) {
    case 0: return one;
    case 1: return state;
    case 2: return @M > 0 ? inputs : none;
    case 3: return @Q > 0 ? parameters : none;
    default: return NULL;
    }
}

static const char *$_argument(casadi_int i)
{
    static const char *const names[4] = {"t", "x", "u", "p"};
    return i >= 0 && i < 4 ? names[i] : NULL;
}

/* Writes a matrix, which is stored row by row, column by column, unless it is not asked for. */
static void $_by_columns(casadi_real *to, const double *from, int rows, int columns)
{
    int i, j;
    for (i = 0; to && i < rows; ++i) {
        for (j = 0; j < columns; ++j) {
            to[j * rows + i] = from[i * columns + j];
        }
    }
}

static int $_sizes(casadi_int *arg, casadi_int *res, casadi_int *iw, casadi_int *w)
{
    if (arg) *arg = 5;
    if (res) *res = 4;
    if (iw) *iw = 0;
    if (w) *w = 0;
    return 0;
}

$_EXPORT casadi_int $_dynamics_n_in(void) { return 4; }
$_EXPORT casadi_int $_dynamics_n_out(void) { return 1; }
$_EXPORT const char *$_dynamics_name_in(casadi_int i) { return $_argument(i); }
$_EXPORT const char *$_dynamics_name_out(casadi_int i) { return i == 0 ? "dx" : NULL; }
$_EXPORT const casadi_int *$_dynamics_sparsity_in(casadi_int i) { return $_sparsity(i); }
$_EXPORT const casadi_int *$_dynamics_sparsity_out(casadi_int i) { return i == 0 ? $_sparsity(1) : NULL; }
$_EXPORT int $_dynamics_work(casadi_int *arg, casadi_int *res, casadi_int *iw, casadi_int *w)
{
    return $_sizes(arg, res, iw, w);
}

$_EXPORT int $_dynamics(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)
{
    $_arguments at;
    (void)iw;
    (void)w;
    (void)mem;
    $_read(&at, arg);
    if (res[0]) {
        memcpy(res[0], at.x + @N, @N * sizeof(double));
        $_accelerations(@POINT, res[0] + @N@MULTIPLIERS);
    }
    return 0;
}
