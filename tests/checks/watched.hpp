#pragma once
#include <exception>
#include <new>
#include <string>

#include "checks/judged_process.hpp"
#include "checks/subject.hpp"

namespace bounce::check {

/// A subject whose every call is announced, so that the judge can name the function that did not
/// come back, and whose exceptions end the process in words.
class Watched final : public Subject {
 private:
  template <class Call>
  static auto call(const char* function, const Call& of_the_learner) {
    enter(function);
    try {
      return of_the_learner();
    } catch (const std::bad_alloc&) {
      end_without_memory();
    } catch (const std::exception& thrown) {
      end_with(std::string("your code throws an exception: ") + thrown.what());
    } catch (...) {
      end_with("your code throws an exception");
    }
  }

 public:
  explicit Watched(const Subject& subject) : subject_(subject) {}

  Triple force(const Setting& s, double t, const Motion& m) const override {
    return call("force", [&] { return subject_.force(s, t, m); });
  }
  Triple acceleration(const Setting& s, double t, const Motion& m) const override {
    return call("acceleration", [&] { return subject_.acceleration(s, t, m); });
  }
  Motion run(const Setting& s, const Motion& start, double dt, long steps) const override {
    return call("acceleration", [&] { return subject_.run(s, start, dt, steps); });
  }
  Motion step(const LinearLaw& law, double t, const Motion& now, double dt) const override {
    return call("fall_one_step", [&] { return subject_.step(law, t, now, dt); });
  }
  Walked walk(const Walk& walk) const override {
    return call("MyMethod", [&] { return subject_.walk(walk); });
  }
  Motion walk_in_space(const Walk& walk, const Motion& start) const override {
    return call("MyMethod", [&] { return subject_.walk_in_space(walk, start); });
  }
  MeetingFound meet(const OneOfMany& a, const OneOfMany& b) const override {
    return call("meet", [&] { return subject_.meet(a, b); });
  }
  Triple pair_force(const Setting& s, const OneOfMany& a, const OneOfMany& b) const override {
    return call("pair_force", [&] { return subject_.pair_force(s, a, b); });
  }
  std::vector<Triple> accelerations(const Setting& s,
                                    const std::vector<OneOfMany>& balls) const override {
    auto found = call("acceleration", [&] { return subject_.accelerations(s, balls); });
    if (found.size() == balls.size()) return found;
    end_with("your code answers with " + std::to_string(found.size()) + " accelerations for " +
             std::to_string(balls.size()) + " balls");
  }
  double floor_height(const Setting& s, double t) const override {
    return call("floor_height", [&] { return subject_.floor_height(s, t); });
  }
  double floor_speed(const Setting& s, double t) const override {
    return call("floor_speed", [&] { return subject_.floor_speed(s, t); });
  }
  bool touches(const Setting& s, double y, double floor) const override {
    return call("touches", [&] { return subject_.touches(s, y, floor); });
  }
  double damped_velocity(const Setting& s, double t, double v) const override {
    return call("damped_velocity", [&] { return subject_.damped_velocity(s, t, v); });
  }
  std::array<double, 4> plane(const Setting& s) const override {
    return call("plane", [&] { return subject_.plane(s); });
  }
  NearestFound nearest(const Setting& s, const Triple& ball) const override {
    return call("nearest", [&] { return subject_.nearest(s, ball); });
  }
  int side_after(const Setting& s, double t, const Triple& ball) const override {
    return call("choose_side", [&] { return subject_.side_after(s, t, ball); });
  }

 private:
  const Subject& subject_;
};

}  // namespace bounce::check
