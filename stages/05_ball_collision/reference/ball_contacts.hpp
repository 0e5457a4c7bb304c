#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "05_ball_collision/ball_collision.hpp"
#include "05_ball_collision/reference/near_pairs.hpp"
#include "05_ball_collision/reference/touching.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

/// Who touches whom among many balls, in the form that `Reference` (reference_walk.hpp) asks
/// for. There is no formula for a contact off centre, nor for three balls that touch at a time; but
/// as long as nobody new touches and nobody lets go, the law is smooth.
///
/// Balls that lie or move together are apart, or overlap, by no more than rounding, and the sign of
/// that is chance. So each change has to be larger than the rounding of what tells it. Nothing is
/// lost by that: at overlap 0 a spring's force begins with 0, and a damper's with -c v; and two
/// that have a speed against each other do not stay within rounding.
class BallContacts {
 public:
  /// Two balls that run through each other, centre through centre.
  static constexpr bool jumps_without_event = true;
  static constexpr bool is_crowd = true;

  using Balls = State<Eigen::Matrix3Xd>;
  struct Event {
    ContactPair two;
    Phase next;
    /// Two meet or part: the gap tells. Else one lets go, or takes hold again: the force tells.
    bool is_of_gap() const { return two.phase == Phase::flight || next == Phase::flight; }
  };

  BallContacts(const BallCollision& scene, const Balls& balls)
      : scene_(scene), pair_law_(scene.pair_contact()), floor_law_(scene.floor_contact()) {
    near_.for_each(scene_, balls, 0, [&](ContactPair two) {
      const Gap gap = gap_of(scene_, two, balls);
      if (!(gap.gap < 0)) return;
      const bool pulls = lets_go(two) && force(law_of(two), gap.gap, gap.speed) <= 0;
      two.phase = pulls ? Phase::let_go : Phase::touch;
      held_.push_back(two);
    });
  }

  bool in_flight() const { return held_.empty(); }

  /// The surfaces first; then the pairs, from near to far. All balls fall alike, so that two that
  /// come together within `first` seconds are now no further apart than they close in that time.
  double flight_time(double /*t*/, const Balls& balls) {
    double first = never;
    const auto consider = [&](const ContactPair& two) {
      const double time = time_to_touch(scene_, two, balls);
      if (!(time < first)) return;
      first = time;
      lands_ = two;
    };
    for_each_surface(scene_, balls.position, never, consider);
    const Eigen::Vector3d together = balls.velocity.rowwise().mean();
    const double closing = 2 * (balls.velocity.colwise() - together).colwise().norm().maxCoeff();
    const double spread =
        (balls.position.rowwise().maxCoeff() - balls.position.rowwise().minCoeff()).norm();
    for (double range = scene_.radius.minCoeff();; range *= 4) {
      near_.for_each(scene_, balls, range, [&](const ContactPair& two) {
        if (!two.is_surface()) consider(two);
      });
      if (!(first * closing > range && range < spread)) return first;
    }
  }

  Balls fly(const Balls& balls, double t) const { return bounce::fly(balls, scene_.gravity, t); }
  void land(double t, Balls& balls) { pass({lands_, Phase::touch}, t, balls); }

  /// Gravity, and the forces of those that touch now, whatever their overlap.
  const Eigen::Matrix3Xd& acceleration(double /*t*/, const Balls& balls) const {
    acceleration_.setZero(3, scene_.mass.size());  // the forces, at first
    for (const ContactPair& two : held_) {
      if (two.phase != Phase::touch) continue;
      const int i = two.first, j = two.second;
      if (two.is_surface()) {
        const Gap gap = gap_of(scene_, two, balls);
        acceleration_(two.axis, i) += two.sign * force(floor_law_, gap.gap, gap.speed);
        continue;
      }
      // As in gap_of(), but this is where the time goes: a root, a division, and nothing stored.
      const Eigen::Vector3d between = balls.position.col(i) - balls.position.col(j);
      const double d = between.norm();
      Eigen::Vector3d e12 = Eigen::Vector3d::UnitY();
      if (d > 1e-100) e12 = between * (1 / d);
      const double speed = dot(balls.velocity.col(i) - balls.velocity.col(j), e12);
      const double push = force(pair_law_, d - scene_.radius[i] - scene_.radius[j], speed);
      acceleration_.col(i) += push * e12;
      acceleration_.col(j) -= push * e12;
    }
    for (Eigen::Index i = 0; i < scene_.mass.size(); ++i)
      acceleration_.col(i) *= 1 / scene_.mass[i];
    acceleration_.row(1).array() -= scene_.gravity;
    return acceleration_;
  }

  const std::vector<Event>& events(const Balls& balls, double h) {
    // Nobody gets faster than this, or the step is refused. Two that are further apart than they
    // can close at such speeds are not watched, nor two that overlap by more than that.
    top_speed_ = 2 * balls.velocity.colwise().norm().transpose();
    top_speed_.array() += scene_.radius.minCoeff() / 200 / h;
    events_.clear();
    for (const ContactPair& two : held_) {
      const bool touch = two.phase == Phase::touch, can_let_go = touch && lets_go(two);
      if (can_let_go || !touch) events_.push_back({two, touch ? Phase::let_go : Phase::touch});
      if (can_let_go || !are_apart(scene_, two, balls.position, -h * top_rate(two))) continue;
      events_.push_back({two, Phase::flight});
    }
    auto held = held_.begin();
    near_.for_each(scene_, balls, 2 * h * top_speed_.maxCoeff(), [&](const ContactPair& two) {
      if (are_apart(scene_, two, balls.position, h * top_rate(two))) return;
      while (held != held_.end() && *held < two) ++held;
      if (held == held_.end() || two < *held) events_.push_back({two, Phase::touch});
    });
    return events_;
  }

  EventValue event_value(const Event& event, double /*t*/, const Balls& balls,
                         const Eigen::Matrix3Xd& acceleration) const {
    const ContactPair& two = event.two;
    const Gap gap = gap_of(scene_, two, balls);
    if (two.phase == Phase::flight) return {gap.gap, gap.speed};
    if (event.next == Phase::flight) return {-gap.gap, -gap.speed};
    // From touch to let go, and back: the sign of the force. Balls that turn about each other get
    // away from each other by that, too: the speed aside squared over the distance.
    Eigen::Vector3d a = acceleration.col(two.first);
    if (!two.is_surface()) a -= acceleration.col(two.second);
    const Eigen::Vector3d aside = gap.velocity - gap.speed * gap.direction;
    const double turning = aside.squaredNorm() / gap.distance;  // none beside a surface
    const SpringDamper law = law_of(two);
    const double rate =
        -law.stiffness * gap.speed - law.damping * (dot(a, gap.direction) + turning);
    const double sign = two.phase == Phase::touch ? 1 : -1;
    return {sign * force(law, gap.gap, gap.speed), sign * rate};
  }

  /// By how much the value of event_value() may be off.
  double rounding(const Event& event, const Balls& balls) const {
    const ContactPair& two = event.two;
    const double of_gap = rounding_of_gap(scene_, two, balls);
    if (event.is_of_gap()) return of_gap;
    const SpringDamper law = law_of(two);
    double speeds = balls.velocity.col(two.first).cwiseAbs().maxCoeff();
    if (!two.is_surface()) speeds += balls.velocity.col(two.second).cwiseAbs().maxCoeff();
    return law.stiffness * of_gap +
           law.damping * 8 * std::numeric_limits<double>::epsilon() * speeds;
  }

  double top_rate(const Event& event) const {
    return event.is_of_gap() ? top_rate(event.two) : never;
  }

  /// Nobody comes from outside the range; and two that do not touch do not pass each other unseen.
  bool resolves(const Balls& before, const Balls& after, double h) const {
    if (!(after.velocity.colwise().norm().transpose().array() <= top_speed_.array()).all()) {
      return false;
    }
    for (const auto& [two, next] : events_) {
      if (two.phase == Phase::touch || two.is_surface()) continue;
      const double reach = scene_.radius[two.first] + scene_.radius[two.second];
      if (h * top_rate(two) <= 0.25 * reach) continue;
      const Gap start = gap_of(scene_, two, before), end = gap_of(scene_, two, after);
      const double path = h * std::max(start.velocity.norm(), end.velocity.norm());
      if (path > 0.25 * reach && 1.5 * path > start.gap + end.gap) return false;
    }
    return true;
  }

  void pass(const Event& event, double /*t*/, Balls& balls) {
    ContactPair two = event.two;
    if (two.is_surface() && event.is_of_gap()) {  // then the distance is known exactly
      balls.position(two.axis, two.first) =
          wall_of(scene_, two) + two.sign * scene_.radius[two.first];
    }
    const auto place = std::lower_bound(held_.begin(), held_.end(), two);
    two.phase = event.next;
    if (event.two.phase == Phase::flight) {
      held_.insert(place, two);
    } else if (event.next == Phase::flight) {
      held_.erase(place);
    } else {
      *place = two;
    }
  }

  /// Of the lightest ball, on the stiffest contact [s].
  double time_scale() const {
    const double k = std::max(scene_.stiffness, scene_.floor_stiffness);
    const double c = std::max(scene_.damping, scene_.floor_damping);
    const double lightest = scene_.mass.minCoeff();
    return 1 / (natural_frequency(k, lightest) + c / lightest);
  }

  /// Who touches or has let go.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    if constexpr (Visit::reads) self.held_.resize(visit.left() / 5);
    for (auto& two : self.held_) {
      visit.whole("who touches", two.first, 0, self.scene_.mass.size() - 1);
      visit.whole("who touches", two.second, -1, self.scene_.mass.size() - 1);
      visit.whole("who touches", two.axis, 0, 2);
      visit.whole("who touches", two.sign, -1, 1);
      visit.whole("who touches", two.phase, 1, 2);
    }
    if constexpr (Visit::reads) std::sort(self.held_.begin(), self.held_.end());
  }

 private:
  const SpringDamper& law_of(const ContactPair& two) const {
    return two.is_surface() ? floor_law_ : pair_law_;
  }
  static double force(const SpringDamper& law, double gap, double speed) {
    return -law.stiffness * gap - law.damping * speed;  // also where it would pull
  }
  bool lets_go(const ContactPair& two) const {
    const SpringDamper law = law_of(two);
    return law.law == ContactLaw::push_only && law.damping > 0;
  }

  /// How fast two can come together, or part [m/s].
  double top_rate(const ContactPair& two) const {
    return top_speed_[two.first] + (two.is_surface() ? 0 : top_speed_[two.second]);
  }

  BallCollision scene_;
  SpringDamper pair_law_, floor_law_;
  std::vector<ContactPair> held_;  // those that touch or have let go, in order
  std::vector<Event> events_;
  Eigen::VectorXd top_speed_;  // m/s: of each ball, within a step
  ContactPair lands_{};        // who ends the flight
  NearPairs near_;
  mutable Eigen::Matrix3Xd acceleration_;
};

}  // namespace bounce
