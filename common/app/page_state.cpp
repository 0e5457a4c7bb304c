// What changes in a page while its stage runs, as JSON.
#include <limits>

#include "app/page.hpp"
#include "app/page_json.hpp"
#include "app/survey.hpp"
#include "run/step_warning.hpp"

namespace bounce {

std::string state_of_page(Page& p) {
  const Simulation& simulation = p.playback.simulation();
  const std::optional<StateError> error = simulation.error();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  json::Object all;
  all.add("t", p.playback.shown_time()).add("earliest", p.playback.earliest());
  all.add("paused", p.playback.paused).add("slow", p.playback.rate < 1);
  all.add("lens", p.playback.contact_lens)
      .add("rate", p.playback.current_rate() * p.playback.pace());
  all.add("forces", p.view.forces).add("exact", p.view.ghost).add("trail", p.view.trail);
  all.add("above", p.view.from_above).add("errors", p.view.chart).add("muted", p.view.muted);
  all.add("help", p.view.help).add("off", error ? error->position : nothing);
  const int evaluations = simulation.method().evaluations;
  all.add("evaluations", evaluations > 0 ? evaluations / simulation.dt() : nothing);
  const TracePoint& now = p.playback.trace().back();
  all.add("height", now.energy.gravitational).add("spring", now.energy.spring);
  all.add("motion", now.energy.kinetic).add("lost", now.lost);
  const bool stopped = !p.playback.trouble().empty();
  all.add("trouble", stopped ? p.playback.trouble() : step_warning(simulation));
  const bool survey = shows_survey(p.demo, p.view);
  all.add("survey", p.view.survey).add("section", p.view.section).add("surveyed", survey);
  all.add("busy",
          (p.view.chart && !p.demo.bare && !p.chart.is_done()) || (survey && !p.survey_is_done));
  return all.text();
}

}  // namespace bounce
