#pragma once
#include <type_traits>

#include "checks/subject.hpp"
#include "physics/contact.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "physics/state.hpp"

namespace bounce::check {

template <class Vector>
Vector to_vector(const Triple& triple) {
  if constexpr (std::is_same_v<Vector, double>) {
    return triple[1];
  } else {
    return Vector(triple[0], triple[1], triple[2]);
  }
}

template <class Vector>
Triple to_triple(const Vector& vector) {
  if constexpr (std::is_same_v<Vector, double>) {
    return {0, vector, 0};
  } else {
    return {vector[0], vector[1], vector[2]};
  }
}

inline ContactLaw contact_law(const Setting& setting) {
  return setting.push_only ? ContactLaw::push_only : ContactLaw::may_pull;
}

template <class Scene>
void nothing_more(Scene&, const Setting&) {}

/// A stage with one ball: `Scene` is the stage's struct. `take_own` hands over what only it has.
template <class Scene, void (*take_own)(Scene&, const Setting&) = nothing_more<Scene>>
class OneBall : public Subject {
 public:
  using Vector = decltype(Scene::start.position);

  static State<Vector> state_of(const Motion& motion) {
    return {to_vector<Vector>(motion.position), to_vector<Vector>(motion.velocity)};
  }
  static Motion motion_of(const State<Vector>& state) {
    return {to_triple(state.position), to_triple(state.velocity)};
  }

  static Scene scene_of(const Setting& setting) {
    Scene scene;
    scene.mass = setting.mass;
    scene.gravity = setting.gravity;
    if constexpr (requires { scene.radius; }) scene.radius = setting.radius;
    if constexpr (requires { scene.stiffness; }) scene.stiffness = setting.stiffness;
    if constexpr (requires { scene.damping; }) scene.damping = setting.damping;
    if constexpr (requires { scene.contact; }) scene.contact = contact_law(setting);
    if constexpr (requires { scene.floor; }) scene.floor = setting.floor;
    if constexpr (requires { scene.floor_law; }) {
      scene.amplitude = setting.amplitude;
      scene.angular_frequency = setting.angular_frequency;
      scene.phase = setting.phase;
      scene.floor_velocity = setting.floor_velocity;
      scene.floor_law = static_cast<decltype(scene.floor_law)>(setting.floor_law);
    }
    if constexpr (requires { scene.offset; }) {
      scene.normal = to_vector<Vector>(setting.normal);
      scene.offset = setting.offset;
    }
    take_own(scene, setting);
    return scene;
  }

  Triple force(const Setting& setting, double t, const Motion& motion) const override {
    return to_triple<Vector>(scene_of(setting).force(t, state_of(motion)));
  }
  Triple acceleration(const Setting& setting, double t, const Motion& motion) const override {
    return to_triple<Vector>(scene_of(setting).acceleration(t, state_of(motion)));
  }
  Motion run(const Setting& setting, const Motion& start, double dt, long steps) const override {
    const Scene scene = scene_of(setting);
    State<Vector> state = state_of(start);
    for (long i = 0; i < steps; ++i) {
      semi_implicit_euler(scene, static_cast<double>(i) * dt, state, dt);
    }
    return motion_of(state);
  }
};

}  // namespace bounce::check

/// The one name that a module shows: its subject.
#define BOUNCE_SUBJECT(Type)                                                       \
  extern "C" __attribute__((visibility("default"))) const void* bounce_subject() { \
    static const Type subject;                                                     \
    return static_cast<const bounce::check::Subject*>(&subject);                   \
  }
