#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "app/demo.hpp"
#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/palette.hpp"

namespace bounce {

/// The heights of settled bounces for every amplitude that the slider has, computed a little at a
/// time: first some columns all over the picture, then those in between.
class LiveBifurcation {
 public:
  static constexpr int columns = 400, discarded = 200, kept = 100;

  /// Goes on for so long [s], or begins anew when anything but the amplitude has changed (and the
  /// phase, which a slider takes along). Returns whether it has come to the end.
  bool work(const Simulation& simulation, double seconds) {
    const double begin = Playback::wall_clock();
    OscillatingFloor scene = run_as<OscillatingFloorRun>(simulation).scene();
    scene.amplitude = scene.phase = 0;
    std::vector<std::string> settings;
    for (const Parameter& parameter : scene.parameters()) settings.push_back(parameter.text());
    if (settings != settings_) {
      *this = LiveBifurcation{};
      settings_ = settings;
      scene_ = scene;
    }
    while (done_ < columns) {
      compute();
      if (Playback::wall_clock() - begin > seconds) break;
    }
    return done_ == columns;
  }

  /// With a hair at the amplitude of now.
  void draw(Canvas& canvas, Rect area, const Simulation& simulation) {
    const Diagram diagram{plot_box(area, 24), slider(), {0, top()}};
    const bool wide = area.width > 500;
    diagram.draw(canvas,
                 wide ? "heights of the bounces for every amplitude, m (click: go there)"
                      : "heights for every amplitude, m",
                 wide ? 10 : 5, 4, " m");
    make_dots(diagram);
    for (const Rect& dot : dots_) draw_rect(canvas, dot, palette::motion.faded(0.75));

    const double now = run_as<OscillatingFloorRun>(simulation).scene().amplitude;
    if (now > slider().highest) return;
    const Point top = diagram.at(now, diagram.up.highest);
    draw_line(canvas, top, {top.x, diagram.box.bottom()}, palette::ink, 1.5f);
    draw_label(canvas, {top.x + 6, top.y + 2}, with_unit(now, "m"), palette::ink);
  }

  /// The amplitude at this place of the picture.
  static std::optional<double> amplitude_at(Rect area, Point at) {
    const Range range = slider();
    const Rect box = plot_box(area, 24);
    if (at.y < box.y || at.y > box.bottom() || at.x < box.x - 4 || at.x > box.right() + 4) {
      return std::nullopt;
    }
    const double share = std::clamp((at.x - box.x) / box.width, 0.0f, 1.0f);
    const double amplitude = range.lowest + share * (range.highest - range.lowest);
    return std::round(amplitude * 1e4) / 1e4;  // tenths of a millimetre
  }

 private:
  static Range slider() {
    OscillatingFloor scene;
    return find_parameter(scene.parameters(), "amplitude").slider;
  }
  static double amplitude_of(int column) {
    const Range range = slider();
    return range.lowest + (range.highest - range.lowest) * column / (columns - 1);
  }
  /// The n-th column to be computed: every sixteenth, then every sixteenth beside these, ...
  static int column_of(int n) { return n % 25 * 16 + order[static_cast<std::size_t>(n / 25)]; }
  static constexpr std::array<int, 16> order{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};

  /// A flight that takes a swing of the floor rises by g T^2 / 8. What is more than three times as
  /// high is left out of the picture: else the first forks were too small to be seen.
  double top() const {
    const double swing = 2 * std::numbers::pi / scene_.angular_frequency;
    const double top = scene_.radius + 3 * scene_.gravity * swing * swing / 8;
    return top > 0 && top < highest_ ? top : std::max(highest_, 0.1);
  }

  /// The next columns, side by side; or the next one, where bounces are slow.
  void compute() {
    std::vector<OscillatingFloor> scenes;
    const int first = done_;
    scene_.amplitude = slider().highest;
    const std::size_t most = has_quick_contact(scene_) ? lanes : 1;
    for (; done_ < columns && scenes.size() < most; ++done_) {
      scene_.amplitude = amplitude_of(column_of(done_));
      scenes.push_back(scene_);
    }
    try {
      int n = first;
      for (const std::vector<Bounce>& bounces : settled_bounces(scenes, discarded, kept)) {
        for (const Bounce& bounce : bounces) highest_ = std::max(highest_, bounce.height);
        bounces_[static_cast<std::size_t>(column_of(n++))] = bounces;
      }
    } catch (const TimeStandsStill&) {
      // Contacts that cannot be followed (absolute, fixed-switch): these columns stay empty.
    }
  }

  /// One mark for all bounces of a column whose marks would touch.
  void make_dots(const Diagram& diagram) {
    if (drawn_ == done_ && drawn_width_ == diagram.box.width) return;
    drawn_ = done_;
    drawn_width_ = diagram.box.width;
    dots_.clear();
    const float width = std::max(1.0f, diagram.box.width / columns);
    std::vector<float> places;
    for (int column = 0; column < columns; ++column) {
      places.clear();
      for (const auto& [phase, speed, height] : bounces_[static_cast<std::size_t>(column)]) {
        if (height >= 0 && height <= diagram.up.highest)
          places.push_back(std::floor(diagram.at(0, height).y));
      }
      std::sort(places.begin(), places.end());
      const float x = diagram.at(amplitude_of(column), 0).x - width / 2;
      for (std::size_t i = 0; i < places.size();) {
        const float top = places[i];
        float bottom = top;
        while (i < places.size() && places[i] <= bottom + 1) bottom = places[i++];
        dots_.push_back({x, top, width, bottom - top + 1.5f});
      }
    }
  }

  OscillatingFloor scene_;
  std::vector<std::string> settings_;  // of all that it depends on
  std::vector<std::vector<Bounce>> bounces_ = std::vector<std::vector<Bounce>>(columns);
  int done_ = 0;  // columns
  double highest_ = 0;
  // As they were drawn last
  std::vector<Rect> dots_;
  int drawn_ = -1;
  float drawn_width_ = 0;
};

}  // namespace bounce
