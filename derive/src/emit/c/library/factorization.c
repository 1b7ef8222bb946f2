/* The factors of the mass matrix. */
typedef $_elimination $_factors;

/* Factors the mass matrix, whose lower triangle alone is read. */
static void $_factor(const double *mass, $_factors *f)
{
    if (!$_factor_ldlt(mass, @N, @N, 0.0, f)) {
        $_factor_lu(mass, @N, f);
    }
}

/* Solves for one right-hand side, which is overwritten. */
static void $_solve(const $_factors *f, double *x)
{
    $_substitute(f, @N, 0, x);
}
