#include "app/pointer.hpp"

#include "app/layout.hpp"

namespace bounce {

void HeldBall::take(const Demo& demo, const Playback& playback, const View& view, Point at) {
  is_held_ = demo.is_on_ball && demo.is_on_ball(playback, view, at);
  way_.clear();
}

void HeldBall::follow(const Demo& demo, Playback& playback, const View& view, double clock,
                      Point at) {
  if (!is_held_) return;
  way_.push_back({clock, at});
  while (way_.size() > 2 && way_.front().t < clock - 0.08) way_.pop_front();
  const Sample &first = way_.front(), &last = way_.back();
  const auto span = static_cast<float>(last.t - first.t);
  Point velocity{0, 0};
  if (span > 0) velocity = {(last.at.x - first.at.x) / span, (last.at.y - first.at.y) / span};
  demo.drag(playback, view, last.at, velocity);
}

void set_parameter(const Demo& demo, Playback& playback, const std::string& name,
                   const std::string& text) {
  const std::vector<Parameter> now = playback.simulation().parameters();
  playback.change([&](Simulation& simulation) { set_parameter(demo, simulation, name, text); },
                  find_parameter(now, name).is_start);
}

bool choose_from_chart(const Demo& demo, const View& view, const ErrorChart& chart,
                       Playback& playback, Point at) {
  const Rect area = layout::chart;
  const bool inside =
      at.x >= area.x && at.x <= area.right() && at.y >= area.y && at.y <= area.bottom();
  if (!view.chart || demo.bare || !inside) return false;
  if (const std::optional choice = error_chart_choice(area, chart, at)) {
    playback.change([&choice](Simulation& simulation) {
      simulation.use_method(choice->method);
      if (choice->dt > 0) simulation.use_dt(choice->dt);
    });
  }
  return true;
}

}  // namespace bounce
