#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "06_oscillating_floor/oscillating_floor.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

using namespace bounce;

namespace {

class Subject final : public check::OneBall<OscillatingFloor> {
 public:
  double floor_height(const check::Setting& setting, double t) const override {
    return scene_of(setting).floor_height(t);
  }
  double floor_speed(const check::Setting& setting, double t) const override {
    return scene_of(setting).floor_speed(t);
  }
  bool touches(const check::Setting& setting, double y, double floor) const override {
    return scene_of(setting).touches(y, floor);
  }
  double damped_velocity(const check::Setting& setting, double t, double v) const override {
    return scene_of(setting).damped_velocity(t, v);
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
