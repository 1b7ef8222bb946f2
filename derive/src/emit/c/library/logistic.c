/* Returns 1 / (1 + exp(-x)). */
static double $_logistic(double x)
{
    return 1.0 / (1.0 + exp(-x));
}
