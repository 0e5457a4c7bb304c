#include "physics/parameters.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

std::string number_in(Range valid, const std::string& unit, bool is_whole) {
  return std::string(is_whole ? "a whole number" : "a number") + " from " + to_text(valid.lowest) +
         " to " + to_text(valid.highest) + (unit.empty() ? "" : " (" + unit + ")");
}

std::optional<double> parse_number_in(std::string_view text, Range valid, bool is_whole) {
  const std::optional<double> value = parse_number(text);
  const bool fits = value && valid.contains(*value) && !(is_whole && *value != std::floor(*value));
  return fits ? value : std::nullopt;
}

std::string Parameter::text() const {
  if (const auto* number = std::get_if<double*>(&value)) return to_text(**number);
  if (const auto* vector = std::get_if<Components>(&value)) return to_text(*vector);
  const Choice& choice = std::get<Choice>(value);
  return choice.names[choice.selected()];
}

std::string Parameter::allowed() const {
  if (const auto* choice = std::get_if<Choice>(&value)) return join(choice->names, " or ");
  if (const auto* vector = std::get_if<Components>(&value)) {
    return std::to_string(vector->size()) + " numbers from " + to_text(valid.lowest) + " to " +
           to_text(valid.highest) + ", separated by commas" +
           (is_not_zero ? ", not all of them 0" : "");
  }
  return number_in(valid, "", is_whole);
}

bool Parameter::allows(std::span<const double> numbers) const {
  const auto is_valid = [this](double number) {
    return valid.contains(number) && !(is_whole && number != std::floor(number));
  };
  const auto is_zero = [](double number) { return number == 0; };
  return std::all_of(numbers.begin(), numbers.end(), is_valid) &&
         !(is_not_zero && std::all_of(numbers.begin(), numbers.end(), is_zero));
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
  // A number is a vector of one.
  Components target;
  if (const auto* number = std::get_if<double*>(&value)) target = {*number, 1};
  if (const auto* vector = std::get_if<Components>(&value)) target = *vector;
  std::vector<double> numbers;
  for (const std::string& word : split(text)) {
    const std::optional<double> number = parse_number(word);
    if (!number) refuse();
    numbers.push_back(*number);
  }
  if (numbers.size() != target.size() || !allows(numbers)) refuse();
  std::copy(numbers.begin(), numbers.end(), target.begin());
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

Choice on_off(bool& value) {
  return {{"on", "off"},
          [&value] { return value ? std::size_t{0} : std::size_t{1}; },
          [&value](std::size_t index) { value = index == 0; }};
}

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
  return {"radius", "m",      "the ball touches what is nearer to its centre than this",
          &value,   positive, {0.05, 0.3}};
}
Parameter stiffness(double& value) {
  return {"stiffness", "N/m", "spring force per overlap", &value, positive, {500, 1e5}};
}
Parameter damping(double& value) {
  return {"damping", "N s/m", "damper force per speed; 0 for none", &value, not_negative, {0, 300}};
}
Parameter contact(ContactLaw& value) {
  return {"contact", "", "may the damper pull the ball back at lift-off?",
          choice_of(value, {"may-pull", "push-only"})};
}
Parameter position(Components value, double highest_slider) {
  const Range slider{-highest_slider, highest_slider};
  return {"position", "m", "the ball's centre x,y,z at the start; y is up", value, any,
          slider,     true};
}
Parameter velocity(Components value) {
  return {"velocity", "m/s", "velocity x,y,z at the start; y is up", value, any, {-5, 5}, true};
}
Parameter normal(Components value) {
  Parameter normal{
      "normal", "",  "a,b,c of the plane a x + b y + c z + d = 0; its length is no matter",
      value,    any, {-1, 1}};
  normal.is_not_zero = true;
  return normal;
}
Parameter offset(double& value) {
  return {"offset", "",  "d of the plane; in metres when the normal has length 1",
          &value,   any, {-1, 1}};
}
Parameter floor(bool& value) {
  return {"floor", "", "is there a floor at height 0?", on_off(value)};
}

}  // namespace describe

}  // namespace bounce
