#include "app/plots.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "01_free_fall/exact.hpp"
#include "app/playback.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;

namespace {

/// Remembers the words that a picture has, and nothing else.
class WordsOfAPlot final : public Canvas {
 public:
  std::vector<std::string> words;

  void text(Point, std::string_view text, Colour, Align, TextSize) override {
    words.emplace_back(text);
  }
  void fill(std::span<const Point>, Colour) override {}
  void disc(Point, float, Colour) override {}
  void line(std::span<const Point>, Colour, float) override {}
  void circle(Point, float, Colour, float) override {}
  void ball(Point, float, Colour) override {}
  float text_width(std::string_view, TextSize) const override { return 10; }
  void push_clip(Rect) override {}
  void pop_clip() override {}
};

}  // namespace

TEST_CASE("a plot has the step that the clock has just reached, though the clock is rounded") {
  auto run = std::make_unique<OneBallRun<FreeFall, FreeFallExact>>();
  run->use_dt(0.1);
  Playback playback(std::move(run));
  for (int i = 0; i < 18; ++i) playback.frame(0.05);  // as a web page runs to 0.9 s
  REQUIRE(playback.shown_time() < playback.simulation().time());
  REQUIRE(playback.shown_time() == doctest::Approx(0.9).epsilon(1e-9));

  WordsOfAPlot canvas;
  PlotView().draw(canvas, {0, 0, 400, 180}, plot_column("velocity", "m/s", "v"), playback);
  // After 9 steps v = -9.81 * 0.9 = -8.829.
  INFO("the last step, and not the one before: -7.85");
  CHECK(std::find(canvas.words.begin(), canvas.words.end(), "-8.83") != canvas.words.end());
}
