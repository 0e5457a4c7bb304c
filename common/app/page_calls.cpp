#include "app/page_calls.hpp"

#include <algorithm>
#include <cmath>

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

bool is_dial(const Demo& demo, const std::string& name) {
  return std::any_of(demo.dials.begin(), demo.dials.end(),
                     [&name](const Dial& dial) { return dial.name == name; });
}
void set_dial(const Demo& demo, Simulation& simulation, const std::string& name,
              const std::string& text) {
  const std::optional<double> value = parse_number(text);
  if (!value) throw BadInput(name + " = '" + text + "' is not allowed: it must be a number");
  for (const Dial& dial : demo.dials) {
    if (dial.name == name) dial.set(simulation, *value);
  }
}

void run_path(const Simulation& like, double seconds, int count, bool with_exact,
              std::vector<double>& rows) {
  rows.clear();
  const std::unique_ptr<Simulation> run = like.clone();
  run->keep_energy_book(false);
  run->restart();
  const bool by_events = run->method().goes_by_events;
  const double stride = seconds / (count - 1), whole = std::ceil(stride / run->dt() - 1e-9);
  for (double row = 0; run->time() <= seconds * (1 + 1e-9); ++row) {
    rows.push_back(run->time());
    const auto append = [&rows](const std::vector<double>& values) {
      rows.insert(rows.end(), values.begin(), values.end());
    };
    append(run->values());
    if (with_exact) append(run->exact_values(run->time()));
    if (by_events && row >= count - 1) break;
    run->advance_to(by_events ? (row + 1) * stride
                              : run->time_of_next_step() + (whole - 1) * run->dt());
  }
}

}  // namespace bounce
