// Stage 7, the whole program: the floor is a tilted plane, a x + b y + c z + d = 0.
//   g++ -I /usr/include/eigen3 plain.cpp && ./a.out
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

const Vector3d abc(0.17633, 1.0, 0.0);     // normal to the plane; here it leans by 10 degrees
const Vector3d normal = abc / abc.norm();  // the same with length 1: d is then a distance, too
const double d = 0.0 / abc.norm();         // [m] (both sides of the equation, divided alike)

int main() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,x,y,z,vx,vy,vz\n";

  Vector3d v(0.0, 0.0, 0.0);     // velocity at the start [m/s]; up is positive
  Vector3d p(0.0, 0.6015, 0.0);  // position of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    std::cout << t << "," << p.x() << "," << p.y() << "," << p.z() << ",";
    std::cout << v.x() << "," << v.y() << "," << v.z() << "\n";

    double distance = normal.dot(p) + d;  // of the ball's centre from the plane [m]
    double speed = normal.dot(v);         // at which the distance grows [m/s]

    Vector3d F(0, -m * g, 0);  // gravity, downwards
    if (distance < r) {
      F += (k * (r - distance) - c * speed) * normal;  // the plane: a spring and a damper
    }

    Vector3d a = F / m;  // force gives acceleration
    v += a * dt;         // acceleration changes velocity
    p += v * dt;         // velocity changes position
  }
}
