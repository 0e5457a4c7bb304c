#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/space_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<TiltedPlane, TiltedPlaneExact>;

static constexpr double degree = std::numbers::pi / 180;

static BallInSpace ball(const Player& player) {
  const TiltedPlane scene = static_cast<const Run&>(player.simulation()).scene();
  BallInSpace look;
  look.radius = scene.radius;
  look.plane = scene.plane();
  look.landings = true;
  look.look_at = {3.3, -0.6, 0};
  look.distance = 11;
  look.room = 3.2;
  look.forces = [scene](const State<Eigen::Vector3d>& state) {
    return ForcesInSpace{{0, -scene.mass * scene.gravity, 0},
                         scene.spring_force(state),
                         scene.damper_force(0, state)};
  };
  return look;
}

/// How far the plane leans towards x [degrees].
static double tilt(const Simulation& simulation) {
  const Plane plane = static_cast<const Run&>(simulation).scene().plane();
  return std::atan2(plane.normal.x(), plane.normal.y()) / degree;
}

/// Turns plane and ball together about the z axis, so that a ball that lies on the plane stays on
/// it: whoever sits on the plane sees gravity turn.
static void set_tilt(Simulation& simulation, double degrees) {
  const Run& run = static_cast<const Run&>(simulation);
  const Eigen::AngleAxisd turn((tilt(run) - degrees) * degree, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d position = turn * run.state().position;
  const Eigen::Vector3d velocity = turn * run.state().velocity;
  const Eigen::Vector3d normal = turn * run.scene().normal;
  find_parameter(simulation.parameters(), "normal").set(to_text(components(normal)));
  simulation.place({position.x(), position.y(), position.z(),  //
                    velocity.x(), velocity.y(), velocity.z()});
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"07_tilted_plane", "a ball that bounces down a tilted plane"};
  demo.title = "Stage 7: tilted plane";
  demo.question =
      "Turn off the damping. How do the distances between the landings grow? And which tilt makes "
      "the beat faster?";
  demo.dials = {{"tilt",
                 "degrees",
                 "turns plane and ball together; positive: downhill along x",
                 {-30, 30},
                 tilt,
                 set_tilt}};
  demo.sliders = {"damping", "stiffness"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_space_view(demo, ball);
  demo.plots = {
      {"velocity along x", "m/s", palette::motion,
       [](const TracePoint& point) { return point.values[3]; },
       [](const TracePoint& point) { return point.exact[3]; }},
      {"velocity along y (up)", "m/s", palette::motion,
       [](const TracePoint& point) { return point.values[4]; },
       [](const TracePoint& point) { return point.exact[4]; }},
  };
  return play(argc, argv, demo);
}
