#pragma once
#include <memory>

#include "app/demo.hpp"

namespace bounce {

/// What a frame costs on the clock [s], the mean of the last ones.
struct FrameCost {
  double physics = 0, drawing = 0;
  void note(double physics_now, double drawing_now) {
    physics += (physics_now - physics) / 10;
    drawing += (drawing_now - drawing) / 10;
  }
};

/// The controls on the right: the question, sliders, play row, method and time step, cost and
/// error, and everything else folded away. Dear ImGui draws them and answers the mouse.
class Panel {
 public:
  Panel(const Demo& demo, bool seen);

  /// Draws the panel and applies what the user did to playback and view.
  void draw(Playback& playback, View& view);

  FrameCost frame_cost;  // for the read-out

 private:
  void draw_parameters(Playback& playback, View& view, bool main_ones);
  void draw_parameter(Playback& playback, View& view, const Parameter& parameter);
  void draw_dial(Playback& playback, View& view, const Dial& dial);
  void draw_play_row(Playback& playback);
  void draw_method(Playback& playback, View& view);
  void draw_cost_and_error(Playback& playback);
  void draw_keys();
  void note_slider(Playback& playback, View& view);
  void measure_cost(const Playback& playback);

  static constexpr double future_length = 3;  // s drawn ahead while a slider moves

  const Demo& demo_;
  bool seen_;                          // false: no figures that differ from run to run
  std::unique_ptr<Simulation> fresh_;  // the defaults
  int frames_since_slider_ = 1000;
  bool cost_is_old_ = true;
  double ns_per_step_ = 0;
  double counted_per_second_ = 0;  // force evaluations where events are located
};

}  // namespace bounce
