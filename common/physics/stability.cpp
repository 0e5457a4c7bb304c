#include "physics/stability.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace bounce {

double explicit_euler_limit(double zeta) {
  if (zeta < 1) return 2 * zeta;                   // complex pair: |1 + lambda dt| = 1
  return 2 / (zeta + std::sqrt(zeta * zeta - 1));  // real: the faster eigenvalue reaches -1
}

double semi_implicit_euler_limit(double zeta) {
  // One step has determinant 1 - 2 zeta w and trace 2 - 2 zeta w - w^2, with w = omega0 dt. The
  // first eigenvalue to leave the unit circle does so at -1, where 1 + trace + determinant = 0:
  // w^2 + 4 zeta w - 4 = 0. Its positive root is 2 (sqrt(1 + zeta^2) - zeta), without cancellation:
  return 2 / (std::sqrt(1 + zeta * zeta) + zeta);
}

namespace {

double rk4_growth(double zeta, double omega0_dt) {
  const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1, 0));
  const auto growth = [](std::complex<double> z) {
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
  };
  return std::max(growth((-zeta + root) * omega0_dt), growth((-zeta - root) * omega0_dt));
}

}  // namespace

double rk4_limit(double zeta) {
  // The fastest eigenvalue decides. Walk outwards in small strides until the growth exceeds 1 by
  // more than rounding, then bisect the last stride.
  const double fastest = zeta < 1 ? 1 : zeta + std::sqrt(zeta * zeta - 1);
  const auto unstable = [&](double omega0_dt) { return rk4_growth(zeta, omega0_dt) > 1 + 1e-14; };
  const double stride = 0.01 / fastest;
  double stable = 2.5 / fastest;  // inside the region for every zeta
  while (!unstable(stable + stride)) stable += stride;
  double above = stable + stride;
  for (int i = 0; i < 60; ++i) {
    const double middle = (stable + above) / 2;
    (unstable(middle) ? above : stable) = middle;
  }
  return stable;
}

double restitution_step(double omega0, double zeta, double accuracy) {
  // The root of w^2/8 + slope w = accuracy, without cancellation; never beyond the stable limit.
  const double e = zeta < 1 ? std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta)) : 0;
  const double slope = 4 * zeta * e;
  const double w = 2 * accuracy / (slope + std::sqrt(slope * slope + accuracy / 2));
  return std::min(w, semi_implicit_euler_limit(zeta)) / omega0;
}

double comfortable_step(double omega0, double zeta) {
  return std::min(semi_implicit_euler_limit(zeta) / 20 / omega0,
                  restitution_step(omega0, zeta, 0.01));
}

}  // namespace bounce
