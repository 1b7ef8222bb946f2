/* Evaluates a polynomial with seven coefficients by Estrin's scheme. */
static double $_polynomial(const double *c, double z)
{
    const double low = $_mul_add(c[1], z, c[0]);
    const double middle = $_mul_add(c[3], z, c[2]);
    const double square = z * z;
    const double high = $_mul_add(square, c[6], $_mul_add(c[5], z, c[4]));
    return $_mul_add(square * square, high, $_mul_add(square, middle, low));
}

/* Computes sine and cosine. The angle is reduced by the nearest multiple of half of pi to r + tail (W. J. Cody and W. Waite,
   Software Manual for the Elementary Functions, 1980), for which sine and cosine are minimax polynomials. Angles beyond 1e5 are
   passed to the library. */
static void $_sin_cos(double x, double *sine, double *cosine)
{
    static const double of_sine[7] = {
        -0.16666666666666666, 0.00833333333333304, -0.00019841269840959285, 2.7557319071880108e-6,
        -2.5052070283413337e-8, 1.6054220478404451e-10, -7.384541077016098e-13
    };
    static const double of_cosine[7] = {
        0.041666666666666664, -0.0013888888888888389, 2.4801587301180814e-5, -2.7557319060679635e-7,
        2.0876722008612133e-9, -1.1466861871211882e-11, 4.59269524334066e-14
    };
    const double size = fabs(x);
    double turns, rounded, r, tail, most, z, slope, half, lost, s, c;
    uint64_t quadrant;
    if (!(size <= 100000.0)) {
        *sine = sin(x);
        *cosine = cos(x);
        return;
    }
    /* Adding 2 to the power of 52 rounds to an integer, whose last bits are those of the sum. */
    rounded = $_mul_add(size, 0.6366197723675814, 4503599627370496.0);
    memcpy(&quadrant, &rounded, sizeof quadrant);
    turns = 4503599627370496.0 - rounded;
    most = $_mul_add(turns, 1.5707963267923333, size);
    r = $_mul_add(turns, 2.5633441515839558e-12, most);
    lost = $_mul_add(turns, 2.5633441515839558e-12, most - r);
    tail = $_mul_add(turns, 1.0562999066987428e-23, lost);
    z = r * r;
    slope = $_mul_add(z, $_mul_add(z, 1.0 / 24.0, -0.5), 1.0);
    s = r + $_mul_add(r * z, $_polynomial(of_sine, z), tail * slope);
    half = 0.5 * z;
    most = 1.0 - half;
    lost = (1.0 - most) - half;
    slope = $_mul_add(z, -1.0 / 6.0, 1.0);
    c = most + $_mul_add(z * z, $_polynomial(of_cosine, z), lost - r * tail * slope);
    if (quadrant & 1) {
        const double other = s;
        s = c;
        c = other;
    }
    if (quadrant & 2) {
        s = -s;
    }
    if ((quadrant ^ (quadrant << 1)) & 2) {
        c = -c;
    }
    *sine = signbit(x) ? -s : s;
    *cosine = c;
}
