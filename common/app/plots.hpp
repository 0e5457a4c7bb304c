#pragma once

#include "app/canvas.hpp"
#include "app/demo.hpp"

namespace bounce {

/// One quantity over the last seconds, with contacts shaded. The scale grows in steps of 1-2-5 and
/// never shrinks until the run starts anew, so that the picture does not twitch.
class PlotView {
 public:
  void draw(Canvas& canvas, Rect area, const Plot& plot, const Playback& playback);

 private:
  double top_ = 0;     // largest value the axis shows
  double bottom_ = 0;  // smallest
  double last_time_ = 0;
};

/// The energy as one stacked column: kinetic, gravitational, spring, lost to the damper. The
/// outline is what there was at the start: whatever the stack has too much or too little is the
/// method's *error*, shown apart and a hundred times enlarged.
void draw_energy_column(Canvas& canvas, Rect area, const TracePoint& now);

}  // namespace bounce
