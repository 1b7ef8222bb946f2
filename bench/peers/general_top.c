// The general heavy top in z-x-z Euler angles, by hand: Euler's equations, mapped back to the angles.
#include <math.h>

void accelerations(const double *x, double *a) {
  const double I1 = 1.2, I2 = 1.5, I3 = 0.7;
  const double mx = 1.3 * 9.81 * 0.05, my = 1.3 * 9.81 * 0.03, mz = 1.3 * 9.81 * 0.4;
  double s = sin(x[1]), c = cos(x[1]), sp = sin(x[2]), cp = cos(x[2]);
  double phi = x[3], theta = x[4], psi = x[5];
  // The vertical and the angular velocity, in the body.
  double k1 = s * sp, k2 = s * cp;
  double w1 = phi * k1 + theta * cp, w2 = phi * k2 - theta * sp, along = phi * c, w3 = along + psi;
  double d1 = ((I2 - I3) * w2 * w3 - (my * c - mz * k2)) * (1 / I1);
  double d2 = ((I3 - I1) * w3 * w1 - (mz * k1 - mx * c)) * (1 / I2);
  double d3 = ((I1 - I2) * w1 * w2 - (mx * k2 - my * k1)) * (1 / I3);
  double e1 = d1 - psi * w2, e2 = d2 + psi * w1;
  double phi_rate = (e1 * sp + e2 * cp - theta * along) / s;
  a[0] = phi_rate;
  a[1] = e1 * cp - e2 * sp;
  a[2] = d3 - phi_rate * c + phi * theta * s;
}
