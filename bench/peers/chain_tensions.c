// A chain of N equal masses on massless rods at absolute angles, by hand, in O(N): the tensions of the
// rods from a tridiagonal system, then what they and the weight do across each rod.
#include <math.h>

void accelerations(const double *x, double *a) {
  const double l = 0.7, g = 9.81;
  double S[N], C[N], c[N], s[N], t[N], p[N], b[N];
  for (int i = 0; i < N; i++) {
    S[i] = sin(x[i]);
    C[i] = cos(x[i]);
  }
  for (int i = 0; i + 1 < N; i++) {
    c[i] = C[i] * C[i + 1] + S[i] * S[i + 1];
    s[i] = S[i + 1] * C[i] - C[i + 1] * S[i];
  }
  for (int i = 0; i < N; i++) b[i] = l * x[N + i] * x[N + i];
  b[0] += g * C[0];
  // The diagonal is 1, 2, 2, …; beside it stands -c. The tensions are for a unit of mass.
  p[0] = N > 1 ? -c[0] : 0;
  t[0] = b[0];
  for (int i = 1; i < N; i++) {
    double r = 1.0 / (2.0 + c[i - 1] * p[i - 1]);
    t[i] = (b[i] + c[i - 1] * t[i - 1]) * r;
    p[i] = (i + 1 < N) ? -c[i] * r : 0;
  }
  for (int i = N - 2; i >= 0; i--) t[i] -= p[i] * t[i + 1];
  for (int i = 0; i < N; i++) {
    double v = 0;
    if (i + 1 < N) v += t[i + 1] * s[i];
    if (i > 0) v -= t[i - 1] * s[i - 1];
    else v -= g * S[0];
    a[i] = v * (1.0 / l);
  }
}
