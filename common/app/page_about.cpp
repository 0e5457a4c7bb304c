// What a page is told of its stage, as JSON.
#include "app/keys.hpp"
#include "app/page_calls.hpp"
#include "app/page_json.hpp"

namespace bounce {

std::string about_page(const Demo& demo, Simulation& simulation, Simulation& fresh) {
  std::vector<std::string> methods;
  for (const Method& method : simulation.methods()) methods.push_back(name_of(method));
  std::vector<json::Object> dials;
  for (const Dial& dial : demo.dials) {
    dials.emplace_back().add("name", dial.name).add("unit", dial.unit).add("meaning", dial.meaning);
    dials.back().add("text", to_text(dial.get(simulation))).add("lowest", dial.range.lowest);
    dials.back().add("highest", dial.range.highest).add("whole", false);
  }
  json::Object all;
  all.add("title", demo.title).add("question", demo.question).add("name", demo.stage.name);
  all.add("survey", demo.survey.parameter);
  all.add("game", is_game(demo)).add("space", demo.in_space).add("dt", simulation.dt());
  all.add("method", name_of(simulation.method())).add_text("methods", json::list(methods));
  all.add("by_events", simulation.method().goes_by_events);
  all.add("balls", static_cast<double>(simulation.balls()));
  const std::string_view truth = simulation.traits().truth;
  all.add("truth", std::string(truth.substr(0, truth.find(','))));
  all.add_text("columns", json::list(simulation.columns())).add_text("dials", json::list(dials));
  all.add_text("parameters", json::list(simulation.parameters()));
  all.add_text("sliders", json::list(demo.sliders));
  std::vector<std::string> keys;  // and what they do, in turn
  if (!is_game(demo)) {
    for (const Key& key : keys_of(demo)) keys.insert(keys.end(), {key.key, key.meaning});
  }
  all.add_text("keys", json::list(keys));
  return all.add("command", command_for(demo.stage, simulation, fresh)).text();
}

}  // namespace bounce
