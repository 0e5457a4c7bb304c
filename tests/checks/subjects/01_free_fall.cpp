#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "01_free_fall/free_fall.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

using namespace bounce;

namespace {

struct AnyLaw {
  check::LinearLaw law;
  double acceleration(double t, const State<double>& state) const {
    return law(t, state.position, state.velocity);
  }
};

/// Two numbers as one vector: the loop shall move that, too. The compiler tells this name to a
/// learner who keeps the acceleration in a double.
struct VectorNotDouble {
  double a, b;
  VectorNotDouble operator*(double factor) const { return {a * factor, b * factor}; }
  VectorNotDouble operator/(double divisor) const { return {a / divisor, b / divisor}; }
  VectorNotDouble operator+(const VectorNotDouble& other) const {
    return {a + other.a, b + other.b};
  }
  VectorNotDouble operator-(const VectorNotDouble& other) const {
    return {a - other.a, b - other.b};
  }
  VectorNotDouble& operator+=(const VectorNotDouble& other) { return *this = *this + other; }
  VectorNotDouble& operator-=(const VectorNotDouble& other) { return *this = *this - other; }
  [[maybe_unused]] friend VectorNotDouble operator*(double factor, const VectorNotDouble& two) {
    return two * factor;
  }
};
struct LawOfVector {
  check::LinearLaw law;
  VectorNotDouble acceleration(double t, const State<VectorNotDouble>& state) const {
    return {law(t, state.position.a, state.velocity.a), law(t, state.position.b, state.velocity.b)};
  }
};

/// Stage 1 writes the loop itself.
class Subject final : public check::OneBall<FreeFall> {
 public:
  check::Motion run(const check::Setting& setting, const check::Motion& start, double dt,
                    long steps) const override {
    const FreeFall scene = scene_of(setting);
    State<double> state = state_of(start);
    for (long i = 0; i < steps; ++i) fall_one_step(scene, static_cast<double>(i) * dt, state, dt);
    return motion_of(state);
  }
  check::Motion step(const check::LinearLaw& law, double t, const check::Motion& now,
                     double dt) const override {
    State<double> state = state_of(now);
    fall_one_step(AnyLaw{law}, t, state, dt);
    // The same as the second part of a vector: a loop that is right for numbers only shows here.
    State<VectorNotDouble> two{{0, now.position[1]}, {0, now.velocity[1]}};
    fall_one_step(LawOfVector{law}, t, two, dt);
    if (two.position.b != state.position || two.velocity.b != state.velocity) {
      return {{0, two.position.b, 0}, {0, two.velocity.b, 0}};
    }
    return motion_of(state);
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
