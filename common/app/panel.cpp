#include "app/panel.hpp"

#include <SDL.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"

namespace bounce {
namespace {

constexpr double future_length = 3;    // s drawn ahead while a slider moves
constexpr int future_lingers = 150;    // frames after the slider was let go
constexpr Range dt_slider{1e-5, 0.1};  // s

ImVec4 colour(Colour c) {
  return {static_cast<float>(c.red) / 255, static_cast<float>(c.green) / 255,
          static_cast<float>(c.blue) / 255, static_cast<float>(c.alpha) / 255};
}

bool slide(const char* name, double& value, Range range) {
  const bool logarithmic = range.lowest > 0 && range.highest >= 50 * range.lowest;
  return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &range.lowest, &range.highest,
                             "%.5g", logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

void heading(const char* words) {
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::TextColored(colour(palette::exact), "%s", words);
}

}  // namespace

Panel::Panel(const Demo& demo, bool seen) : demo_(demo), seen_(seen), fresh_(demo.make()) {
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.FrameRounding = style.GrabRounding = 4;
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 7};
  style.AntiAliasedLinesUseTex = false;  // SDL's software renderer draws such lines broken
  style.WindowBorderSize = 1;
  style.FrameBorderSize = 1;
  style.Colors[ImGuiCol_WindowBg] = {1, 1, 1, 1};
  style.Colors[ImGuiCol_Text] = colour(palette::ink);
  style.Colors[ImGuiCol_Border] = colour(palette::grid_major);
  style.Colors[ImGuiCol_SliderGrab] = colour(palette::motion);
  style.Colors[ImGuiCol_SliderGrabActive] = colour(palette::motion);
  style.Colors[ImGuiCol_CheckMark] = colour(palette::motion);
  style.Colors[ImGuiCol_FrameBg] = colour(palette::grid_minor);
}

void Panel::draw(Player& player, View& view) {
  ImGui::SetNextWindowPos({layout::panel.x, layout::panel.y});
  ImGui::SetNextWindowSize({layout::panel.width, layout::panel.height});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  ImGui::TextColored(colour(palette::exact), "%s", demo_.title.c_str());
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(demo_.question.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();

  ImGui::PushItemWidth(226);
  ++frames_since_slider_;
  for (const Dial& dial : demo_.dials) draw_dial(player, view, dial);
  draw_parameters(player, view, true);
  draw_play_row(player);
  draw_method(player, view);
  draw_cost_and_error(player);

  heading("see");
  ImGui::Checkbox("arrows", &view.forces);
  ImGui::SameLine();
  ImGui::Checkbox("exact", &view.ghost);
  ImGui::SameLine();
  ImGui::Checkbox("trail", &view.trail);
  ImGui::SameLine();
  ImGui::Checkbox("lens (L)", &player.contact_lens);
  if (ImGui::Button("copy command") && seen_) SDL_SetClipboardText(command(player).c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", command(player).c_str());
  ImGui::SameLine();
  if (ImGui::Button("keys (F1)")) view.help = !view.help;
  if (ImGui::CollapsingHeader("more parameters")) draw_parameters(player, view, false);
  ImGui::PopItemWidth();
  draw_keys();
  ImGui::End();

  if (frames_since_slider_ < future_lingers) {
    view.future = player.future(future_length);
  } else {
    view.future.clear();
    view.earlier.clear();
  }
}

void Panel::draw_parameters(Player& player, View& view, bool main_ones) {
  const std::vector<Parameter> parameters = player.simulation().parameters();
  if (main_ones) {
    for (const std::string& name : demo_.sliders) {
      draw_parameter(player, view, find_parameter(parameters, name));
    }
    return;
  }
  for (const Parameter& parameter : parameters) {
    const auto& main = demo_.sliders;
    if (std::find(main.begin(), main.end(), parameter.name) == main.end()) {
      draw_parameter(player, view, parameter);
    }
  }
}

void Panel::draw_parameter(Player& player, View& view, const Parameter& parameter) {
  const auto apply = [&](const std::string& text) {
    player.change(
        [&](Simulation& simulation) {
          const std::vector<Parameter> all = simulation.parameters();
          const Parameter& changed = find_parameter(all, parameter.name);
          if (demo_.set) {
            demo_.set(simulation, changed, text);
          } else {
            changed.set(text);
          }
        },
        parameter.is_start);
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
    note_slider(player, view);
    ImGui::SameLine();
    ImGui::TextColored(colour(palette::exact), "%s", parameter.unit.c_str());
  } else {
    double value = **std::get_if<double*>(&parameter.value);
    const bool moved = slide(parameter.name.c_str(), value, parameter.slider);
    if (parameter.is_whole) value = std::round(value);
    if (moved && parameter.allows({&value, 1})) apply(to_text(value));
    note_slider(player, view);
    ImGui::SameLine();
    ImGui::TextColored(colour(palette::exact), "%s", parameter.unit.c_str());
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", parameter.meaning.c_str());
}

void Panel::draw_dial(Player& player, View& view, const Dial& dial) {
  double value = dial.get(player.simulation());
  if (slide(dial.name.c_str(), value, dial.range) && std::isfinite(value)) {
    player.change([&](Simulation& simulation) { dial.set(simulation, value); });
  }
  note_slider(player, view);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "%s", dial.unit.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", dial.meaning.c_str());
}

void Panel::draw_keys() {
  const float bottom = layout::panel.height - 50;
  if (ImGui::GetCursorPosY() > bottom) return;  // "more" is open and needs the room
  ImGui::SetCursorPosY(bottom);
  ImGui::TextColored(colour(palette::exact),
                     "P pause   . , step   R restart   O slow   L lens\n"
                     "%s   E errors   F1 all keys   Esc quit   mouse: throw",
                     demo_.in_space ? "T from above" : "F12 picture");
}

/// When a slider is taken, what would have happened is kept for comparison; while it moves, what
/// would happen now is drawn.
void Panel::note_slider(Player& player, View& view) {
  if (ImGui::IsItemActivated()) view.earlier = player.future(future_length);
  if (ImGui::IsItemActive()) frames_since_slider_ = 0;
}

void Panel::draw_play_row(Player& player) {
  heading("play");
  if (ImGui::Button(player.paused ? "play (P)" : "pause (P)", {96, 0}))
    player.paused = !player.paused;
  ImGui::SameLine();
  if (ImGui::Button("<")) player.step_back();
  ImGui::SameLine();
  if (ImGui::Button(">")) player.step_forward();
  ImGui::SameLine();
  if (ImGui::Button("restart (R)")) player.restart();
  ImGui::SameLine();
  bool slow = player.rate < 1;
  if (ImGui::Checkbox("slow (O)", &slow)) player.rate = slow ? 0.1 : 1;

  // Scrub: drag back into the last minute; it plays on from there.
  const double now = player.simulation().time();
  double wanted = now;
  const double earliest = player.earliest(), latest = std::max(now, earliest + 1e-9);
  if (ImGui::SliderScalar("time", ImGuiDataType_Double, &wanted, &earliest, &latest, "%.3f s") &&
      wanted < now) {
    player.go_back_to(wanted);
  }
  char rate[48] = "";
  const double pace = player.current_rate() * player.pace();
  if (pace != 1) std::snprintf(rate, sizeof rate, "%.2g x", pace);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "%s", rate);
}

void Panel::draw_method(Player& player, View& view) {
  heading("method");
  Simulation& simulation = player.simulation();
  if (ImGui::BeginCombo("##method", name_of(simulation.method()).c_str())) {
    for (const Method method : simulation.methods()) {
      if (!ImGui::Selectable(name_of(method).c_str(), method == simulation.method())) continue;
      player.change([method](Simulation& s) { s.use_method(method); });
      cost_is_old_ = true;
    }
    ImGui::EndCombo();
  }
  if (simulation.method().goes_by_events) return;
  double dt = simulation.dt();
  if (slide("dt", dt, dt_slider) && dt > 0) player.change([dt](Simulation& s) { s.use_dt(dt); });
  note_slider(player, view);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "s");
}

void Panel::measure_cost(const Player& player) {
  const std::unique_ptr<Simulation> copy = player.simulation().clone();
  copy->keep_energy_book(false);
  const double steps = std::max(10.0, 20000 / static_cast<double>(copy->balls()));
  const auto begin = std::chrono::steady_clock::now();
  try {
    copy->advance_to(copy->time() + steps * copy->dt());
  } catch (const std::exception&) {
    return;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  ns_per_step_ = taken.count() / steps * 1e9;
  counted_per_second_ = static_cast<double>(copy->counted_force_evaluations() -
                                            player.simulation().counted_force_evaluations()) /
                        (copy->time() - player.simulation().time());
  cost_is_old_ = false;
}

void Panel::draw_cost_and_error(Player& player) {
  heading("cost and error, now");
  const Simulation& simulation = player.simulation();
  if (simulation.method() == methods::exact) {
    ImGui::Text("no steps: from event to event by formula");
  } else if (simulation.method() == methods::reference) {
    ImGui::Text("steps chosen for a tolerance of %.2g", simulation.tolerance());
  } else {
    // Where events are located, how many there are depends on the movement: they are counted.
    const int a_step = simulation.method().evaluations;
    if (cost_is_old_ && (seen_ || a_step == 0)) measure_cost(player);
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
  if (player.pace() < 1) {
    ImGui::Text("computing is too slow: time runs at %.2g x", player.pace());
  }
  if (const std::optional<StateError> error = simulation.error()) {
    ImGui::Text("position off by %s", with_unit(error->position, "m").c_str());
  }
  const std::string warning =
      player.trouble().empty() ? step_warning(simulation) : player.trouble();
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

std::string Panel::command(Player& player) {
  return command_for(demo_.stage, player.simulation(), *fresh_);
}

}  // namespace bounce
