// Stage 3, the whole program: a damper beside the spring, and the bounces die out.
//   g++ plain.cpp && ./a.out
#include <iostream>

const double m = 1.0;     // mass [kg]
const double g = 9.81;    // gravity [m/s^2]
const double r = 0.1;     // radius of the ball [m]
const double k = 1e4;     // stiffness of the spring [N/m]
const double c = 5.0;     // damping [N s/m]
const double dt = 1e-3;   // time step [s]
const int steps = 10000;  // 10 s of them

int main() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,y,v\n";

  double v = 0.0;  // velocity at the start [m/s]; up is positive
  double y = 1.0;  // height of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    std::cout << t << "," << y << "," << v << "\n";

    double F = -m * g;  // gravity, downwards
    if (y < r) {
      F += k * (r - y) - c * v;  // the floor, at height 0: a spring and a damper
    }

    double a = F / m;  // force gives acceleration
    v += a * dt;       // acceleration changes velocity
    y += v * dt;       // velocity changes position
  }
}
