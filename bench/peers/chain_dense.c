// A chain of N equal masses on massless rods at absolute angles, by hand: M = L D Lᵀ, dense.
#include <math.h>

void accelerations(const double *x, double *a) {
  const double m = 1.1, l = 0.7, g = 9.81;
  double S[N], C[N], M[N][N], D[N], f[N];
  for (int i = 0; i < N; i++) {
    S[i] = sin(x[i]);
    C[i] = cos(x[i]);
  }
  for (int i = 0; i < N; i++) {
    double sum = -(N - i) * m * g * l * S[i];
    for (int j = 0; j < N; j++) {
      int k = i > j ? i : j;
      double mu = (N - k) * m * l * l, sd = S[i] * C[j] - C[i] * S[j];
      sum -= mu * sd * x[N + j] * x[N + j];
    }
    f[i] = sum;
    for (int j = 0; j <= i; j++) M[i][j] = (N - i) * m * l * l * (C[i] * C[j] + S[i] * S[j]);
  }
  for (int j = 0; j < N; j++) {
    double d = M[j][j];
    for (int k = 0; k < j; k++) d -= M[j][k] * M[j][k] * D[k];
    D[j] = d;
    double r = 1 / d;
    for (int i = j + 1; i < N; i++) {
      double t = M[i][j];
      for (int k = 0; k < j; k++) t -= M[i][k] * M[j][k] * D[k];
      M[i][j] = t * r;
    }
  }
  for (int i = 0; i < N; i++) {
    double t = f[i];
    for (int k = 0; k < i; k++) t -= M[i][k] * a[k];
    a[i] = t;
  }
  for (int i = 0; i < N; i++) a[i] /= D[i];
  for (int i = N - 1; i >= 0; i--) {
    double t = a[i];
    for (int k = i + 1; k < N; k++) t -= M[k][i] * a[k];
    a[i] = t;
  }
}
