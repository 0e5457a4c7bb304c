#pragma once
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "physics/components.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/state.hpp"

namespace bounce {

// What a run remembers from step to step, as a row of plain numbers: for `--save`, `--load` and the
// hashes. A part of a run says once what it remembers,
//
//   template <class Self, class Visit> static void remembered(Self& self, Visit& visit)
//
// and calls visit(name, value) for each thing, always in the same order. Two visitors follow: one
// writes the numbers down, one reads them back.

/// Writes what is remembered.
class NumberWriter {
 public:
  static constexpr bool reads = false;

  void operator()(const char* /*name*/, double number) { numbers_.push_back(number); }
  template <VectorOrNumber Vector>
  void operator()(const char* /*name*/, const Vector& vector) {
    const auto numbers = components(vector);
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  }
  template <class Vector>
  void operator()(const char* name, const State<Vector>& state) {
    (*this)(name, state.position);
    (*this)(name, state.velocity);
  }
  template <class Vector>
  void operator()(const char* name, const std::optional<Vector>& last) {
    if (last) (*this)(name, *last);
  }
  void operator()(const char* name, Phase phase) { whole(name, phase, 0, 2); }
  void positive(const char* name, double number) { (*this)(name, number); }
  template <class Whole>
  void whole(const char* /*name*/, Whole number, long long /*least*/, long long /*most*/) {
    numbers_.push_back(static_cast<double>(number));
  }

  std::vector<double> take() { return std::move(numbers_); }

 private:
  std::vector<double> numbers_;
};

/// Reads them back. A file may hold anything: what is missing or not allowed reads as 0, and is
/// told at the end by `trouble`, as are numbers that are left over.
class NumberReader {
 public:
  static constexpr bool reads = true;

  explicit NumberReader(std::span<const double> numbers) : numbers_(numbers) {}

  void operator()(const char* name, double& number) {
    number = take(name, [](double) { return true; });
  }
  template <VectorOrNumber Vector>
  void operator()(const char* name, Vector& vector) {  // of a size that is known beforehand
    for (double& number : components(vector)) (*this)(name, number);
  }
  template <class Vector>
  void operator()(const char* name, State<Vector>& state) {
    state_size_ = components(state.position).size();
    (*this)(name, state.position);
    (*this)(name, state.velocity);
  }
  /// What may be missing comes last; it is as large as the state's position.
  template <class Vector>
  void operator()(const char* name, std::optional<Vector>& last) {
    last.reset();
    if (left() == 0) return;
    if (left() != state_size_) return refuse(name);
    last.emplace();
    if constexpr (requires { last->resize(3, 1); }) {
      if (last->size() == 0) last->resize(3, static_cast<int>(state_size_ / 3));
    }
    (*this)(name, *last);
  }
  void operator()(const char* name, Phase& phase) { whole(name, phase, 0, 2); }
  void positive(const char* name, double& number) {
    number = take(name, [](double value) { return value > 0; });
  }
  /// A whole number, also of an enum or a bool, between these two.
  template <class Whole>
  void whole(const char* name, Whole& number, long long least, long long most) {
    number = static_cast<Whole>(static_cast<long long>(take(name, [=](double value) {
      return value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
             value == std::floor(value);
    })));
  }
  void refuse(const char* name) {
    if (trouble_.empty()) trouble_ = name;
  }

  std::size_t left() const { return next_ < numbers_.size() ? numbers_.size() - next_ : 0; }
  std::string trouble_so_far() const { return trouble_; }
  /// Empty, or the name of the first thing that did not fit.
  std::string trouble() const {
    return trouble_.empty() && left() > 0 ? "too many numbers" : trouble_;
  }

 private:
  template <class Allowed>
  double take(const char* name, const Allowed& is_allowed) {
    if (left() > 0 && is_allowed(numbers_[next_])) return numbers_[next_++];
    next_ += left() > 0 ? 1 : 0;
    refuse(name);
    return 0;
  }

  std::span<const double> numbers_;
  std::size_t next_ = 0;
  std::size_t state_size_ = 0;
  std::string trouble_;
};

}  // namespace bounce
