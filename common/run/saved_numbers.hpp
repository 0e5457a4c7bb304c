#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/closed_form.hpp"
#include "physics/components.hpp"
#include "physics/state.hpp"

namespace bounce {

// What a simulation remembers, as a row of plain numbers for `--save` and `--load`.

template <class Vector>
void append(std::vector<double>& all, const Vector& vector) {
  const auto numbers = components(vector);
  all.insert(all.end(), numbers.begin(), numbers.end());
}
/// In the order of the trace: position, then velocity.
template <class Vector>
void append(std::vector<double>& all, const State<Vector>& state) {
  append(all, state.position);
  append(all, state.velocity);
}
template <class Vector>
std::vector<double> numbers_of(const State<Vector>& state) {
  std::vector<double> all;
  append(all, state);
  return all;
}

/// Takes them off again, one after the other. A file may hold anything: what is missing or not
/// allowed reads as 0, and is told at the end by `all_is_well`, as are numbers that are left over.
class SavedNumbers {
 public:
  explicit SavedNumbers(std::span<const double> numbers) : numbers_(numbers) {}

  double number() {
    return take([](double) { return true; });
  }
  double positive() {
    return take([](double value) { return value > 0; });
  }
  /// A whole number between these two.
  long long whole(long long least, long long most) {
    return static_cast<long long>(take([=](double value) {
      return value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
             value == std::floor(value);
    }));
  }
  template <class Vector>
  Vector vector() {
    Vector vector;
    for (double& component : components(vector)) component = number();
    return vector;
  }
  template <class Vector>
  State<Vector> state() {
    const Vector position = vector<Vector>();
    return {position, vector<Vector>()};
  }
  Phase phase() { return static_cast<Phase>(whole(0, 2)); }

  std::size_t left() const { return next_ < numbers_.size() ? numbers_.size() - next_ : 0; }
  bool all_is_well() const { return well_ && next_ == numbers_.size(); }

 private:
  template <class Allowed>
  double take(const Allowed& is_allowed) {
    const bool is_there = next_ < numbers_.size();
    const double value = is_there ? numbers_[next_] : 0;
    ++next_;
    if (is_there && is_allowed(value)) return value;
    well_ = false;
    return 0;
  }

  std::span<const double> numbers_;
  std::size_t next_ = 0;
  bool well_ = true;
};

}  // namespace bounce
