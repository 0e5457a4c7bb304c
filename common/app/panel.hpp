#pragma once
#include <memory>
#include <string>

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

  /// Draws the panel and applies what the user did to player and view.
  void draw(Player& player, View& view);

  FrameCost frame_cost;  // for the read-out

  /// The command line that starts a run like this one.
  std::string command(Player& player);

 private:
  void draw_parameters(Player& player, View& view, bool main_ones);
  void draw_parameter(Player& player, View& view, const Parameter& parameter);
  void draw_dial(Player& player, View& view, const Dial& dial);
  void draw_play_row(Player& player);
  void draw_method(Player& player, View& view);
  void draw_cost_and_error(Player& player);
  void draw_keys();
  void note_slider(Player& player, View& view);
  void measure_cost(const Player& player);

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
