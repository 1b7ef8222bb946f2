"""The arithmetic of references of motions: 100 bits, of GNU MPFR where Python has gmpy2, which takes a tenth of the time of mpmath."""

from contextlib import contextmanager

from mpmath import mp, mpf, workprec

BITS = 100

try:
    import gmpy2 as library

    real = lambda x: library.mpfr(str(x)) if isinstance(x, mpf) else library.mpfr(x)
except ImportError:
    library, real = mp, mpf


@contextmanager
def precise():
    """Operations have `BITS` bits meanwhile."""
    if library is mp:
        with workprec(BITS):
            yield
        return
    with workprec(BITS), library.context(library.get_context(), precision=BITS):
        yield
