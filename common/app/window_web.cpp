// The app in a web page, behind the same header as window.cpp: pictures go to a <canvas>, and
// sliders, buttons and keys are the page's own (docs/site/live/stage.js), which calls the functions
// at the end. No SDL, no Dear ImGui, no files.
#include <emscripten.h>

#include "app/kept_number.hpp"
#include "app/layout.hpp"
#include "app/page.hpp"
#include "app/page_calls.hpp"
#include "app/survey.hpp"

// clang-format off
EM_JS(int, page_kept, (const char* name), { return Module.kept(UTF8ToString(name)); });
EM_JS(void, page_keep, (const char* name, int number), { Module.keep(UTF8ToString(name), number); });
// clang-format on

namespace bounce {
namespace {

constexpr double future_length = 3;  // s drawn ahead while a slider moves
constexpr int future_lingers = 150;  // frames after it was let go

std::unique_ptr<Page> page;
std::string answer;
std::vector<double> rows;

}  // namespace

int kept_number(const std::string& name) { return page_kept(name.c_str()); }
void keep_number(const std::string& name, int number) { page_keep(name.c_str(), number); }

int play_demo(int argc, const char* const* argv, const Demo& demo) {
  const std::string refused = guard(answer, [&] {
    std::unique_ptr<Simulation> simulation = set_up(argc, argv, demo);  // may change demo.bare
    page = std::make_unique<Page>(Page{demo, Playback(std::move(simulation)), demo.make()});
    page->playback.paused = true;
    page->view.in_page = true;
  });
  return refused.empty() ? exit_ok : exit_input;
}

}  // namespace bounce

using namespace bounce;

extern "C" {

/// Why there is no page, as a sentence.
EMSCRIPTEN_KEEPALIVE const char* page_refusal() { return page ? "" : answer.c_str(); }
EMSCRIPTEN_KEEPALIVE const char* page_about() {
  Page& p = *page;
  return (answer = about_page(p.demo, p.playback.simulation(), *p.fresh)).c_str();
}
EMSCRIPTEN_KEEPALIVE const char* page_state() { return (answer = state_of_page(*page)).c_str(); }

/// One frame: what hands do, then `seconds` of movement. Draws nothing.
EMSCRIPTEN_KEEPALIVE void page_move(double seconds) {
  Page& p = *page;
  p.clock += seconds;
  p.held.follow(p.demo, p.playback, p.view, p.clock, p.controls.mouse);
  if (is_game(p.demo)) {
    p.controls.seconds = seconds;
    p.demo.control(p.playback, p.view, p.controls);
    p.controls.begin_frame();
  }
  if (!p.held.is_held()) p.playback.frame(seconds);
  if (p.demo.is_over && p.demo.is_over(p.playback)) p.playback.restart();
  if (p.future_frames > 0 && !p.playback.paused) --p.future_frames;
  if (p.future_frames == 0) p.view.earlier.clear();
  p.view.future = p.future_frames > 0 ? p.playback.future(future_length) : p.view.earlier;
}

/// A part of the picture: 0 the scene, 1 the energy, 2 and 3 the plots, 4 the chart of errors, 5
/// the survey. Each is drawn where it stands in the window (layout.hpp).
EMSCRIPTEN_KEEPALIVE void page_draw(int part) {
  Page& p = *page;
  if (part == 0) p.demo.picture(p.playback, p.view, p.canvas);
  if (part == 1) draw_energy_column(p.canvas, layout::energy, p.playback.trace().back());
  if (part == 3 && shows_section(p.demo, p.view)) {
    p.demo.survey.section(p.canvas, layout::plots[1], p.playback);
  } else if (part == 2 || part == 3) {
    const auto i = static_cast<std::size_t>(part - 2);
    if (i < p.demo.plots.size())
      p.plots[i].draw(p.canvas, layout::plots[i], p.demo.plots[i], p.playback);
  }
  if (part == 4) {
    const Simulation& simulation = p.playback.simulation();
    p.chart.follow(simulation, 15);
    p.chart.work(0.004);
    draw_error_chart(p.canvas, layout::chart, p.chart, simulation.method(), simulation.dt());
  }
  if (part == 5) {
    p.survey_is_done = p.demo.survey.work(p.playback.simulation(), 0.004);
    p.demo.survey.draw(p.canvas, survey_area(p.demo, p.view), p.playback.simulation());
  }
}

/// What a slider, a text field or a choice sets: a parameter or a dial.
EMSCRIPTEN_KEEPALIVE const char* page_set(const char* name, const char* text) {
  return guard(answer, [&] {
    Page& p = *page;
    if (p.future_frames == 0) p.view.earlier = p.playback.future(future_length);
    p.future_frames = future_lingers;
    if (!is_dial(p.demo, name)) return set_parameter(p.demo, p.playback, name, text);
    p.playback.change([&](Simulation& simulation) { set_dial(p.demo, simulation, name, text); });
  });
}
EMSCRIPTEN_KEEPALIVE const char* page_method(const char* name, double dt) {
  return guard(answer, [&] {
    page->playback.change([&](Simulation& simulation) {
      simulation.use_method(find_method(name, simulation.methods()));
      simulation.use_dt(dt);
    });
  });
}
EMSCRIPTEN_KEEPALIVE void page_see(const char* what, int on) {
  View& view = page->view;
  const std::string name = what;
  if (name == "forces") view.forces = on != 0;
  if (name == "exact") view.ghost = on != 0;
  if (name == "trail") view.trail = on != 0;
  if (name == "survey") view.survey = on != 0;
  if (name == "narrow") view.narrow = on != 0;
  if (name == "section") view.section = on != 0;
  if (name == "calm") view.calm = on != 0;
}
/// How large the picture of a game is.
EMSCRIPTEN_KEEPALIVE void page_size(float width, float height) {
  page->view.whole = {0, 0, width, height};
}
EMSCRIPTEN_KEEPALIVE int page_press(int key) {
  Page& p = *page;
  const bool used = press(static_cast<char>(key), p.demo, p.playback, p.view, p.controls);
  p.controls.any = p.controls.any || !used;
  return used ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void page_go_back(double t) { page->playback.go_back_to(t); }

/// The pointer, where the window has it: 0 it moved, 1 it went down, 2 up. Returns whether it is
/// used there.
EMSCRIPTEN_KEEPALIVE int page_pointer(int kind, float x, float y) {
  Page& p = *page;
  const Point at{x, y};
  p.controls.mouse = at;
  p.controls.mouse_moved = true;
  if (kind == 1) {
    p.controls.button = p.controls.any = true;
    if (!choose_from_chart(p.demo, p.view, p.chart, p.playback, at) &&
        !choose_from_survey(p.demo, p.view, p.playback, at)) {
      p.held.take(p.demo, p.playback, p.view, at);
    }
  }
  if (kind == 2) {
    p.controls.button = false;
    p.held.let_go();
  }
  return p.held.is_held() || is_game(p.demo) ? 1 : 0;
}
/// The keys that are down, for a game.
EMSCRIPTEN_KEEPALIVE void page_hold(int keys_down) {
  Controls& c = page->controls;
  bool* const held[] = {&c.left, &c.right, &c.up, &c.down, &c.space, &c.a, &c.d, &c.w, &c.s};
  for (std::size_t i = 0; i < std::size(held); ++i) {
    const bool down = (keys_down >> i & 1) != 0;
    c.any = c.any || (down && !*held[i]);
    *held[i] = down;
  }
}
/// The speed [m/s] of a hit that is new, or 0.
EMSCRIPTEN_KEEPALIVE double page_knock() {
  Page& p = *page;
  if (!p.demo.knock) return 0;
  const Knock knock = p.demo.knock(p.playback);
  const bool is_new = knock.count > p.knocks && !p.view.muted;
  p.knocks = knock.count;
  return is_new ? knock.speed : 0;
}

/// A run by itself (page_calls.hpp). Returns how many numbers there are; page_rows says where.
EMSCRIPTEN_KEEPALIVE int page_path(double seconds, int count, int with_exact) {
  guard(answer,
        [&] { run_path(page->playback.simulation(), seconds, count, with_exact != 0, rows); });
  return static_cast<int>(rows.size());
}
/// The page's own run, as a test drives it: on to the time t; then all that its next step needs.
EMSCRIPTEN_KEEPALIVE int page_values(double t) {
  guard(answer, [&] { page->playback.simulation().advance_to(t); });
  rows = page->playback.simulation().values();
  return static_cast<int>(rows.size());
}
EMSCRIPTEN_KEEPALIVE int page_memory() {
  rows = page->playback.simulation().memory().numbers;
  return static_cast<int>(rows.size());
}
EMSCRIPTEN_KEEPALIVE const double* page_rows() { return rows.data(); }
EMSCRIPTEN_KEEPALIVE const char* page_answer() { return answer.c_str(); }
}
