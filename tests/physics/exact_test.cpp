// The event-driven exact solution against 50-digit values and against laws that it does not use.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "03_damping/exact.hpp"
#include "physics/events/event_driven.hpp"
#include "random_numbers.hpp"
#include "reference_values.hpp"

using namespace bounce;
using test::ReferenceValue;

namespace {

using Walker = EventDriven<BouncePhases>;

Walker start(const ReferenceValue& r) {
  return {BouncePhases{r.mass, r.gravity, r.radius, {r.stiffness, r.damping, r.law}},
          0,
          {r.position, r.velocity}};
}

}  // namespace

TEST_CASE("exact agrees with 50 digits") {
  for (const ReferenceValue& r : test::reference_values) {
    const State<double> state = start(r).at(r.t);
    CAPTURE(r.stiffness);
    CAPTURE(r.damping);
    CAPTURE(int(r.law));
    CAPTURE(r.t);
    // Rounding only: every event's time is off by up to 1e-16 s for each second passed, which a
    // ball of 5 m/s turns into 5e-16 m; ten events or so add up. In contact the acceleration, up to
    // 4e3 m/s^2, turns it into 1e-14 of the speed. Small cases are judged relative to their size.
    const double size = std::min(1.0, r.position), speed = std::sqrt(2 * 9.81 * size);
    CHECK(std::abs(state.position - r.y) < 4e-15 * size);
    CHECK(std::abs(state.velocity - r.v) < 2e-14 * speed);
  }
}

TEST_CASE("a perfect spring returns the ball to its height, for ever") {
  const ReferenceValue ball{1, 9.81, 0.1, 1e4, 0, ContactLaw::may_pull, 1, 0, 0, 0, 0};
  Walker walker = start(ball);
  for (int bounce = 0; bounce < 3000; ++bounce) {
    walker.pass_event();  // touch
    const double speed = walker.state_at_last_event().velocity;
    walker.pass_event();  // lift-off
    // From 0.9 m of fall, sqrt(2 g h); and it leaves as fast as it came, to the last bit.
    CHECK(speed == -std::sqrt(2 * 9.81 * 0.9));
    CHECK(walker.state_at_last_event().velocity == -speed);
  }
}

TEST_CASE("a phase ends where its own formula says so, and not before") {
  // The search for the end must find the first crossing, whatever the regime, the speed and the
  // gravity (negative under an overhang), and tell the state there as move() does.
  std::mt19937 random(1);
  const auto between = [&](double a, double b) { return test::uniform(random, a, b); };
  int ends = 0, stays = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto law = i % 2 == 0 ? ContactLaw::may_pull : ContactLaw::push_only;
    const double zeta = i % 3 == 0   ? between(0, 3)
                        : i % 3 == 1 ? between(0, 0.3)
                                     : between(0.99, 1.01);
    const double g = i % 5 == 0 ? between(-20, 0) : between(0, 20);
    const double omega0 = 100, r = 0.1;
    const BouncePhases phases(1, g, r, {omega0 * omega0, 2 * zeta * omega0, law});
    const State<double> start{i % 4 == 0 ? r - between(0, 0.05) : r, -std::pow(10, between(-4, 1))};
    CAPTURE(i);
    CAPTURE(zeta);
    CAPTURE(g);
    const PhaseEnd end = phases.end_of(Phase::touch, start);
    const double last = end.after == never ? 1 : end.after;  // 1 s = 100 / omega0
    (end.after == never ? stays : ends) += 1;
    if (end.after < never) {
      const State<double> there = phases.move(Phase::touch, start, end.after);
      // Roundings of the time, 1e-16 of up to 2 pi / omega0, and of positions of size r; the
      // acceleration is at most omega0 (1 + 2 zeta) times the largest speed, zeta up to 3.
      const double speed = std::abs(start.velocity) + 5 + omega0 * 0.05;
      CHECK(std::abs(there.position - end.arrival.position) < 4e-15);
      CHECK(std::abs(there.velocity - end.arrival.velocity) < 2e-14 * speed);
    }
    const double k = omega0 * omega0, c = 2 * zeta * omega0;
    double highest = -1, weakest = 1;
    for (int n = 1; n < 100; ++n) {
      const State<double> now = phases.move(Phase::touch, start, last * n / 100);
      highest = std::max(highest, now.position);
      weakest = std::min(weakest, k * (r - now.position) - c * now.velocity);
    }
    CHECK(highest < r + 1e-16);  // a ball that touches with next to no speed stays this close
    if (law == ContactLaw::push_only) CHECK(weakest > -1e-12);
  }
  CHECK(ends > 5000);
  CHECK(stays > 5000);
}

TEST_CASE("a damped ball makes a finite number of contacts, and then stays for ever") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    const ReferenceValue ball{1, 9.81, 0.1, 1e4, 9.2, law, 1, 0, 0, 0, 0};  // zeta = 0.046
    Walker walker = start(ball);
    int contacts = 0;
    while (walker.next_event() < never && contacts < 1000) {
      walker.pass_event();
      if (walker.phase() == Phase::touch) ++contacts;
    }
    CAPTURE(int(law));
    CHECK(contacts > 20);
    CHECK(contacts < 60);
    // At rest the spring carries the weight; one evaluation, whatever the time.
    const State<double> later = walker.at(1e6);
    CHECK(later.position == doctest::Approx(0.1 - 9.81 / 1e4).epsilon(1e-15));
    CHECK(std::abs(later.velocity) < 1e-300);
  }
}

TEST_CASE("without gravity a damped contact has the restitution of the formula") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const double zeta : {0.0, 0.05, 0.3, 0.7, 0.98, 1.0, 1.5, 4.0}) {
      const double c = 2 * zeta * 100;  // k = 1e4, m = 1
      const ReferenceValue ball{1, 0, 0.1, 1e4, c, law, 0.3, -2, 0, 0, 0};
      Walker walker = start(ball);
      walker.pass_event();
      CHECK(walker.last_event() == doctest::Approx(0.1).epsilon(1e-14));  // 0.2 m at 2 m/s
      CAPTURE(zeta);
      CAPTURE(int(law));
      const double e = restitution({1e4, c, law}, 1);
      if (law == ContactLaw::may_pull && zeta >= 1) {
        CHECK(walker.next_event() == never);
        continue;
      }
      while (walker.phase() != Phase::flight && walker.next_event() < never) walker.pass_event();
      CHECK(walker.state_at_last_event().velocity ==
            doctest::Approx(2 * e).epsilon(1e-12).scale(1e-8));
    }
  }
}

TEST_CASE("a push-only contact that let go is taken up again when the force returns") {
  // From deep below the floor the ball is let go while it still overlaps. With a strong damper and
  // gravity it slows down inside the overlap, and the contact must push again: that happens when it
  // is let go with a speed between g c/k and about 1.5 g c/k.
  const ReferenceValue ball{1, 9.81, 0.1, 1e3, 200, ContactLaw::push_only, -0.33, 2.2, 0, 0, 0};
  Walker walker = start(ball);
  CHECK(walker.phase() == Phase::let_go);  // 1e3 x 0.43 - 200 x 2.2 < 0
  walker.pass_event();
  CHECK(walker.phase() == Phase::touch);
  const State<double> again = walker.state_at_last_event();
  CHECK(again.position < 0.1);
  CHECK(std::abs(1e3 * (0.1 - again.position) - 200 * again.velocity) < 1e-10);
}

TEST_CASE("events that do not advance time end the walk instead of hanging") {
  struct Stuck {
    Phase phase_at(const State<double>&) const { return Phase::flight; }
    State<double> move(Phase, const State<double>& s, double) const { return s; }
    PhaseEnd end_of(Phase phase, const State<double>&) const { return {1e-17, phase}; }
    State<double> at_event(Phase, Phase, State<double> s) const { return s; }
  };
  EventDriven<Stuck> walker(Stuck{}, 1, {0, 0});
  CHECK_THROWS_AS(walker.at(2), TimeStandsStill);
}

TEST_CASE("a spring that is far too soft to carry the ball is no trap") {
  // The spring of k = 1e-30 N/m would carry the ball 1e31 m below the floor: a formula that
  // measures from there has no digit left for the ball. Until it has sunk far, the ball just falls
  // on, braked by the damper alone: v' = -g - c v.
  for (const double k : {1e-30, 1e-12, 1e-6}) {
    for (const double c : {0.0, 1e-3, 1.0, 40.0}) {
      const ReferenceValue ball{1, 9.81, 0.1, k, c, ContactLaw::may_pull, 1, 0, 0, 0, 0};
      Walker walker = start(ball);
      walker.pass_event();
      const double touch = walker.last_event(), v0 = walker.state_at_last_event().velocity;
      for (const double t : {1e-3, 0.1, 0.7}) {
        const double share = c > 0 ? -std::expm1(-c * t) / c : t;  // int exp(-c t)
        const double fall = c > 0 ? (t - share) / c : t * t / 2;
        const State<double> now = walker.at(touch + t);
        CAPTURE(k);
        CAPTURE(c);
        CAPTURE(t);
        // The spring's own part is k d t^2 / 2m, with d below 4 m; the rest is rounding, of which
        // (t - share) / c has 1 / (c t) in relative size.
        const double rounding = 1e-14 * (1 + (c > 0 ? 1 / (c * t) : 0));
        CHECK(std::abs(now.position - (0.1 + v0 * share - 9.81 * fall)) < 2 * k + rounding);
        CHECK(std::abs(now.velocity - (v0 - (9.81 + c * v0) * share)) < 4 * k + rounding);
      }
    }
  }
}
