#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physics/contact.hpp"
#include "physics/text.hpp"

namespace bounce {

/// A closed interval of numbers.
struct Range {
  double lowest;
  double highest;
  bool contains(double value) const { return lowest <= value && value <= highest; }
};

/// One of a few named values, such as contact = slides | push-only.
struct Choice {
  std::vector<std::string> names;
  std::function<std::size_t()> selected;
  std::function<void(std::size_t)> select;
};

/// One parameter of a scene, described once. From this description come the slider, `--set`,
/// `--list` and the check of what the user gives. It refers to a field of the scene that made it,
/// so it must not outlive that scene.
struct Parameter {
  std::string name;
  std::string unit;  // empty for a choice
  std::string meaning;
  std::variant<double*, Choice> value;
  Range valid{};          // what a number may be: wide, up to where arithmetic still holds
  Range slider{};         // what is worth playing with
  bool is_start = false;  // tells where a run begins, not what its law is

  /// The value in shortest decimals, or the chosen name.
  std::string text() const;
  /// "a number from 1e-30 to 1e30", "slides or push-only".
  std::string allowed() const;
  /// Throws BadInput for text that is no number, and for a value that is not allowed.
  void set(std::string_view text) const;
};

/// The parameter of that name. Throws BadInput, with the nearest right name, when there is none.
const Parameter& find_parameter(const std::vector<Parameter>& parameters, std::string_view name);

/// The descriptions that several stages share: the same word means the same thing everywhere.
namespace describe {

Parameter mass(double& value);
Parameter gravity(double& value);
Parameter position(double& value, double highest_slider);
Parameter velocity(double& value);
Parameter radius(double& value);
Parameter stiffness(double& value);
Parameter damping(double& value);
Parameter contact(ContactLaw& value);

}  // namespace describe

}  // namespace bounce
