// Stage 6, the whole program: the floor moves up and down under the ball.
//   g++ plain.cpp && ./a.out
#include <cmath>
#include <iostream>

const double m = 1.0;     // mass [kg]
const double g = 9.81;    // gravity [m/s^2]
const double r = 0.1;     // radius of the ball [m]
const double k = 1e4;     // stiffness of the spring [N/m]
const double c = 14.17;   // damping [N s/m]
const double A = 0.06;    // how far the floor swings to each side [m]
const double w = 12.6;    // how fast it swings [rad/s]: about twice a second
const double dt = 1e-3;   // time step [s]
const int steps = 10000;  // 10 s of them

int main() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,floor,y,v\n";

  double v = 0.0;  // velocity at the start [m/s]; up is positive
  double y = 0.8;  // height of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    double floor = A * std::sin(w * t);        // height of the floor now [m]
    double floor_v = A * w * std::cos(w * t);  // and its velocity [m/s], the derivative
    std::cout << t << "," << floor << "," << y << "," << v << "\n";

    double F = -m * g;  // gravity, downwards
    if (y - floor < r) {
      F += k * (r - y + floor) - c * (v - floor_v);  // the floor: a spring and a damper
    }

    double a = F / m;  // force gives acceleration
    v += a * dt;       // acceleration changes velocity
    y += v * dt;       // velocity changes position
  }
}
