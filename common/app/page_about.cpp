// What a page is told of its stage, as JSON.
#include <limits>

#include "app/page.hpp"
#include "app/page_json.hpp"
#include "app/survey.hpp"
#include "run/step_warning.hpp"

namespace bounce {

std::string about_page(Page& p) {
  Simulation& simulation = p.playback.simulation();
  std::vector<std::string> methods;
  for (const Method& method : simulation.methods()) methods.push_back(name_of(method));
  std::vector<json::Object> dials;
  for (const Dial& dial : p.demo.dials) {
    dials.emplace_back().add("name", dial.name).add("unit", dial.unit).add("meaning", dial.meaning);
    dials.back().add("text", to_text(dial.get(simulation))).add("lowest", dial.range.lowest);
    dials.back().add("highest", dial.range.highest).add("whole", false);
  }
  json::Object all;
  all.add("title", p.demo.title).add("question", p.demo.question).add("name", p.demo.stage.name);
  all.add("survey", p.demo.survey.parameter);
  all.add("game", is_game(p.demo)).add("space", p.demo.in_space).add("dt", simulation.dt());
  all.add("method", name_of(simulation.method())).add_text("methods", json::list(methods));
  all.add("by_events", simulation.method().goes_by_events);
  all.add("balls", static_cast<double>(simulation.balls()));
  all.add_text("columns", json::list(simulation.columns())).add_text("dials", json::list(dials));
  all.add_text("parameters", json::list(simulation.parameters()));
  all.add_text("sliders", json::list(p.demo.sliders));
  return all.add("command", command_for(p.demo.stage, simulation, *p.fresh)).text();
}

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
