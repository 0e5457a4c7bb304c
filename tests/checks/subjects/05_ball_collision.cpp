#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "05_ball_collision/ball_collision.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

using namespace bounce;

namespace {

Ball ball_of(const check::OneOfMany& one) {
  return {check::to_vector<Eigen::Vector3d>(one.motion.position),
          check::to_vector<Eigen::Vector3d>(one.motion.velocity), one.radius};
}

class Subject final : public check::Subject {
 public:
  check::MeetingFound meet(const check::OneOfMany& a, const check::OneOfMany& b) const override {
    const Meeting meeting = bounce::meet(ball_of(a), ball_of(b));
    return {meeting.overlap, check::to_triple(meeting.e12), meeting.separation_speed};
  }
  check::Triple pair_force(const check::Setting& setting, const check::OneOfMany& a,
                           const check::OneOfMany& b) const override {
    const SpringDamper contact{setting.stiffness, setting.damping, check::contact_law(setting)};
    return check::to_triple<Eigen::Vector3d>(bounce::pair_force(ball_of(a), ball_of(b), contact));
  }
  std::vector<check::Triple> accelerations(
      const check::Setting& setting, const std::vector<check::OneOfMany>& balls) const override {
    State<Eigen::Matrix3Xd> state;
    const BallCollision scene = scene_of(setting, balls, state);
    const Eigen::Matrix3Xd& found = scene.acceleration(0, state);
    std::vector<check::Triple> all;
    for (Eigen::Index i = 0; i < found.cols(); ++i) {
      all.push_back({found(0, i), found(1, i), found(2, i)});
    }
    return all;
  }
  /// Two balls, the second at rest at the origin and as heavy as the first; tells the first one.
  check::Motion run(const check::Setting& setting, const check::Motion& start, double dt,
                    long steps) const override {
    State<Eigen::Matrix3Xd> state;
    const BallCollision scene = scene_of(
        setting, {{start, setting.radius, setting.mass}, {{}, setting.radius, setting.mass}},
        state);
    for (long i = 0; i < steps; ++i) {
      semi_implicit_euler(scene, static_cast<double>(i) * dt, state, dt);
    }
    const Eigen::Vector3d position = state.position.col(0), velocity = state.velocity.col(0);
    return {check::to_triple(position), check::to_triple(velocity)};
  }

 private:
  static BallCollision scene_of(const check::Setting& setting,
                                const std::vector<check::OneOfMany>& balls,
                                State<Eigen::Matrix3Xd>& state) {
    const auto count = static_cast<Eigen::Index>(balls.size());
    BallCollision scene;
    scene.gravity = setting.gravity;
    scene.stiffness = setting.stiffness;
    scene.damping = setting.damping;
    scene.floor_stiffness = setting.floor_stiffness;
    scene.floor_damping = setting.floor_damping;
    scene.contact = check::contact_law(setting);
    scene.floor = setting.floor;
    scene.mass.resize(count);
    scene.radius.resize(count);
    state.position.resize(3, count);
    state.velocity.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const check::OneOfMany& one = balls[static_cast<std::size_t>(i)];
      scene.mass[i] = one.mass;
      scene.radius[i] = one.radius;
      state.position.col(i) = check::to_vector<Eigen::Vector3d>(one.motion.position);
      state.velocity.col(i) = check::to_vector<Eigen::Vector3d>(one.motion.velocity);
    }
    return scene;
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
