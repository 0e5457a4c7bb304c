// Stage 8, the whole program: the plane ends at a rim, and it moves: a racket. Here it rises and
// moves away under the ball, which bounces, comes to rest, and in the end slips off over the rim.
//   g++ -I /usr/include/eigen3 plain.cpp && ./a.out
// The stage program does the same with --player none --set position=0,0.6015,0
//   --set racket_position=0.25,0,0 --set racket_velocity=-0.06,0.1,0
#include <Eigen/Core>
#include <iostream>
using Eigen::Vector3d;  // three numbers, for + - * and / as if they were one

const double m = 1.0;     // mass [kg]
const double g = 9.81;    // gravity [m/s^2]
const double r = 0.1;     // radius of the ball [m]
const double k = 1e4;     // stiffness of the spring [N/m]
const double c = 14.17;   // damping [N s/m]
const double dt = 1e-3;   // time step [s]
const int steps = 10000;  // 10 s of them

const Vector3d abc(0.0, 1.0, 0.0);         // normal to the racket, a disc; here it lies flat
const Vector3d normal = abc / abc.norm();  // the same with length 1
const Vector3d start(0.25, 0.0, 0.0);      // centre of the disc at the start [m]
const Vector3d u(-0.06, 0.1, 0.0);         // and its velocity [m/s]
const double R = 0.3;                      // radius of the disc [m]

int main() {
  std::cout.precision(17);  // so many digits that each number can be read back as it was
  std::cout << "t,x,y,z,vx,vy,vz\n";

  Vector3d v(0.0, 0.0, 0.0);     // velocity at the start [m/s]; up is positive
  Vector3d p(0.0, 0.6015, 0.0);  // position of the ball's centre at the start [m]
  for (int n = 0; n <= steps; n++) {
    double t = n * dt;  // not t += dt: that would collect the rounding of every step
    std::cout << t << "," << p.x() << "," << p.y() << "," << p.z() << ",";
    std::cout << v.x() << "," << v.y() << "," << v.z() << "\n";

    Vector3d centre = start + u * t;                                // the disc moves evenly
    Vector3d along = p - centre - normal.dot(p - centre) * normal;  // from there, along the disc
    if (along.norm() > R) {
      along *= R / along.norm();  // the ball is beside the disc: the rim is nearest
    }
    Vector3d between = p - (centre + along);  // from the nearest point to the ball
    double distance = between.norm();
    Vector3d e = between / distance;
    double speed = e.dot(v - u);  // at which the distance grows [m/s]

    Vector3d F(0, -m * g, 0);  // gravity, downwards
    if (distance < r) {
      F += (k * (r - distance) - c * speed) * e;  // the racket: a spring and a damper
    }

    Vector3d a = F / m;  // force gives acceleration
    v += a * dt;         // acceleration changes velocity
    p += v * dt;         // velocity changes position
  }
}
