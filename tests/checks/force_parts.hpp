#pragma once
#include <string>
#include <vector>

#include "checks/law.hpp"

namespace bounce::check {

/// What a contact force is made of, at one moment.
struct Contact {
  Triple direction;  // of the push
  double overlap;    // m; counts also where nothing touches
  double away;       // m/s, the velocity along the direction
  bool touches;
};

/// "in contact on the way in": where a contact is asked.
inline std::string contact_place(const Contact& c, double radius) {
  if (!c.touches) return c.overlap == 0 ? "exactly at the touch" : "in the air";
  if (c.overlap > 2 * radius) return "where the whole ball is below the surface";
  if (c.overlap > radius) return "where the ball's centre is below the surface";
  if (c.away == 0) return "in contact at rest";
  return c.away < 0 ? "in contact on the way in" : "in contact on the way out";
}

/// Weight, spring and damper, and what learners write in their place. `contact` tells a probe's
/// Contact, and `moment` its setting and motion.
template <class Probe, class ContactOf, class MomentOf>
std::vector<PartOf<Probe>> force_parts(ContactOf contact, MomentOf moment, bool on_a_line = false) {
  std::vector<PartOf<Probe>> all;
  const auto add = [&](const char* name, double wanted, auto value) {
    all.push_back({name, wanted, [=](const Probe& probe) {
                     const Moment m = moment(probe);
                     return value(m.setting, contact(probe), m);
                   }});
  };
  const auto add_push = [&](const char* name, double wanted, auto size) {  // while they touch
    add(name, wanted, [=](const Setting& s, const Contact& c, const Moment&) {
      return times(c.touches ? size(s, c) : 0, c.direction);
    });
  };
  using S = const Setting&;
  using C = const Contact&;
  using M = const Moment&;
  const auto lets_go = [](S s, C c) {
    return s.push_only && s.stiffness * c.overlap < s.damping * c.away;
  };
  const auto spring = [](S s, C c) { return s.stiffness * c.overlap; };
  const auto damper = [](S s, C c) { return -s.damping * c.away; };
  add("the weight m g", 1, [](S, C, M m) { return up(-m.weight()); });
  add_push("the spring", 1, [=](S s, C c) { return lets_go(s, c) ? 0 : spring(s, c); });
  add_push("the damper", 1, [=](S s, C c) { return lets_go(s, c) ? 0 : damper(s, c); });

  add_push("the pull that push_only forbids", 0,
           [=](S s, C c) { return lets_go(s, c) ? spring(s, c) + damper(s, c) : 0; });
  add_push("a spring without its damper, where push_only lets go", 0,
           [=](S s, C c) { return lets_go(s, c) ? spring(s, c) : 0; });
  add_push("the damper, where the contact is push_only", 0,
           [=](S s, C c) { return s.push_only && !lets_go(s, c) ? damper(s, c) : 0; });
  all.back().inside = true;
  add_push("the size of the velocity, c |v|", 0,
           [](S s, C c) { return -s.damping * std::abs(c.away); });
  add_push("c v^2", 0, [](S s, C c) { return -s.damping * c.away * c.away; });
  add_push("k v (stiffness for damping)", 0, [](S s, C c) { return -s.stiffness * c.away; });
  add_push("v, without the damping", 0, [](S, C c) { return -c.away; });
  add_push("c times the overlap", 0, [](S s, C c) { return s.damping * c.overlap; });
  add_push("c times the radius", 0, [](S s, C) { return s.damping * s.radius; });
  add_push("k times the radius", 0, [](S s, C) { return s.stiffness * s.radius; });
  all.back().inside = true;
  add_push("the overlap, without the stiffness", 0, [](S, C c) { return c.overlap; });
  add("a spring in the air", 0,
      [=](S s, C c, M) { return times(c.touches ? 0 : spring(s, c), c.direction); });
  add("a damper in the air", 0,
      [=](S s, C c, M) { return times(c.touches ? 0 : damper(s, c), c.direction); });
  add("g, without the mass", 0, [](S s, C, M) { return up(-s.gravity); });
  add("the number 9.81, times the mass", 0, [](S s, C, M) { return up(-9.81 * s.mass); });
  add_push("2 sqrt(k m) v (the critical damping)", 0,
           [](S s, C c) { return -2 * std::sqrt(s.stiffness * s.mass) * c.away; });
  for (const std::size_t axis : {0u, 1u, 2u}) {
    static const char* braked[] = {"c times v_x", "c times v_y", "c times v_z"};
    static const char* along[] = {"the whole push, along x,", "the whole push, along y,",
                                  "the whole push, along z,"};
    add(on_a_line && axis == 1 ? "c times v" : braked[axis], 0, [=](S s, C c, M m) {
      return times(c.touches ? -s.damping * m.motion.velocity[axis] : 0, c.direction);
    });
    add(along[axis], 0, [=](S s, C c, M) {
      Triple push{};
      push[axis] = c.touches && !lets_go(s, c) ? spring(s, c) + damper(s, c) : 0;
      return push;
    });
  }
  add("a constant of 1 N", 0, [](S, C, M) { return up(1); });
  add("m g along x", 0, [](S, C, M m) { return Triple{-m.weight(), 0, 0}; });
  add("m g along z", 0, [](S, C, M m) { return Triple{0, 0, -m.weight()}; });
  add("m g along the push's direction", 0,
      [](S, C c, M m) { return times(-m.weight(), c.direction); });
  add("c times the velocity along the floor", 0, [](S s, C c, M m) {
    const Triple& v = m.motion.velocity;
    return times(c.touches ? -s.damping : 0, plus(v, c.direction, -dot(v, c.direction)));
  });
  add("c times the velocity along x", 0, [](S s, C c, M m) {
    return Triple{c.touches ? -s.damping * m.motion.velocity[0] : 0, 0, 0};
  });
  add("c times the speed |v|, whatever its direction", 0, [](S s, C c, M m) {
    return times(c.touches ? -s.damping * length(m.motion.velocity) : 0, c.direction);
  });
  return all;
}

/// The limit of push_only is on the whole force: in contact, or everywhere.
template <class ContactOf>
std::vector<Suspect<Moment>> limits_the_weight(ContactOf contact) {
  std::vector<Suspect<Moment>> all;
  for (const bool everywhere : {false, true}) {
    all.push_back({"push_only limits the weight, too",
                   "the limit is for the push of spring and damper only; gravity stays: take "
                   "std::max(0.0, push) before you add it to the force.",
                   [=](const Moment& m) {
                     const Contact c = contact(m);
                     Setting pulls = m.setting;
                     pulls.push_only = false;
                     Triple force = plus(up(-m.weight()), c.direction,
                                         c.touches ? push(pulls, c.overlap, c.away) : 0);
                     if (m.setting.push_only && (c.touches || everywhere))
                       force[1] = std::max(0.0, force[1]);
                     return force;
                   }});
  }
  return all;
}

/// What a force is multiplied with by mistake.
template <class Probe, class ContactOf, class MomentOf>
auto force_factors(ContactOf contact, MomentOf moment) {
  std::vector<std::pair<std::string, std::function<double(const Probe&)>>> all;
  all.push_back({"the mass", [=](const Probe& p) { return moment(p).setting.mass; }});
  all.push_back({"the radius", [=](const Probe& p) { return moment(p).setting.radius; }});
  all.push_back({"gravity", [=](const Probe& p) { return moment(p).setting.gravity; }});
  all.push_back({"the overlap", [=](const Probe& p) { return contact(p).overlap; }});
  all.push_back({"the square root of the overlap",
                 [=](const Probe& p) { return std::sqrt(std::max(0.0, contact(p).overlap)); }});
  all.push_back({"the velocity", [=](const Probe& p) { return contact(p).away; }});
  all.push_back({"t", [=](const Probe& p) { return moment(p).t; }});
  return all;
}

}  // namespace bounce::check
