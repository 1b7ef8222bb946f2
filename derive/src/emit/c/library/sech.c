/* Returns the hyperbolic secant. */
static double $_sech(double x)
{
    return 1.0 / cosh(x);
}
