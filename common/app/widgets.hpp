#pragma once
#include <imgui.h>

#include "app/palette.hpp"
#include "physics/parameters.hpp"

namespace bounce {

// What the panel's parts have in common: our colours, a slider, a heading.

inline ImVec4 colour(Colour c) {
  return {static_cast<float>(c.red) / 255, static_cast<float>(c.green) / 255,
          static_cast<float>(c.blue) / 255, static_cast<float>(c.alpha) / 255};
}

inline bool slide(const char* name, double& value, Range range) {
  const bool logarithmic = range.lowest > 0 && range.highest >= 50 * range.lowest;
  return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &range.lowest, &range.highest,
                             "%.5g", logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

inline void heading(const char* words) {
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::TextColored(colour(palette::exact), "%s", words);
}

}  // namespace bounce
