// The symmetric heavy top in z-x-z Euler angles, by hand.
#include <math.h>

void accelerations(const double *x, double *a) {
  const double I = 1.2, Is = 0.5, mgl = 1.3 * 9.81 * 0.4;
  double s = sin(x[1]), c = cos(x[1]), phi = x[3], theta = x[4], psi = x[5];
  double along = phi * c, w3 = along + psi;
  double phi_rate = (Is * w3 - 2 * I * along) * theta / (I * s);
  a[0] = phi_rate;
  a[1] = s * (I * phi * along - Is * w3 * phi + mgl) * (1.0 / I);
  a[2] = phi * theta * s - phi_rate * c;
}
