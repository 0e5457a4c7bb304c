// Stage 5, the whole program: a small ball on a big one, and both fall on the floor.
//   g++ -I /usr/include/eigen3 plain.cpp && ./a.out
#include <Eigen/Core>
#include <iostream>
using Eigen::Vector3d;  // three numbers, for + - * and / as if they were one

const double g = 9.81;    // gravity [m/s^2]
const double k = 1e5;     // stiffness of the springs [N/m]
const double c = 0.0;     // damping [N s/m]: the floor takes nothing
const double dt = 1e-3;   // time step [s]
const int steps = 10000;  // 10 s of them

const int balls = 2;                                      // the stage program's scene=tower
const double m[balls] = {10.0, 1.0};                      // masses [kg]: of one material
const double r[balls] = {0.2, 0.2 / 2.1544346900318838};  // radii [m]; it is the cube root of 10

int main() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,ball,x,y,z,vx,vy,vz\n";

  Vector3d v[balls] = {{0, 0, 0}, {0, 0, 0}};  // velocities at the start [m/s]; up is positive
  Vector3d p[balls];                           // positions of the centres at the start [m]
  p[0] = Vector3d(0, 0.8 + r[0], 0);
  p[1] = p[0] + Vector3d(0, r[0] + r[1], 0);  // the small one stands on the big one
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    for (int i = 0; i < balls; i++) {
      std::cout << t << "," << i << "," << p[i].x() << "," << p[i].y() << "," << p[i].z() << ",";
      std::cout << v[i].x() << "," << v[i].y() << "," << v[i].z() << "\n";
    }

    Vector3d F[balls];
    for (int i = 0; i < balls; i++) {
      F[i] = Vector3d(0, -m[i] * g, 0);  // gravity, downwards
      if (p[i].y() < r[i]) {
        F[i].y() += k * (r[i] - p[i].y()) - c * v[i].y();  // the floor, at height 0
      }
      for (int j = 0; j < i; j++) {  // all pairs, each once
        Vector3d between = p[i] - p[j];
        double d = between.norm();
        if (d < r[i] + r[j]) {
          Vector3d push = k * (r[i] + r[j] - d) * (between / d);  // a spring along the centres
          F[i] += push;
          F[j] -= push;  // equal and opposite
        }
      }
    }

    for (int i = 0; i < balls; i++) {
      Vector3d a = F[i] / m[i];  // force gives acceleration
      v[i] += a * dt;            // acceleration changes velocity
      p[i] += v[i] * dt;         // velocity changes position
    }
  }
}
