// Two equal masses on equal massless rods at absolute angles, by hand: Cramer's rule.
#include <math.h>

void accelerations(const double *x, double *a) {
  const double pull = 9.81 / 0.7;
  double d = x[0] - x[1], s = sin(d), c = cos(d);
  double f1 = -s * (x[3] * x[3]) - 2 * pull * sin(x[0]);
  double f2 = s * (x[2] * x[2]) - pull * sin(x[1]);
  double r = 1 / (2 - c * c);
  a[0] = (f1 - c * f2) * r;
  a[1] = (2 * f2 - c * f1) * r;
}
