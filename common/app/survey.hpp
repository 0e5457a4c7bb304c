#pragma once
#include "app/canvas.hpp"
#include "app/demo.hpp"

namespace bounce {

// The survey of a demo (demo.hpp), in a window and in a web page.

/// It is seen while a slider moves, and a little longer; or as long as somebody wants to see it.
bool shows_survey(const Demo& demo, const View& view);
bool shows_section(const Demo& demo, const View& view);

/// Where: in place of the plots, or of the first one where the section takes the second.
Rect survey_area(const Demo& demo, const View& view);

/// A click on the survey sets its parameter, and keeps it in the picture. Returns whether the click
/// was the survey's.
bool choose_from_survey(const Demo& demo, View& view, Playback& playback, Point at);

}  // namespace bounce
