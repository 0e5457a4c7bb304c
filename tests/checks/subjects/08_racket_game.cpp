#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "08_racket_game/racket_game.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

using namespace bounce;

namespace {

using Vector = Eigen::Vector3d;

class Subject final : public check::Subject {
 public:
  check::Triple force(const check::Setting& setting, double t,
                      const check::Motion& motion) const override {
    return check::to_triple<Vector>(scene_of(setting).force(t, state_of(motion)));
  }
  check::Triple acceleration(const check::Setting& setting, double t,
                             const check::Motion& motion) const override {
    return check::to_triple<Vector>(scene_of(setting).acceleration(t, state_of(motion)));
  }
  check::Motion run(const check::Setting& setting, const check::Motion& start, double dt,
                    long steps) const override {
    const Racket scene = scene_of(setting);
    State<Vector> state = state_of(start);
    for (long i = 0; i < steps; ++i) {
      semi_implicit_euler(scene, static_cast<double>(i) * dt, state, dt);
    }
    return {check::to_triple(state.position), check::to_triple(state.velocity)};
  }
  check::NearestFound nearest(const check::Setting& setting,
                              const check::Triple& ball) const override {
    const Racket scene = scene_of(setting);
    const NearestPoint found = scene.nearest(scene.disc, check::to_vector<Vector>(ball));
    return {check::to_triple(found.point), check::to_triple(found.direction), found.distance};
  }
  int side_after(const check::Setting& setting, double t,
                 const check::Triple& ball) const override {
    Racket scene = scene_of(setting);
    scene.choose_side(t, check::to_vector<Vector>(ball));
    return scene.side;
  }

 private:
  static State<Vector> state_of(const check::Motion& motion) {
    return {check::to_vector<Vector>(motion.position), check::to_vector<Vector>(motion.velocity)};
  }
  static Racket scene_of(const check::Setting& setting) {
    Racket scene;
    scene.mass = setting.mass;
    scene.gravity = setting.gravity;
    scene.radius = setting.radius;
    scene.stiffness = setting.stiffness;
    scene.damping = setting.damping;
    scene.contact = check::contact_law(setting);
    scene.disc = {check::to_vector<Vector>(setting.centre),
                  check::to_vector<Vector>(setting.disc_normal), setting.disc_radius,
                  check::to_vector<Vector>(setting.disc_velocity),
                  check::to_vector<Vector>(setting.disc_spin)};
    scene.side = setting.side;
    scene.since = setting.since;
    return scene;
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
