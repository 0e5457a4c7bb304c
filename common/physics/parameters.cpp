#include "physics/parameters.hpp"

#include <algorithm>

namespace bounce {

std::string Parameter::text() const {
  if (const auto* number = std::get_if<double*>(&value)) return to_text(**number);
  const Choice& choice = std::get<Choice>(value);
  return choice.names[choice.selected()];
}

std::string Parameter::allowed() const {
  if (const auto* choice = std::get_if<Choice>(&value)) return join(choice->names, " or ");
  return "a number from " + to_text(valid.lowest) + " to " + to_text(valid.highest);
}

void Parameter::set(std::string_view text) const {
  const auto refuse = [&]() {
    const std::string in_unit = unit.empty() ? "" : " (" + unit + ")";
    throw BadInput(name + " = '" + std::string(text) + "' is not allowed: it must be " + allowed() +
                   in_unit);
  };
  if (const auto* choice = std::get_if<Choice>(&value)) {
    const auto found = std::find(choice->names.begin(), choice->names.end(), text);
    if (found == choice->names.end()) refuse();
    choice->select(static_cast<std::size_t>(found - choice->names.begin()));
    return;
  }
  const std::optional<double> number = parse_number(text);
  if (!number || !valid.contains(*number)) refuse();
  **std::get_if<double*>(&value) = *number;
}

const Parameter& find_parameter(const std::vector<Parameter>& parameters, std::string_view name) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) return parameter;
    names.push_back(parameter.name);
  }
  throw BadInput("there is no parameter '" + std::string(name) + "'" + did_you_mean(name, names) +
                 ": the parameters are " + join(names));
}

namespace describe {
namespace {

// Wide enough for a dust grain and a planet, narrow enough that products of a few of them stay
// finite in a double (largest about 1.8e308).
constexpr Range positive{1e-30, 1e30};
constexpr Range not_negative{0, 1e30};
constexpr Range any{-1e15, 1e15};

}  // namespace

Parameter mass(double& value) {
  return {"mass", "kg", "how much the ball resists a force", &value, positive, {0.1, 10}};
}
Parameter gravity(double& value) {
  return {"gravity", "m/s^2", "pulls downwards; 0 turns it off", &value, not_negative, {0, 20}};
}
Parameter position(double& value, double highest_slider) {
  const Range slider{0, highest_slider};
  return {"position", "m", "height of the ball's centre at the start", &value, any, slider, true};
}
Parameter velocity(double& value) {
  return {"velocity", "m/s", "speed at the start, upwards", &value, any, {-10, 10}, true};
}
Parameter radius(double& value) {
  return {"radius", "m",      "the ball touches the floor below this height",
          &value,   positive, {0.05, 0.3}};
}
Parameter stiffness(double& value) {
  return {"stiffness", "N/m", "spring force per overlap", &value, positive, {500, 1e5}};
}
Parameter damping(double& value) {
  return {"damping", "N s/m", "damper force per speed; 0 for none", &value, not_negative, {0, 300}};
}
Parameter contact(ContactLaw& value) {
  Choice choice{{"slides", "push-only"},
                [&value] { return static_cast<std::size_t>(value); },
                [&value](std::size_t index) { value = static_cast<ContactLaw>(index); }};
  return {"contact", "", "may the damper pull the ball back at lift-off?", std::move(choice)};
}

}  // namespace describe

}  // namespace bounce
