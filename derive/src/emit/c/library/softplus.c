/* Returns ln(1 + exp(x)). */
static double $_softplus(double x)
{
    return fmax(x, 0.0) + log1p(exp(-fabs(x)));
}
