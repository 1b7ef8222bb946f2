/* Returns x y + z, rounded once where the processor has the instruction. */
static double $_mul_add(double x, double y, double z)
{
#ifdef __FMA__
    return fma(x, y, z);
#else
    return x * y + z;
#endif
}
