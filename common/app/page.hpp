#pragma once
#include <memory>
#include <string>

#include "app/demo.hpp"
#include "app/keys.hpp"
#include "app/page_canvas.hpp"
#include "app/plots.hpp"
#include "app/pointer.hpp"

namespace bounce {

/// One stage in a page. A stage's main comes to its end before the page begins, hence the copy of
/// its demo.
struct Page {
  Demo demo;
  Playback playback;
  std::unique_ptr<Simulation> fresh;  // the defaults
  View view{};
  PageCanvas canvas{};
  PlotView plots[2]{};
  ErrorChart chart{};
  Controls controls{};
  HeldBall held{};
  double clock = 0;  // s since the start
  long long knocks = 0;
  int future_frames = 0;
  bool survey_is_done = true;
};
/// What changes while it runs. As JSON.
std::string state_of_page(Page& page);

}  // namespace bounce
