// The panel's read-out: what a step costs on this machine, and how wrong the run is now.
#include <algorithm>

#include "app/drawing.hpp"
#include "app/panel.hpp"
#include "app/widgets.hpp"
#include "run/step_warning.hpp"

namespace bounce {

void Panel::measure_cost(const Playback& playback) {
  const std::unique_ptr<Simulation> copy = playback.simulation().clone();
  copy->keep_energy_book(false);
  const double steps = std::max(10.0, 20000 / static_cast<double>(copy->balls()));
  const double begin = Playback::wall_clock();
  try {
    copy->advance_to(copy->time() + steps * copy->dt());
  } catch (const std::exception&) {
    return;
  }
  ns_per_step_ = (Playback::wall_clock() - begin) / steps * 1e9;
  counted_per_second_ = static_cast<double>(copy->counted_force_evaluations() -
                                            playback.simulation().counted_force_evaluations()) /
                        (copy->time() - playback.simulation().time());
  cost_is_old_ = false;
}

void Panel::draw_cost_and_error(Playback& playback) {
  heading("cost and error, now");
  const Simulation& simulation = playback.simulation();
  if (simulation.method() == methods::exact) {
    ImGui::Text("no steps: from event to event by formula");
  } else if (simulation.method() == methods::reference) {
    ImGui::Text("steps chosen for a tolerance of %.2g", simulation.tolerance());
  } else {
    // Where events are located, how many there are depends on the movement: they are counted.
    const int a_step = simulation.method().evaluations;
    if (cost_is_old_ && (seen_ || a_step == 0)) measure_cost(playback);
    const double rate = a_step == 0 ? counted_per_second_ : a_step / simulation.dt();
    ImGui::Text("%.4g force evaluations per second", rate);
    if (seen_ && !cost_is_old_) {
      ImGui::SameLine();
      ImGui::TextColored(colour(palette::exact), "(%.2g us)",
                         ns_per_step_ / simulation.dt() * 1e-3);
    }
  }
  if (seen_ && simulation.balls() > 1) {
    ImGui::Text("a frame: physics %.1f ms, drawing %.1f ms", 1e3 * frame_cost.physics,
                1e3 * frame_cost.drawing);
  }
  if (playback.pace() < 1) {
    ImGui::Text("computing is too slow: time runs at %.2g x", playback.pace());
  }
  if (const std::optional<StateError> error = simulation.error()) {
    ImGui::Text("position off by %s", with_unit(error->position, "m").c_str());
    const std::string truth(simulation.traits().truth);
    if (truth != "exact") ImGui::Text("(compared with %s)", truth.c_str());
  }
  const std::string warning =
      playback.trouble().empty() ? step_warning(simulation) : playback.trouble();
  if (!warning.empty()) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colour(palette::warning));
    ImGui::BeginChild("warning", {0, 78}, true);
    ImGui::PushTextWrapPos(0);
    ImGui::Text("! %s", warning.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    ImGui::PopStyleColor();
  }
}

}  // namespace bounce
