"""The arithmetic of references of motions: 100 bits, of GNU MPFR where Python has gmpy2, which takes a tenth of the time of mpmath."""

from contextlib import contextmanager

from mpmath import mp, mpf, workprec

from derivatives import CONSTANT

BITS = 100

try:
    import gmpy2 as library

    real = lambda x: library.mpfr(str(x)) if isinstance(x, mpf) else library.mpfr(x)
except ImportError:
    library, real = mp, mpf


@contextmanager
def precise():
    """Operations have `BITS` bits meanwhile. Constants beside numbers of the library are its own: mpmath has no products with its zeros."""
    if library is mp:
        with workprec(BITS):
            yield
        return
    before, CONSTANT[0] = CONSTANT[0], lambda x: real(x) if isinstance(x, mpf) else x
    try:
        with workprec(BITS), library.context(library.get_context(), precision=BITS):
            yield
    finally:
        CONSTANT[0] = before
