#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "07_tilted_plane/tilted_plane.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

using namespace bounce;

namespace {

class Subject final : public check::OneBall<TiltedPlane> {
 public:
  std::array<double, 4> plane(const check::Setting& setting) const override {
    const Plane plane = scene_of(setting).plane();
    return {plane.normal[0], plane.normal[1], plane.normal[2], plane.offset};
  }
};

}  // namespace

BOUNCE_SUBJECT(Subject)
