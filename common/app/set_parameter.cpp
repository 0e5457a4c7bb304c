#include "app/demo.hpp"

namespace bounce {

void set_parameter(const Demo& demo, Simulation& simulation, const std::string& name,
                   const std::string& text) {
  const std::vector<Parameter> all = simulation.parameters();
  const Parameter& changed = find_parameter(all, name);
  if (demo.set) {
    demo.set(simulation, changed, text);
  } else {
    changed.set(text);
  }
}

}  // namespace bounce
