// The panel's sliders: the parameters, and what a demo adds of its own.
#include <algorithm>
#include <cmath>

#include "app/panel.hpp"
#include "app/widgets.hpp"

namespace bounce {

void Panel::draw_parameters(Playback& playback, View& view, bool main_ones) {
  const std::vector<Parameter> parameters = playback.simulation().parameters();
  if (main_ones) {
    for (const std::string& name : demo_.sliders) {
      draw_parameter(playback, view, find_parameter(parameters, name));
    }
    return;
  }
  for (const Parameter& parameter : parameters) {
    const auto& main = demo_.sliders;
    if (std::find(main.begin(), main.end(), parameter.name) == main.end()) {
      draw_parameter(playback, view, parameter);
    }
  }
}

void Panel::draw_parameter(Playback& playback, View& view, const Parameter& parameter) {
  const auto apply = [&](const std::string& text) {
    set_parameter(demo_, playback, parameter.name, text);
    cost_is_old_ = true;
  };
  if (const auto* choice = std::get_if<Choice>(&parameter.value)) {
    for (std::size_t i = 0; i < choice->names.size(); ++i) {
      const std::string& name = choice->names[i];
      if (ImGui::RadioButton(name.c_str(), choice->selected() == i)) apply(name);
      ImGui::SameLine();
    }
    ImGui::TextUnformatted(parameter.name.c_str());
  } else if (const auto* vector = std::get_if<Components>(&parameter.value)) {
    std::vector<double> value(vector->begin(), vector->end());
    const Range& range = parameter.slider;
    if (ImGui::SliderScalarN(parameter.name.c_str(), ImGuiDataType_Double, value.data(),
                             static_cast<int>(value.size()), &range.lowest, &range.highest,
                             "%.3g") &&
        parameter.allows(value)) {
      apply(to_text(value));
    }
    note_slider(playback, view);
    ImGui::SameLine();
    ImGui::TextColored(colour(palette::exact), "%s", parameter.unit.c_str());
  } else {
    double value = **std::get_if<double*>(&parameter.value);
    const bool moved = slide(parameter.name.c_str(), value, parameter.slider);
    if (parameter.is_whole) value = std::round(value);
    if (moved && parameter.allows({&value, 1})) apply(to_text(value));
    note_slider(playback, view);
    ImGui::SameLine();
    ImGui::TextColored(colour(palette::exact), "%s", parameter.unit.c_str());
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", parameter.meaning.c_str());
}

void Panel::draw_dial(Playback& playback, View& view, const Dial& dial) {
  double value = dial.get(playback.simulation());
  if (slide(dial.name.c_str(), value, dial.range) && std::isfinite(value)) {
    playback.change([&](Simulation& simulation) { dial.set(simulation, value); });
  }
  note_slider(playback, view);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "%s", dial.unit.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", dial.meaning.c_str());
}

/// When a slider is taken, what would have happened is kept for comparison; while it moves, what
/// would happen now is drawn.
void Panel::note_slider(Playback& playback, View& view) {
  if (ImGui::IsItemActivated()) view.earlier = playback.future(future_length);
  if (ImGui::IsItemActive()) frames_since_slider_ = 0;
}

}  // namespace bounce
