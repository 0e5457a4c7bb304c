// The window on SDL's dummy driver: keys, mouse and widgets as a user would.

#include "app/window.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <ctime>

#include "03_damping/exact.hpp"
#include "app/layout.hpp"
#include "app/side_view.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;

namespace {

using DampedRun = OneBallRun<Damping, DampingExact>;

Demo demo() {
  Demo demo = side_demo<Damping, DampingExact>();
  demo.stage = {"03_damping", "test"};
  demo.title = "test";
  demo.question = "The first line of two,\nand the second";
  demo.sliders = {"damping", "stiffness", "contact"};
  return demo;
}

struct Fixture {
  Demo shown = demo();
  Options options;
  Window window{shown, std::make_unique<DampedRun>(), options, false};

  void frames(int count) {
    for (int i = 0; i < count; ++i) window.tick(1.0 / 60);
  }
  void press(SDL_Keycode key) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    SDL_PushEvent(&event);
    frames(1);
  }
  void mouse(Uint32 type, float x, float y) {
    SDL_Event event{};
    event.type = type;
    if (type == SDL_MOUSEMOTION) {
      event.motion.x = static_cast<int>(x);
      event.motion.y = static_cast<int>(y);
    } else {
      event.button.button = SDL_BUTTON_LEFT;
      event.button.x = static_cast<int>(x);
      event.button.y = static_cast<int>(y);
    }
    SDL_PushEvent(&event);
    frames(1);
  }
};

}  // namespace

TEST_CASE_FIXTURE(Fixture, "keys: pause, step, back, slow, lens, restart, help, quit") {
  frames(10);
  press(SDLK_p);
  CHECK(window.playback().paused);
  const double t = window.playback().simulation().time();
  press(SDLK_PERIOD);
  CHECK(window.playback().simulation().time() == doctest::Approx(t + 1e-3));
  press(SDLK_COMMA);
  CHECK(window.playback().simulation().time() == doctest::Approx(t));
  press(SDLK_SPACE);
  CHECK(!window.playback().paused);
  press(SDLK_o);
  CHECK(window.playback().rate == 0.1);
  press(SDLK_l);
  CHECK(window.playback().contact_lens);
  press(SDLK_F1);
  CHECK(window.view().help);
  press(SDLK_r);
  CHECK(window.playback().simulation().time() < 0.02);
  SDL_Event quit{};
  quit.type = SDL_KEYDOWN;
  quit.key.keysym.sym = SDLK_ESCAPE;
  SDL_PushEvent(&quit);
  CHECK(!window.tick(1.0 / 60));
}

TEST_CASE_FIXTURE(Fixture, "a slider sets the parameter, and the future is drawn while it moves") {
  frames(3);
  // The first slider (damping) is about 96 px below the panel's top.
  const float y = 97;
  mouse(SDL_MOUSEMOTION, layout::panel.x + 30, y);
  mouse(SDL_MOUSEBUTTONDOWN, layout::panel.x + 30, y);
  for (float x = 40; x <= 140; x += 20) mouse(SDL_MOUSEMOTION, layout::panel.x + x, y);
  CHECK(!window.view().future.empty());
  CHECK(!window.view().earlier.empty());
  mouse(SDL_MOUSEBUTTONUP, layout::panel.x + 140, y);
  const auto& run = static_cast<const DampedRun&>(window.playback().simulation());
  CHECK(run.scene().damping > 100);
  CHECK(run.scene().damping < 200);
  frames(200);
  CHECK(window.view().future.empty());
}

TEST_CASE_FIXTURE(Fixture, "the ball can be dragged and thrown") {
  frames(2);
  window.playback().paused = true;
  // The ball starts at 1 m, a fifth from the top of the scene, at 60 % of its width.
  const float x = layout::scene.width * 0.6f;
  const double start = window.playback().simulation().values()[0];
  mouse(SDL_MOUSEMOTION, x, 124);
  mouse(SDL_MOUSEBUTTONDOWN, x, 124);
  for (float y = 130; y < 300; y += 10) mouse(SDL_MOUSEMOTION, x, y);
  for (float y = 300; y > 250; y -= 10) mouse(SDL_MOUSEMOTION, x, y);
  const auto held = window.playback().simulation().values();
  CHECK(held[0] < start - 0.2);
  CHECK(held[1] > 0.5);   // thrown upwards: 10 px a frame are 1.8 m/s
  CHECK(held[1] <= 8.0);  // and never faster than the limit
  mouse(SDL_MOUSEBUTTONUP, x, 250);
  CHECK(window.playback().simulation().error()->position < 1e-9);  // the comparison starts here
}

TEST_CASE_FIXTURE(Fixture, "E shows speed against error, and a click on a dot chooses it") {
  press(SDLK_e);
  CHECK(window.view().chart);
  frames(2);
  ErrorChart chart;  // the same as the window's, to know where the dots are
  chart.follow(window.playback().simulation(), 0);
  chart.work(1e9);
  const Simulation& now = window.playback().simulation();
  int dots = 0;
  for (const ErrorChart::Dot& wanted : chart.dots()) {
    if (wanted.method != methods::flight_rk4) continue;  // whose curve lies apart from the others
    CAPTURE(wanted.dt);
    const Rect area = layout::chart;
    bool found = false;
    for (float y = area.y; y < area.bottom() && !found; y += 3) {
      for (float x = area.x; x < area.right() && !found; x += 3) {
        const auto at = error_chart_choice(area, chart, {x, y});
        if (!at || at->method != wanted.method || at->dt != wanted.dt) continue;
        found = true;
        mouse(SDL_MOUSEBUTTONDOWN, x, y);
        mouse(SDL_MOUSEBUTTONUP, x, y);
      }
    }
    CHECK(found);
    CHECK(now.method() == wanted.method);
    CHECK(now.dt() == wanted.dt);
    ++dots;
  }
  CHECK(dots == 6);
  // The name of the exact solution is the last one, and it has no steps.
  for (float y = layout::chart.y; y < layout::chart.bottom() && now.method() != methods::exact;
       y += 5) {
    const auto at = error_chart_choice(layout::chart, chart, {layout::chart.x + 200, y});
    if (!at || at->method != methods::exact) continue;
    mouse(SDL_MOUSEBUTTONDOWN, layout::chart.x + 200, y);
    mouse(SDL_MOUSEBUTTONUP, layout::chart.x + 200, y);
  }
  CHECK(now.method() == methods::exact);
  press(SDLK_e);
  CHECK(!window.view().chart);
}

TEST_CASE_FIXTURE(Fixture,
                  "a frame is cheap enough for 30 frames a second in the software renderer") {
  frames(120);                              // with a trail
  const std::clock_t begin = std::clock();  // of the processor: other programs do not count
  frames(60);
  const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  MESSAGE("ms per frame: ", spent / 60 * 1000);
#if defined(NDEBUG)
  CHECK(spent / 60 < 1.0 / 30);
#endif
}

TEST_CASE_FIXTURE(Fixture, "the picture has ink, ball and paper in it") {
  window.keep_pixels = true;
  frames(3);
  const Pixels pixels = window.pixels();
  CHECK(pixels.width == layout::width);
  const auto at = [&](int x, int y) {
    const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                           static_cast<std::size_t>(x)) *
                          3;
    return std::array<int, 3>{pixels.rgb[i], pixels.rgb[i + 1], pixels.rgb[i + 2]};
  };
  CHECK(at(700, 60) == std::array<int, 3>{0xFA, 0xFA, 0xF7});        // paper
  CHECK(at(448 - 20, 124) == std::array<int, 3>{0xE4, 0xE8, 0xEC});  // the ball, beside its mark
}
