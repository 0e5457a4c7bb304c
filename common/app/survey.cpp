#include "app/survey.hpp"

#include "app/layout.hpp"

namespace bounce {

bool shows_survey(const Demo& demo, const View& view) {
  return demo.survey.draw && !demo.bare && (view.survey || !view.future.empty());
}
bool shows_section(const Demo& demo, const View& view) {
  return demo.survey.section && !demo.bare && view.section;
}

Rect survey_area(const Demo& demo, const View& view) {
  Rect area = layout::plots[0];
  if (!shows_section(demo, view) && !view.narrow) area.width = layout::plots[1].right() - area.x;
  return area;
}

bool choose_from_survey(const Demo& demo, View& view, Playback& playback, Point at) {
  if (!shows_survey(demo, view)) return false;
  const std::optional<double> value = demo.survey.value_at(survey_area(demo, view), at);
  if (!value) return false;
  set_parameter(demo, playback, demo.survey.parameter, to_text(*value));
  view.survey = true;
  return true;
}

}  // namespace bounce
