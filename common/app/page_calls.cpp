#include "app/page_calls.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

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
