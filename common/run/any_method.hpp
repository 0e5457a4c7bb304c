#pragma once
#include <type_traits>
#include <variant>
#include <vector>

#include "physics/methods/all_methods.hpp"

namespace bounce {

/// One of the methods of a list, with what it carries: the one that moves a run now.
template <class List>
class AnyMethod;

template <class... Methods>
class AnyMethod<MethodList<Methods...>> {
 public:
  static std::vector<Method> offered() { return {Methods::facts...}; }

  /// From now on this one moves, and has nothing to remember. `from` says where it starts: world,
  /// t, state, tolerance. A method that is not offered changes nothing.
  template <class... From>
  void begin(const Method& method, const From&... from) {
    const auto begin_if = [&]<class One>(std::type_identity<One>) {
      if (!(One::facts == method)) return;
      if constexpr (std::is_constructible_v<One, const From&...>) {
        now_.template emplace<One>(from...);
      } else {
        now_.template emplace<One>();
      }
    };
    (begin_if(std::type_identity<Methods>{}), ...);
  }

  template <class Visit>
  decltype(auto) visit(const Visit& visit) {
    return std::visit(visit, now_);
  }
  template <class Visit>
  decltype(auto) visit(const Visit& visit) const {
    return std::visit(visit, now_);
  }

  /// Of the force, by a method that counts them.
  long long counted_evaluations() const {
    return visit([](const auto& one) -> long long {
      if constexpr (requires { one.counted_evaluations(); }) return one.counted_evaluations();
      return 0;
    });
  }

  /// What the method remembers, to a visitor as in remembered.hpp; `resume` after reading it.
  template <class Self, class Visitor>
  static void remembered(Self& self, Visitor& visitor) {
    self.visit([&visitor](auto& one) {
      if constexpr (requires { one.remembered(one, visitor); }) one.remembered(one, visitor);
    });
  }
  void resume() {
    visit([](auto& one) {
      if constexpr (requires { one.resume(); }) one.resume();
    });
  }

 private:
  std::variant<Methods...> now_;
};

}  // namespace bounce
