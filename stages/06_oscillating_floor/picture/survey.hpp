#pragma once
#include <memory>

#include "06_oscillating_floor/picture/live_bifurcation.hpp"
#include "06_oscillating_floor/picture/touch_section.hpp"

namespace bounce {

/// The bifurcation picture under the slider `amplitude`, and the Poincare section.
inline Survey amplitude_survey() {
  const auto picture = std::make_shared<LiveBifurcation>();
  const auto section = std::make_shared<TouchSection>();
  return {"amplitude",
          [picture](const Simulation& simulation, double seconds) {
            return picture->work(simulation, seconds);
          },
          [picture](Canvas& canvas, Rect area, const Simulation& simulation) {
            picture->draw(canvas, area, simulation);
          },
          LiveBifurcation::amplitude_at,
          [section](Canvas& canvas, Rect area, const Playback& playback) {
            section->draw(canvas, area, playback);
          }};
}

}  // namespace bounce
