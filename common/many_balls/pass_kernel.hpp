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
V push(const SpringDamper& law, const V& overlap, const V& separation_speed) {
  V force = law.stiffness * overlap - law.damping * separation_speed;
  if (law.law == ContactLaw::push_only) force = select(force > 0, force, V(0));
  return select(overlap > 0, force, V(0));
}
// [push]

/// Gravity, floor and walls.
template <class V>
Triple<V> outer_force(const Laws& laws, const Triple<V>& p, const Triple<V>& v, const V& mass,
                      const V& r) {
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

/// Centres that coincide have no direction between them: the ball with the lower number goes up.
template <class V>
void separate(const Pass& pass, Slot first, const Slot* neighbours, Triple<V>& between, V& d) {
  alignas(64) double x[group], y[group], z[group], distance[group];
  for (Slot n = 0; n < width<V>; ++n) {
    const bool apart = lane(d, n) > 1e-100;
    const bool is_lower = pass.number[first + n] < pass.number[neighbours[n]];
    x[n] = apart ? lane(between.x, n) : 0;
    y[n] = apart ? lane(between.y, n) : (is_lower ? 1 : -1);
    z[n] = apart ? lane(between.z, n) : 0;
    distance[n] = apart ? lane(d, n) : 1;
  }
  between = {from_array<V>(x), from_array<V>(y), from_array<V>(z)};
  d = from_array<V>(distance);
}

/// All forces on the balls in the slots from `first` on, as many as V is wide. Equal radii (their
/// sum is `pass.touch`) save the loading of the neighbours' own.
// [forces]
template <class V, bool equal_radii>
Triple<V> forces(const Pass& pass, Slot first, const Triple<V>& p, const Triple<V>& v,
                 const V& mass, const V& r) {
  Triple<V> force = outer_force<V>(pass.laws, p, v, mass, r);
  const double* records = &pass.from->x;
  for (Slot row = pass.row[first / group]; row < pass.row[first / group + 1]; ++row) {
    const Slot* neighbours = pass.neighbours + std::size_t{row} * group + first % group;
    Triple<V> p2, v2;
    load_pair(records, neighbours, p2.x, p2.y);
    load_pair(records + 2, neighbours, p2.z, v2.x);
    Triple<V> between{p.x - p2.x, p.y - p2.y, p.z - p2.z};
    V d = square_root(between.x * between.x + (between.y * between.y + between.z * between.z));
    V touch(pass.touch), mass2;
    if (!equal_radii) {
      load_pair(records + 6, neighbours, mass2, touch);
      touch += r;
    }
    const V overlap = touch - d;
    if (!any(overlap > 0)) continue;  // none of these pairs touches
    if (any(d <= 1e-100)) separate(pass, first, neighbours, between, d);
    const Triple<V> e12{between.x / d, between.y / d, between.z / d};
    load_pair(records + 4, neighbours, v2.y, v2.z);
    const V separation_speed = (v.x - v2.x) * e12.x + ((v.y - v2.y) * e12.y + (v.z - v2.z) * e12.z);
    const V pushes = push(pass.laws.between_balls, overlap, separation_speed);
    force.x += pushes * e12.x;
    force.y += pushes * e12.y;
    force.z += pushes * e12.z;
  }
  return force;
}
// [forces]

/// One pass for as many balls as V is wide. Returns the squares of their speeds.
template <class V, bool equal_radii>
V move(const Pass& pass, Slot first) {
  constexpr Slot in_a_row[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const double* own = &pass.from[first].x;
  Triple<V> p, v;
  V mass, r;
  load_pair(own, in_a_row, p.x, p.y);
  load_pair(own + 2, in_a_row, p.z, v.x);
  load_pair(own + 4, in_a_row, v.y, v.z);
  load_pair(own + 6, in_a_row, mass, r);

  Triple<V> a = forces<V, equal_radii>(pass, first, p, v, mass, r);
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
