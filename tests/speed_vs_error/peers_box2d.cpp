// Box2D, in two dimensions and single precision, with restitution at every speed.

#include <box2d/box2d.h>

#include "speed_vs_error/engines.hpp"

namespace bounce::report {
namespace {

class Box2dBall final : public EngineBall {
 public:
  Box2dBall(double dt, double restitution) : dt_(static_cast<float>(dt)) {
    world_.SetAllowSleeping(false);
    b2EdgeShape floor;
    floor.SetTwoSided({-10, 0}, {10, 0});
    const b2BodyDef at_rest;
    world_.CreateBody(&at_rest)->CreateFixture(&floor, 0);

    b2CircleShape circle;
    circle.m_radius = 0.1f;
    b2FixtureDef surface;
    surface.shape = &circle;
    surface.density = 1 / (b2_pi * 0.1f * 0.1f);
    surface.friction = 0;
    surface.restitution = static_cast<float>(restitution);
    surface.restitutionThreshold = 0;
    b2BodyDef moves;
    moves.type = b2_dynamicBody;
    moves.bullet = true;  // no step tunnels through the floor
    moves.position = {0, 1};
    ball_ = world_.CreateBody(&moves);
    ball_->CreateFixture(&surface);
  }
  void drop() override {
    ball_->SetTransform({0, 1}, 0);
    ball_->SetLinearVelocity({0, 0});
    ball_->SetAngularVelocity(0);
  }
  void step() override { world_.Step(dt_, 8, 3); }  // the iterations of its manual
  double height() const override { return static_cast<double>(ball_->GetPosition().y); }
  double velocity() const override { return static_cast<double>(ball_->GetLinearVelocity().y); }

 private:
  float dt_;
  b2World world_{{0, -9.81f}};
  b2Body* ball_ = nullptr;
};

}  // namespace

void add_box2d(std::vector<Engine>& to) {
  const std::string version = std::to_string(b2_version.major) + "." +
                              std::to_string(b2_version.minor) + "." +
                              std::to_string(b2_version.revision);
  to.push_back({"Box2D", version, Bounce::restitution, [](double dt, double restitution) {
                  return std::make_unique<Box2dBall>(dt, restitution);
                }});
}

}  // namespace bounce::report
