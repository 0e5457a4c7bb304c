#pragma once
// The lines that cost the time. Read them as if V were `double`; where it is a vector, they do
// several balls side by side.

#include "many_balls/lanes.hpp"
#include "many_balls/pass.hpp"

namespace bounce::many {
namespace {

template <class V>
struct Triple {
  V x, y, z;
};

/// The force of spring and damper that pushes the two apart, as SpringDamper::force.
// [push]
template <class V>
inline V push(const SpringDamper& law, const V& overlap, const V& separation_speed) {
  V force = law.stiffness * overlap - law.damping * separation_speed;
  if (law.law == ContactLaw::push_only) force = select(force > 0, force, V(0));
  return select(overlap > 0, force, V(0));
}
// [push]

/// Gravity, floor and walls.
template <class V>
inline Triple<V> outer_force(const Laws& laws, const Triple<V>& p, const Triple<V>& v,
                             const V& mass, const V& r) {
  Triple<V> force{V(0), V(0) - mass * laws.gravity, V(0)};
  if (laws.floor) force.y += push<V>(laws.surfaces, r - p.y, v.y);
  if (laws.tray[0] > 0) {
    force.x += push<V>(laws.surfaces, r - p.x, v.x);
    force.x -= push<V>(laws.surfaces, r - (laws.tray[0] - p.x), -v.x);
  }
  if (laws.tray[1] > 0) {
    force.z += push<V>(laws.surfaces, r - p.z, v.z);
    force.z -= push<V>(laws.surfaces, r - (laws.tray[1] - p.z), -v.z);
  }
  return force;
}

/// How two balls lie to each other.
template <class V>
struct Distance {
  Triple<V> between;  // from the centre of the second to that of the first
  V d;
};

/// Centres that coincide have no direction between them: the ball with the lower number goes up.
template <class V>
Distance<V> separated(const Pass& pass, Slot first, const Slot* neighbours, Distance<V> of) {
  alignas(64) double x[group], y[group], z[group], d[group];
  for (Slot n = 0; n < width<V>; ++n) {
    const bool is_apart = lane(of.d, n) > 1e-100;
    // (Nobody, who has no number, is always apart.)
    const bool is_lower = !is_apart && pass.number[first + n] < pass.number[neighbours[n]];
    x[n] = is_apart ? lane(of.between.x, n) : 0;
    y[n] = is_apart ? lane(of.between.y, n) : (is_lower ? 1 : -1);
    z[n] = is_apart ? lane(of.between.z, n) : 0;
    d[n] = is_apart ? lane(of.d, n) : 1;
  }
  return {{from_array<V>(x), from_array<V>(y), from_array<V>(z)}, from_array<V>(d)};
}

/// The balls from one slot on, as many as V is wide, and all forces on them.
template <class V, bool equal_radii>
class Forces {
 public:
  Forces(const Pass& pass, Slot first, const Triple<V>& p, const Triple<V>& v, const V& mass,
         const V& r)
      : pass_(pass),
        records_(&pass.from->x),
        first_(first),
        p_(p),
        v_(v),
        r_(r),
        sum_(outer_force<V>(pass.laws, p, v, mass, r)),
        has_tiny_(any(smaller(smaller(magnitude(p.x), magnitude(p.y)), magnitude(p.z)) < 1e-250)) {}

  // The square roots of one row are begun before the divisions of the row before it: otherwise the
  // processor would wait for each in turn.
  // [forces]
  Triple<V> all() {
    const Slot* row = begin_of(first_ / group);
    const Slot* end = begin_of(first_ / group + 1);
    if (row == end) return sum_;
    Seen now = look(row);
    for (row += group; row != end; row += group) {
      const Slot* later = row + rows_ahead * group;
      for (Slot n = 0; n < width<V>; ++n) ask_for(pass_.from + later[n]);
      const Seen next = look(row);
      add(now);
      now = next;
    }
    add(now);
    return sum_;
  }
  // [forces]

 private:
  /// A row of neighbours, one for each of our balls.
  struct Seen {
    const Slot* slots;
    Distance<V> distance;
    V vx;
  };

  const Slot* begin_of(Slot a_group) const {
    return pass_.neighbours + std::size_t{pass_.row[a_group]} * group + first_ % group;
  }

  // [look]
  Seen look(const Slot* slots) const {
    Triple<V> p2;
    V vx;
    load_pair(records_, slots, p2.x, p2.y);
    load_pair(records_ + 2, slots, p2.z, vx);
    const Triple<V> between{p_.x - p2.x, p_.y - p2.y, p_.z - p2.z};
    const V square = between.x * between.x + (between.y * between.y + between.z * between.z);
    return {slots, {between, square_root(square)}, vx};
  }
  // [look]

  // [add]
  void add(const Seen& seen) {
    const V overlap = touch(seen.slots) - seen.distance.d;
    Distance<V> to = seen.distance;
    if (any(to.d <= 1e-100)) [[unlikely]]
      to = separated<V>(pass_, first_, seen.slots, to);
    const Triple<V> e12 = direction(to);
    V vy, vz;
    load_pair(records_ + 4, seen.slots, vy, vz);
    const V separation_speed =
        (v_.x - seen.vx) * e12.x + ((v_.y - vy) * e12.y + (v_.z - vz) * e12.z);
    const V force = push<V>(pass_.laws.between_balls, overlap, separation_speed);
    sum_.x += force * e12.x;
    sum_.y += force * e12.y;
    sum_.z += force * e12.z;
  }
  // [add]

  // Three divisions by the same number: one will do, where `quotient` may be used.
  Triple<V> direction(const Distance<V>& to) const {
    const auto& [x, y, z] = to.between;
    if (has_tiny_) [[unlikely]]
      return {x / to.d, y / to.d, z / to.d};
    const V per_d = 1 / to.d;
    return {quotient(x, to.d, per_d), quotient(y, to.d, per_d), quotient(z, to.d, per_d)};
  }

  /// At which distance they touch. Equal radii save the loading of the neighbours' own.
  V touch(const Slot* slots) const {
    if (equal_radii) return V(pass_.touch);
    V mass2, r2;
    load_pair(records_ + 6, slots, mass2, r2);
    return r2 + r_;
  }

  const Pass& pass_;
  const double* records_;
  Slot first_;
  Triple<V> p_, v_;
  V r_;
  Triple<V> sum_;
  // A difference of two coordinates is 0, or at least the rounding of either: never below 1e-270 m
  // where ours are above 1e-250 m.
  bool has_tiny_;
};

/// One pass for as many balls as V is wide. Returns the squares of their speeds.
template <class V, bool equal_radii>
inline V move(const Pass& pass, Slot first) {
  constexpr Slot in_a_row[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const double* own = &pass.from[first].x;
  Triple<V> p, v;
  V mass, r;
  load_pair(own, in_a_row, p.x, p.y);
  load_pair(own + 2, in_a_row, p.z, v.x);
  load_pair(own + 4, in_a_row, v.y, v.z);
  load_pair(own + 6, in_a_row, mass, r);

  Triple<V> a = Forces<V, equal_radii>(pass, first, p, v, mass, r).all();
  a = {a.x / mass, a.y / mass, a.z / mass};
  if (pass.acceleration != nullptr) {
    for (Slot n = 0; n < width<V>; ++n) {
      double* out = pass.acceleration + std::ptrdiff_t{3} * pass.number[first + n];
      out[0] = lane(a.x, n), out[1] = lane(a.y, n), out[2] = lane(a.z, n);
    }
  }
  for (int i = 0; i < pass.kicks; ++i) {
    v = {v.x + a.x * pass.kick, v.y + a.y * pass.kick, v.z + a.z * pass.kick};
  }
  p = {p.x + v.x * pass.drift, p.y + v.y * pass.drift, p.z + v.z * pass.drift};

  double* out = &pass.to[first].x;
  store_pair(out, p.x, p.y);
  store_pair(out + 2, p.z, v.x);
  store_pair(out + 4, v.y, v.z);
  store_pair(out + 6, mass, r);
  return v.x * v.x + (v.y * v.y + v.z * v.z);
}

template <class V, bool equal_radii>
double move_all(const Pass& pass, Slot first, Slot last) {
  V fastest(0);
  for (; first + width<V> <= last; first += width<V>) {
    const V speed = move<V, equal_radii>(pass, first);
    fastest = select(speed > fastest, speed, fastest);
  }
  double result = largest(fastest);
  for (; first < last; ++first) {  // the few that are left over
    result = std::fmax(result, move<double, equal_radii>(pass, first));
  }
  return result;
}

template <class V>
double move_all(const Pass& pass, Slot first, Slot last) {
  return pass.touch > 0 ? move_all<V, true>(pass, first, last)
                        : move_all<V, false>(pass, first, last);
}

}  // namespace
}  // namespace bounce::many
