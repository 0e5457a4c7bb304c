#include "app/page_words.hpp"

namespace bounce {

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
  std::vector<std::string> settings;
  for (const auto& [option, value] : words) {
    if (option == "--set") settings.push_back(value);
  }
  set_parameters(settings, *simulation);
  for (const auto& [option, value] : words) {
    if (option == "--method") simulation->use_method(find_method(value, simulation->methods()));
    if (option == "--dt") simulation->use_dt(option_number(option, value, Simulation::valid_dt));
    if (option == "--seed") {
      simulation->use_seed(
          static_cast<std::uint64_t>(option_number(option, value, {0, 1e15}, "", true)));
    }
  }
  simulation->restart();
  if (const std::string why = simulation->traits().refusal; !why.empty()) throw BadInput(why);
  return simulation;
}

}  // namespace bounce
