#pragma once
#include <functional>
#include <memory>

#include "06_oscillating_floor/picture/live_bifurcation.hpp"
#include "06_oscillating_floor/picture/touch_section.hpp"

namespace bounce {

/// The bifurcation picture under the slider `amplitude`, and the Poincare section.
inline Survey amplitude_survey() {
  const auto picture = std::make_shared<LiveBifurcation>();
  const auto section = std::make_shared<TouchSection>();
  return {"amplitude", std::bind_front(&LiveBifurcation::work, picture),
          std::bind_front(&LiveBifurcation::draw, picture), LiveBifurcation::amplitude_at,
          std::bind_front(&TouchSection::draw, section)};
}

}  // namespace bounce
