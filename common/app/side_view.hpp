#pragma once
#include <functional>

#include "app/canvas.hpp"
#include "app/demo.hpp"
#include "app/player.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Forces on a ball that moves up and down [N], upwards positive.
struct ForcesOnALine {
  double gravity = 0, spring = 0, damper = 0;
  double net() const { return gravity + spring + damper; }
};

/// What the side view needs to know of the ball.
struct BallOnALine {
  double radius = 0.1;  // m
  std::function<ForcesOnALine(double t, const State<double>&)> forces;
  bool floor = true;
  std::function<double(double t)> floor_height = {};  // of one that moves [m]; empty: rests at 0
  /// Where y stands among the trace's values. After it comes v, and before it a moving floor's
  /// height: its past is drawn from the trace, because its law may have changed since.
  std::size_t column = 0;
  bool strobe = false;  // leave an image every 0.1 s, beside those of the exact solution
  double lowest = -0.14,
         highest = 1.25;  // in the picture [m]; the top grows when the ball leaves it
};

/// The scene of stages 1 to 3 and 6: ruler, ground, ball and ghost, forces; to the left where the
/// ball has been, to the right (while a slider moves) where it will go: height against time, on the
/// ruler's own scale; so is the path of a floor that moves. With `strobe`, the images stay where
/// they were taken instead.
void draw_side_view(Canvas& canvas, const Player& player, const View& view,
                    const BallOnALine& ball);

/// Gives a demo this scene as its picture, with a ball that can be dragged and thrown.
void use_side_view(Demo& demo, std::function<BallOnALine(const Player&)> ball);

}  // namespace bounce
