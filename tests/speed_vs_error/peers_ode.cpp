// The Open Dynamics Engine, with its exact solver (dWorldStep), restitution at every speed and no
// friction.

#include <ode/ode.h>

#include "speed_vs_error/engines.hpp"

namespace bounce::report {
namespace {

class OdeBall final : public EngineBall {
 public:
  OdeBall(double dt, double restitution) : dt_(dt) {
    dWorldSetGravity(world_, 0, -9.81, 0);
    dCreatePlane(space_, 0, 1, 0, 0);
    dGeomSetBody(dCreateSphere(space_, 0.1), ball_);
    dMass mass;
    dMassSetSphereTotal(&mass, 1, 0.1);
    dBodySetMass(ball_, &mass);
    contact_.surface.mode = dContactBounce;
    contact_.surface.mu = 0;
    contact_.surface.bounce = restitution;
    contact_.surface.bounce_vel = 0;
  }
  OdeBall(const OdeBall&) = delete;
  OdeBall& operator=(const OdeBall&) = delete;
  ~OdeBall() override {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  void drop() override {
    dBodySetPosition(ball_, 0, 1, 0);
    dBodySetLinearVel(ball_, 0, 0, 0);
    dBodySetAngularVel(ball_, 0, 0, 0);
  }
  void step() override {
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeBall*>(self)->touch(a, b);
    });
    dWorldStep(world_, dt_);
    dJointGroupEmpty(joints_);
  }
  double height() const override { return dBodyGetPosition(ball_)[1]; }
  double velocity() const override { return dBodyGetLinearVel(ball_)[1]; }

 private:
  struct Library {  // started once, before the first world
    Library() { dInitODE(); }
  };
  static void start_library() { static const Library library; }
  static dWorldID new_world() {
    start_library();
    return dWorldCreate();
  }
  void touch(dGeomID a, dGeomID b) {
    if (dCollide(a, b, 1, &contact_.geom, sizeof contact_) == 0) return;
    const dJointID joint = dJointCreateContact(world_, joints_, &contact_);
    dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
  }

  double dt_;
  dWorldID world_ = new_world();
  dSpaceID space_ = dSimpleSpaceCreate(nullptr);
  dJointGroupID joints_ = dJointGroupCreate(0);
  dBodyID ball_ = dBodyCreate(world_);
  dContact contact_{};
};

}  // namespace

void add_ode(std::vector<Engine>& to) {
  to.push_back({"ODE", dODE_VERSION, Bounce::restitution, [](double dt, double restitution) {
                  return std::make_unique<OdeBall>(dt, restitution);
                }});
}

}  // namespace bounce::report
