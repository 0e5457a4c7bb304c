// The window on SDL's dummy driver: keys, mouse and widgets as a user would.

#include "app/window.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "03_damping/exact.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
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
  void press(SDL_Keycode key, SDL_Scancode place = SDL_SCANCODE_UNKNOWN) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = place;
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
  /// Where in the picture the ball can be taken.
  Point place_of_ball() {
    for (float y = 0; y < layout::scene.bottom(); y += 4) {
      for (float x = 0; x < layout::scene.right(); x += 4) {
        if (shown.is_on_ball(window.playback(), window.view(), {x, y})) return {x, y};
      }
    }
    FAIL("there is no ball in the picture");
    return {};
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

TEST_CASE_FIXTURE(Fixture,
                  "keys go by their letter, and by their place where that has no Latin one") {
  frames(2);
  press(0x437, SDL_SCANCODE_P);  // Cyrillic ze
  CHECK(window.playback().paused);
  press(SDLK_p, SDL_SCANCODE_R);  // Dvorak: p is where others have r
  CHECK(!window.playback().paused);
  press(0x439, SDL_SCANCODE_Q);  // Cyrillic short i: nothing has the place of q
  press(0xe9, SDL_SCANCODE_2);   // an accented e on a key of digits
  CHECK(!window.playback().paused);
  CHECK(window.view().tilt_keys == "A D W S");
}

TEST_CASE_FIXTURE(Fixture, "a slider sets the parameter, and the future is drawn while it moves") {
  frames(3);
  const auto damping = [&] {
    return run_as<DampedRun>(window.playback().simulation()).scene().damping;
  };
  const double before = damping();
  // The first slider is where a press in the panel changes the damping.
  float y = layout::panel.y;
  for (; damping() == before && y < layout::panel.bottom(); y += 6) {
    mouse(SDL_MOUSEMOTION, layout::panel.x + 30, y);
    mouse(SDL_MOUSEBUTTONDOWN, layout::panel.x + 30, y);
    mouse(SDL_MOUSEMOTION, layout::panel.x + 40, y);
    if (damping() == before) mouse(SDL_MOUSEBUTTONUP, layout::panel.x + 40, y);
  }
  REQUIRE(damping() != before);
  CHECK(!window.view().future.empty());
  CHECK(!window.view().earlier.empty());
  double last = damping();
  for (float x = 60; x <= 140; x += 20) {  // further to the right is more
    mouse(SDL_MOUSEMOTION, layout::panel.x + x, y);
    CHECK(damping() > last);
    last = damping();
  }
  mouse(SDL_MOUSEMOTION, layout::panel.right() - 1, y);  // and at its end the most there is
  CHECK(damping() ==
        find_parameter(window.playback().simulation().parameters(), "damping").slider.highest);
  mouse(SDL_MOUSEBUTTONUP, layout::panel.right() - 1, y);
  frames(200);
  CHECK(window.view().future.empty());
}

TEST_CASE_FIXTURE(Fixture, "the ball can be dragged and thrown") {
  frames(2);
  window.playback().paused = true;
  const double start = window.playback().simulation().values()[0];
  const auto [x, top] = place_of_ball();
  mouse(SDL_MOUSEMOTION, x, top);
  mouse(SDL_MOUSEBUTTONDOWN, x, top);
  for (float y = top + 6; y < 300; y += 10) mouse(SDL_MOUSEMOTION, x, y);
  for (float y = 300; y > 250; y -= 10) mouse(SDL_MOUSEMOTION, x, y);
  const auto held = window.playback().simulation().values();
  CHECK(held[0] < start - 0.2);
  CHECK(window.playback().shown_values() == held);  // it is seen where it is held
  CHECK(held[1] > 0.5);                             // thrown upwards: 10 px a frame are 1.8 m/s
  CHECK(held[1] <= 8.0);                            // and never faster than the limit
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
  const auto is = [&](Point place, Colour colour) {
    const auto [red, green, blue] = at(static_cast<int>(place.x), static_cast<int>(place.y));
    return red == colour.red && green == colour.green && blue == colour.blue;
  };
  int ball = 0, on_ball = 0, paper = 0, ink = 0;
  for (float y = 0; y < layout::scene.bottom(); ++y) {
    for (float x = 0; x < layout::scene.right(); ++x) {
      const bool inside = shown.is_on_ball(window.playback(), window.view(), {x, y});
      on_ball += inside ? 1 : 0;
      ball += inside && is({x, y}, palette::ball) ? 1 : 0;
      paper += is({x, y}, palette::paper) ? 1 : 0;
      ink += is({x, y}, palette::ink) ? 1 : 0;
    }
  }
  CHECK(on_ball > 100);
  CHECK(ball > on_ball / 2);
  CHECK(paper > layout::scene.width * layout::scene.height / 2);
  CHECK(ink > 100);
}
