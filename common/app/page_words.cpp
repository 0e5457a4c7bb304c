#include "app/page_words.hpp"

namespace bounce {
namespace {

double number(const std::string& option, const std::string& text, Range valid) {
  const std::optional<double> value = parse_number(text);
  if (value && valid.contains(*value)) return *value;
  throw BadInput(option + " '" + text + "' is not allowed: it must be " + number_in(valid, ""));
}

void set(const std::string& setting, bool if_it_chooses_defaults, Simulation& simulation) {
  const std::vector<Parameter> parameters = simulation.parameters();
  const std::size_t equals = std::min(setting.find('='), setting.size());
  const Parameter& parameter = find_parameter(parameters, setting.substr(0, equals));
  if (parameter.chooses_defaults != if_it_chooses_defaults) return;
  parameter.set(setting.substr(std::min(equals + 1, setting.size())));
}

}  // namespace

std::unique_ptr<Simulation> set_up(int argc, const char* const* argv, const Demo& demo) {
  std::unique_ptr<Simulation> simulation = demo.make();
  std::vector<std::pair<std::string, std::string>> words;
  for (int i = 1; i + 1 < argc; i += 2) words.emplace_back(argv[i], argv[i + 1]);

  for (const auto& [option, value] : words) {
    bool is_known =
        option == "--set" || option == "--method" || option == "--dt" || option == "--seed";
    for (const StageOption& of_stage : demo.options) {
      if (of_stage.name != option || !of_stage.apply) continue;
      of_stage.apply(simulation, value);
      is_known = true;
    }
    if (!is_known) throw BadInput("a page has no option " + option);
  }
  for (const bool chooses_defaults : {true, false}) {  // wherever they stand among the words
    for (const auto& [option, value] : words) {
      if (option == "--set") set(value, chooses_defaults, *simulation);
    }
  }
  for (const auto& [option, value] : words) {
    if (option == "--method") simulation->use_method(find_method(value, simulation->methods()));
    if (option == "--dt") simulation->use_dt(number(option, value, Simulation::valid_dt));
    if (option == "--seed") {
      simulation->use_seed(static_cast<std::uint64_t>(number(option, value, {0, 1e15})));
    }
  }
  simulation->restart();
  if (const std::string why = simulation->traits().refusal; !why.empty()) throw BadInput(why);
  return simulation;
}

}  // namespace bounce
