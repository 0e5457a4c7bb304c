#include "app/panel.hpp"

#include <SDL.h>

#include <algorithm>
#include <cstdio>

#include "app/layout.hpp"
#include "app/widgets.hpp"

namespace bounce {
namespace {

constexpr int future_lingers = 150;    // frames after the slider was let go
constexpr Range dt_slider{1e-5, 0.1};  // s

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

void Panel::draw(Playback& playback, View& view) {
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
  for (const Dial& dial : demo_.dials) draw_dial(playback, view, dial);
  draw_parameters(playback, view, true);
  draw_play_row(playback);
  draw_method(playback, view);
  draw_cost_and_error(playback);

  heading("see");
  ImGui::Checkbox("arrows", &view.forces);
  ImGui::SameLine();
  const std::string_view truth = playback.simulation().traits().truth;
  ImGui::Checkbox(std::string(truth.substr(0, truth.find(','))).c_str(), &view.ghost);
  ImGui::SameLine();
  ImGui::Checkbox("trail", &view.trail);
  ImGui::SameLine();
  ImGui::Checkbox("lens (L)", &playback.contact_lens);
  if (demo_.survey.draw) {
    ImGui::Checkbox(("every " + demo_.survey.parameter + " (B)").c_str(), &view.survey);
    ImGui::SameLine();
    ImGui::Checkbox("section (N)", &view.section);
  }
  const auto command = [&] { return command_for(demo_.stage, playback.simulation(), *fresh_); };
  if (ImGui::Button("copy command") && seen_) SDL_SetClipboardText(command().c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", command().c_str());
  ImGui::SameLine();
  if (ImGui::Button("keys (F1)")) view.help = !view.help;
  if (ImGui::CollapsingHeader("more parameters")) draw_parameters(playback, view, false);
  ImGui::PopItemWidth();
  draw_keys();
  ImGui::End();

  if (frames_since_slider_ < future_lingers) {
    view.future = playback.future(future_length);
  } else {
    view.future.clear();
    view.earlier.clear();
  }
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

void Panel::draw_play_row(Playback& playback) {
  heading("play");
  if (ImGui::Button(playback.paused ? "play (P)" : "pause (P)", {96, 0}))
    playback.paused = !playback.paused;
  ImGui::SameLine();
  if (ImGui::Button("<")) playback.step_back();
  ImGui::SameLine();
  if (ImGui::Button(">")) playback.step_forward();
  ImGui::SameLine();
  if (ImGui::Button("restart (R)")) playback.restart();
  ImGui::SameLine();
  bool slow = playback.rate < 1;
  if (ImGui::Checkbox("slow (O)", &slow)) playback.rate = slow ? 0.1 : 1;

  // Scrub: drag back into the last minute; it plays on from there.
  const double now = playback.simulation().time();
  double wanted = now;
  const double earliest = playback.earliest(), latest = std::max(now, earliest + 1e-9);
  if (ImGui::SliderScalar("time", ImGuiDataType_Double, &wanted, &earliest, &latest, "%.3f s") &&
      wanted < now) {
    playback.go_back_to(wanted);
  }
  char rate[48] = "";
  const double pace = playback.current_rate() * playback.pace();
  if (pace != 1) std::snprintf(rate, sizeof rate, "%.2g x", pace);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "%s", rate);
}

void Panel::draw_method(Playback& playback, View& view) {
  heading("method");
  Simulation& simulation = playback.simulation();
  if (ImGui::BeginCombo("##method", name_of(simulation.method()).c_str())) {
    for (const Method method : simulation.methods()) {
      if (!ImGui::Selectable(name_of(method).c_str(), method == simulation.method())) continue;
      playback.change([method](Simulation& s) { s.use_method(method); });
      cost_is_old_ = true;
    }
    ImGui::EndCombo();
  }
  if (simulation.method().goes_by_events) return;
  double dt = simulation.dt();
  if (slide("dt", dt, dt_slider) && dt > 0) playback.change([dt](Simulation& s) { s.use_dt(dt); });
  note_slider(playback, view);
  ImGui::SameLine();
  ImGui::TextColored(colour(palette::exact), "s");
}

}  // namespace bounce
