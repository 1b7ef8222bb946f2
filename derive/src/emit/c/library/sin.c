/* Returns the sine of an angle. */
static double $_sin(double x)
{
    double sine, cosine;
    $_sin_cos(x, &sine, &cosine);
    return sine;
}
