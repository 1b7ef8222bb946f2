/* Returns ln cosh x. Near 0 it is computed from the square of the hyperbolic sine. */
static double $_log_cosh(double x)
{
    const double size = fabs(x);
    if (size < 0.5) {
        const double sine = sinh(size);
        return 0.5 * log1p(sine * sine);
    }
    return size + (log1p(exp(-(size + size))) - 0.6931471805599453);
}
