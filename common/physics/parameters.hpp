#pragma once
#include <cstddef>
#include <functional>
#include <span>
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

/// What a number must be, in words: "a whole number from 1 to 9", "a number from 0 to 1 (s)".
std::string number_in(Range valid, const std::string& unit = "", bool is_whole = false);

/// The text as such a number; nothing where it is none.
std::optional<double> parse_number_in(std::string_view text, Range valid, bool is_whole = false);

/// One of a few named values, such as contact = may-pull | push-only.
struct Choice {
  std::vector<std::string> names;
  std::function<std::size_t()> selected;
  std::function<void(std::size_t)> select;
};

/// A choice that is kept in an enum whose values count 0, 1, 2 in the order of `names`.
template <class Enum>
Choice choice_of(Enum& value, std::vector<std::string> names) {
  return {std::move(names), [&value] { return static_cast<std::size_t>(value); },
          [&value](std::size_t index) { value = static_cast<Enum>(index); }};
}

/// The numbers of a vector parameter, such as position = 0,1,0.
using Components = std::span<double>;

/// One parameter of a scene, described once. From this description come the slider, `--set`,
/// `--list` and the check of what the user gives. It refers to a field of the scene that made it,
/// so it must not outlive that scene.
struct Parameter {
  std::string name;
  std::string unit;  // empty for a choice
  std::string meaning;
  std::variant<double*, Components, Choice> value;
  Range valid{};             // what a number may be: wide, up to where arithmetic still holds
  Range slider{};            // what is worth playing with
  bool is_start = false;     // tells where a run begins, not what its law is
  bool is_not_zero = false;  // a vector that gives a direction: not all of its numbers may be 0
  bool is_whole = false;     // counts something
  bool chooses_defaults = false;  // a choice that gives other parameters new defaults

  /// The value in shortest decimals ("0,1,0" for a vector), or the chosen name.
  std::string text() const;
  /// "a number from 1e-30 to 1e30", "3 numbers from -1 to 1, separated by commas", "on or off".
  std::string allowed() const;
  /// Whether a number, or the numbers of a vector, may be set.
  bool allows(std::span<const double> numbers) const;
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

// In three dimensions: x, y, z, with y up.
Parameter position(Components value, double highest_slider);
Parameter velocity(Components value);
Parameter normal(Components value);
Parameter offset(double& value);

/// on|off
Parameter floor(bool& value);

}  // namespace describe

}  // namespace bounce
