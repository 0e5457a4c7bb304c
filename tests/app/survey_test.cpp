// The bifurcation picture and the Poincare section of stage 6, in a window that nobody sees.
#include <doctest/doctest.h>

#include <cmath>

#include "06_oscillating_floor/picture/survey.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "app/layout.hpp"
#include "app/side_view.hpp"
#include "app/survey.hpp"
#include "app/window.hpp"

using namespace bounce;

namespace {

using Its = OneBallRun<OscillatingFloor, OscillatingFloorExact>;

Demo shaken_demo() {
  Demo demo = side_demo<OscillatingFloor, OscillatingFloorExact>();
  demo.stage = {"06_oscillating_floor", "test"};
  demo.sliders = {"amplitude"};
  demo.set = set_without_jump;
  demo.survey = amplitude_survey();
  return demo;
}

/// The centres of what is drawn in one colour.
class Marks final : public Canvas {
 public:
  explicit Marks(Colour colour) : colour_(colour) {}
  std::vector<Point> rects, discs;

  void fill(std::span<const Point> corners, Colour colour) override {
    if (!is_mine(colour)) return;
    rects.push_back({(corners[0].x + corners[2].x) / 2, (corners[0].y + corners[2].y) / 2});
  }
  void disc(Point centre, float, Colour colour) override {
    if (is_mine(colour)) discs.push_back(centre);
  }
  void line(std::span<const Point>, Colour, float) override {}
  void circle(Point, float, Colour, float) override {}
  void text(Point, std::string_view, Colour, Align, TextSize) override {}
  void ball(Point, float, Colour) override {}
  float text_width(std::string_view, TextSize) const override { return 10; }
  void push_clip(Rect) override {}
  void pop_clip() override {}

 private:
  bool is_mine(Colour c) const {
    return c.red == colour_.red && c.green == colour_.green && c.blue == colour_.blue;
  }
  Colour colour_;
};

double amplitude(const Playback& playback) {
  return run_as<Its>(playback.simulation()).scene().amplitude;
}

}  // namespace

TEST_CASE("B keeps the survey in the picture, and a click on it goes to that amplitude") {
  Demo demo = shaken_demo();
  Window window(demo, std::make_unique<Its>(), {}, false);
  const auto send = [&](SDL_Event event) {
    SDL_PushEvent(&event);
    window.tick(1.0 / 60);
  };
  const auto press = [&](SDL_Keycode key) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    send(event);
  };
  const auto click = [&](int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEBUTTONDOWN;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.x = x;
    event.button.y = y;
    send(event);
    event.type = SDL_MOUSEBUTTONUP;
    send(event);
  };
  const auto scene = [&] { return run_as<Its>(window.playback().simulation()).scene(); };

  click(400, 640);
  CHECK(amplitude(window.playback()) == 0.06);  // there is no survey yet
  press(SDLK_b);
  CHECK(shows_survey(demo, window.view()));
  for (int i = 0; i < 20; ++i) window.tick(1.0 / 60);
  for (const bool section : {false, true}) {
    if (section) press(SDLK_n);
    const Rect area = survey_area(demo, window.view());
    const int x = static_cast<int>(area.x + area.width / 2);
    const double t = window.playback().simulation().time();
    const double height = scene().floor_height(t);
    click(x, 640);
    const double wanted = *demo.survey.value_at(area, {static_cast<float>(x), 640});
    CHECK(amplitude(window.playback()) == wanted);
    CHECK(wanted > 0.065);
    CHECK(wanted < 0.085);
    // As by the slider, the floor does not jump; three frames later it has moved by 3 A w / 60 at
    // most.
    const double now = window.playback().simulation().time();
    CHECK(std::abs(scene().floor_height(now) - height) < 0.085 * 12.6 * 3 / 60 + 1e-9);
  }
  click(200, 100);  // beside it
  press(SDLK_b);
  press(SDLK_n);
  CHECK(!shows_survey(demo, window.view()));
  CHECK(!shows_section(demo, window.view()));
  CHECK(survey_area(demo, window.view()).width == layout::plots[0].width + layout::plots[1].width);
}

TEST_CASE("a demo without a survey has no B and no N") {
  Demo demo = shaken_demo();
  demo.survey = {};
  Playback playback(demo.make());
  View view;
  Controls controls;
  CHECK(!press('b', demo, playback, view, controls));
  CHECK(!press('n', demo, playback, view, controls));
  CHECK(!view.survey);
  CHECK(!view.section);
  CHECK(!choose_from_survey(demo, view, playback, {400, 640}));
}

TEST_CASE("the bifurcation picture: a little at a time, and anew when something else changes") {
  Demo demo = shaken_demo();
  Playback playback(demo.make());
  LiveBifurcation slow, at_once;
  int frames = 1;
  while (!slow.work(playback.simulation(), 0)) ++frames;
  // Without any time, a frame computes as few columns as can be computed at a time.
  CHECK(frames == LiveBifurcation::columns / static_cast<int>(lanes));
  CHECK(at_once.work(playback.simulation(), 1e9));
  const Rect area{0, 540, 840, 180};
  Marks slowly(palette::motion), whole(palette::motion);
  slow.draw(slowly, area, playback.simulation());
  at_once.draw(whole, area, playback.simulation());
  REQUIRE(slowly.rects.size() == whole.rects.size());
  const auto marks_near = [&](double wanted) {
    int found = 0;
    for (const Point& mark : whole.rects) {
      const auto at = LiveBifurcation::amplitude_at(area, mark);
      found += at && std::abs(*at - wanted) < 0.15 / 399 / 2;
    }
    return found;
  };
  // One height, two, and no order any more; below 25 mm the ball comes to rest.
  CHECK(marks_near(0.05) == 1);
  CHECK(marks_near(0.0722) == 2);
  CHECK(marks_near(0.12) > 20);
  CHECK(marks_near(0.01) == 0);

  set_parameter(demo, playback, "amplitude", "0.09");  // this takes the phase along
  CHECK(slow.work(playback.simulation(), 0));
  set_parameter(demo, playback, "angular_frequency", "14");
  CHECK(!slow.work(playback.simulation(), 0));
}

TEST_CASE("the Poincare section: the run's touches come to lie on the exact ball's") {
  Demo demo = shaken_demo();
  Playback playback(demo.make());
  set_parameter(demo, playback, "amplitude", "0.05");
  playback.change([](Simulation& s) { s.use_method(methods::exact); });
  TouchSection section;
  const Rect area{420, 540, 420, 180};
  Marks run(palette::motion), exact(palette::exact);
  for (int i = 0; i < 60 * 40; ++i) {
    playback.frame(1.0 / 60);
    Marks each(palette::motion);
    section.draw(each, area, playback);
  }
  section.draw(run, area, playback);
  section.draw(exact, area, playback);
  REQUIRE(run.discs.size() == 1);
  // Two touches a second, in 40 s; half a minute is time enough to settle.
  CHECK(run.rects.size() > 70);
  CHECK(run.rects.size() < 90);
  REQUIRE(!exact.rects.empty());
  CHECK(std::abs(run.discs[0].x - exact.rects[0].x) < 0.5f);
  CHECK(std::abs(run.discs[0].y - exact.rects[0].y) < 0.5f);
}
