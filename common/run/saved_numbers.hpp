#pragma once
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
  for (const double number : components(vector)) all.push_back(number);
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

/// Takes them off again, one after the other. A file may hold anything: what is missing reads as 0,
/// and is told at the end by `all_is_well`, as are numbers that are left over.
class SavedNumbers {
 public:
  explicit SavedNumbers(std::span<const double> numbers) : numbers_(numbers) {}

  double number() { return number_in(-never, never); }
  /// One that must lie between these two.
  double number_in(double least, double most) {
    const double value = left() > 0 ? numbers_[next_] : 0;
    well_ = well_ && left() > 0 && value >= least && value <= most;
    ++next_;
    return value;
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
  Phase phase() { return static_cast<Phase>(whole(2)); }
  /// A whole number from 0 to `most`.
  int whole(int most) {
    const int value = static_cast<int>(number_in(0, most));
    well_ = well_ && value == numbers_[next_ - 1];
    return value;
  }

  std::size_t left() const { return next_ < numbers_.size() ? numbers_.size() - next_ : 0; }
  bool all_is_well() const { return well_ && next_ == numbers_.size(); }

 private:
  std::span<const double> numbers_;
  std::size_t next_ = 0;
  bool well_ = true;
};

}  // namespace bounce
