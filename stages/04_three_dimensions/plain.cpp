// Stage 4, the whole program, twice: with three times the variables, and with vectors.
//   g++ -I /usr/include/eigen3 plain.cpp && ./a.out        (or ./a.out vectors: the same rows)
#include <Eigen/Core>
#include <iostream>
using Eigen::Vector3d;  // three numbers, for + - * and / as if they were one

const double m = 1.0;     // mass [kg]
const double g = 9.81;    // gravity [m/s^2]
const double r = 0.1;     // radius of the ball [m]
const double k = 1e4;     // stiffness of the spring [N/m]
const double c = 5.0;     // damping [N s/m]
const double dt = 1e-3;   // time step [s]
const int steps = 10000;  // 10 s of them

void with_variables() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,x,y,z,vx,vy,vz\n";

  double vx = 1.0, vy = 0.0, vz = 0.5;  // velocity at the start [m/s]; up is positive
  double x = 0.0, y = 1.0, z = 0.0;     // position of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    std::cout << t << "," << x << "," << y << "," << z << ",";
    std::cout << vx << "," << vy << "," << vz << "\n";

    double Fx = 0, Fy = -m * g, Fz = 0;  // gravity, downwards
    if (y < r) {
      Fy += k * (r - y) - c * vy;  // the floor, at height 0: a spring and a damper
    }

    double ax = Fx / m;  // force gives acceleration
    vx += ax * dt;       // acceleration changes velocity
    x += vx * dt;        // velocity changes position
    double ay = Fy / m;
    vy += ay * dt;
    y += vy * dt;
    double az = Fz / m;
    vz += az * dt;
    z += vz * dt;
  }
}

void with_vectors() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,x,y,z,vx,vy,vz\n";

  Vector3d v(1.0, 0.0, 0.5);  // velocity at the start [m/s]; up is positive
  Vector3d p(0.0, 1.0, 0.0);  // position of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    std::cout << t << "," << p.x() << "," << p.y() << "," << p.z() << ",";
    std::cout << v.x() << "," << v.y() << "," << v.z() << "\n";

    Vector3d F(0, -m * g, 0);  // gravity, downwards
    if (p.y() < r) {
      F.y() += k * (r - p.y()) - c * v.y();  // the floor, at height 0: a spring and a damper
    }

    Vector3d a = F / m;  // force gives acceleration
    v += a * dt;         // acceleration changes velocity
    p += v * dt;         // velocity changes position
  }
}

int main(int argc, char**) {
  if (argc == 1) with_variables();
  if (argc > 1) with_vectors();  // ./a.out vectors
}
