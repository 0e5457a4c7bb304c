// Bullet: once as it comes, and once without two of its margins. By default a contact is solved
// from 2 cm above the floor on, which takes part of the rebound away, and an overlap is pushed out
// with a velocity of its own, which adds to it.

#include <btBulletDynamicsCommon.h>

#include "speed_vs_error/engines.hpp"

namespace bounce::report {
namespace {

class BulletBall final : public EngineBall {
 public:
  BulletBall(double dt, double restitution, bool without_margins)
      : dt_(dt), breaking_threshold_(without_margins ? 1e-6 : 0.02) {
    gContactBreakingThreshold = breaking_threshold_;
    world_.setGravity({0, -9.81, 0});
    btContactSolverInfo& solver = world_.getSolverInfo();
    solver.m_restitutionVelocityThreshold = 0;
    if (without_margins) solver.m_splitImpulsePenetrationThreshold = 0;
    floor_.setRestitution(1);
    ball_.setRestitution(restitution);  // the product counts
    ball_.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&floor_);
    world_.addRigidBody(&ball_);
  }
  ~BulletBall() override {
    world_.removeRigidBody(&ball_);
    world_.removeRigidBody(&floor_);
  }
  void drop() override {
    gContactBreakingThreshold = breaking_threshold_;
    btTransform at_top;
    at_top.setIdentity();
    at_top.setOrigin({0, 1, 0});
    ball_.setWorldTransform(at_top);
    ball_.setLinearVelocity({0, 0, 0});
    ball_.setAngularVelocity({0, 0, 0});
    ball_.clearForces();
  }
  void step() override { world_.stepSimulation(dt_, 0); }  // 0: exactly one step of dt
  double height() const override { return ball_.getWorldTransform().getOrigin().y(); }
  double velocity() const override { return ball_.getLinearVelocity().y(); }

 private:
  double dt_;
  double breaking_threshold_;  // [m]; engines take turns, so that each sets its own again
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btStaticPlaneShape plane_{{0, 1, 0}, 0};
  btSphereShape sphere_{0.1};
  btRigidBody floor_{{0, nullptr, &plane_}};
  btRigidBody ball_{{1, nullptr, &sphere_, {0.004, 0.004, 0.004}}};  // 2/5 m r^2
};

}  // namespace

void add_bullet(std::vector<Engine>& to) {
  const std::string version =
      std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
  for (const bool without_margins : {false, true}) {
    to.push_back({without_margins ? "Bullet without margins" : "Bullet", version,
                  Bounce::restitution, [=](double dt, double restitution) {
                    return std::make_unique<BulletBall>(dt, restitution, without_margins);
                  }});
  }
}

}  // namespace bounce::report
