/* Returns the cosine of an angle. */
static double $_cos(double x)
{
    double sine, cosine;
    $_sin_cos(x, &sine, &cosine);
    return cosine;
}
