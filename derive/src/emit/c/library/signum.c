/* Returns the sign of a number, which is 0 at 0. */
static double $_signum(double x)
{
    return x == 0.0 ? 0.0 : x != x ? x : copysign(1.0, x);
}
