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
    return motion_of(state);
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
