/* Returns the power of two that takes the larger of two sizes to about 1. */
static double $_common_scale(double x, double y)
{
    const uint64_t infinite = 2047;
    uint64_t of_x, of_y, exponent;
    double scale;
    x = fabs(x);
    y = fabs(y);
    memcpy(&of_x, &x, sizeof of_x);
    memcpy(&of_y, &y, sizeof of_y);
    exponent = (of_x > of_y ? of_x : of_y) >> 52;
    exponent = exponent + 1 < infinite ? infinite - 1 - exponent : 1;
    exponent <<= 52;
    memcpy(&scale, &exponent, sizeof scale);
    return scale;
}
