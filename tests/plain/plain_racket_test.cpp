// Stage 8's program on one page against the stage's program, which flies by formula, finds each
// touch and cuts the contact into some 3000 pieces: beside the plain loop it is as good as exact.
// How far the two may be apart is derived here, phase by phase.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "trace.hpp"

using namespace bounce::test;

namespace {

constexpr double m = 1, g = 9.81, r = 0.1, k = 1e4, c = 14.17, dt = 1e-3;
constexpr double drop = 0.6015 - r, rises = 0.1, slides = 0.06;  // m, m/s, m/s
constexpr double from_rim = 0.25 + 0.3;  // m: from the ball's place at the start to the last rim
constexpr double rounding = 1e-11;  // of 10 000 sums of numbers of size 1: at most 1e4 * 1.1e-16

const double omega = std::sqrt(k / m), beta = c / (2 * m);
const double restitution = std::exp(-beta * std::acos(-1.0) / std::sqrt(k / m - beta * beta));

struct Bound {
  double position;  // m
  double velocity;  // m/s
};

/// The first touch, and the relative speed there: drop - g t^2 / 2 = rises t.
const double speed = std::sqrt(rises * rises + 2 * g * drop);
const double first_touch = (speed - rises) / g;

/// In each contact, the loop sees the touch up to one step late, and so the end of it. What it
/// misses there, or has too much, is one step of the contact's force, at most c w + k w dt.
/// (Gravity it never misses. In between it is of second order: it is the leapfrog method, its
/// velocity half a step old.) As a share of the relative speed w:
constexpr double share = 2 * (c + k * dt) * dt / m;

/// The last bounce is over. One bounce to the next, the speed is at most q times as large: flight
/// gives nothing, as the plain loop falls g dt t / 2 too far in the time t and so comes in slower.
/// The hops last 2 w / g each, the contacts half a period and two steps each. Below w = g / (2
/// omega) the ball no longer lifts off.
double last_bounce() {
  const double q = restitution + share;
  const double bounces = std::ceil(std::log(speed / (g / (2 * omega))) / -std::log(q));
  const double hops = 2 * q * speed / (g * (1 - q));
  return first_touch + hops + bounces * (std::acos(-1.0) / omega + 2 * dt);
}

/// The rim passes under the ball, which slips off: an inverted pendulum of length r that starts
/// with the rim's speed. It leaves the rim before its angle a has cos a = 2/3, and until then sin a
/// is more than 0.88 a, so that the angle grows at least like sinh(rate t).
const double rim_comes = from_rim / slides;
double slip_time() {
  const double rate = std::sqrt(0.88 * g / r);
  return std::asinh(std::acos(2.0 / 3.0) * r * rate / slides) / rate;
}

Bound bound(double t) {
  // Falling: velocity first, then position, falls too far by g dt t / 2.
  if (t < first_touch - dt) return {g * dt * t / 2 + rounding, rounding};

  // In the first contact and the hop after it. A ball that turns round two steps earlier or later
  // is off by 2 w times that; after that the speeds differ by share w. The velocity may have turned
  // in the one and not in the other.
  const double second_touch = first_touch + 2 * (restitution - share) * speed / g;
  if (t < second_touch) {
    return {2 * speed * 2 * dt + share * speed * (t - first_touch), 2 * speed};
  }

  // Then the hops are out of time, but both balls are somewhere between the deepest overlap, w /
  // omega, and the top of the first hop.
  const double lifts = (restitution + share) * speed;
  if (t < last_bounce()) return {lifts * lifts / (2 * g) + speed / omega, 2 * speed};

  // At rest on the racket: two oscillations die out that began with at most sqrt(2) m g / k.
  if (t < rim_comes) {
    const double swing =
        2 * std::sqrt(2.0) * g / (omega * omega) * std::exp(-beta * (t - last_bounce()));
    return {swing + rounding, swing * omega + rounding};
  }

  // Slipping off: no acceleration is above g, so a velocity that is half a step old is off by g dt
  // / 2, and letting go one step late costs no more than that again. Errors grow like the
  // pendulum's angle, exp(sqrt(g / r) t) at most, until the ball has left the rim, and in the fall
  // evenly.
  const double grows = std::sqrt(g / r), on_rim = std::min(t - rim_comes, slip_time());
  const double velocity = g * dt * std::cosh(grows * on_rim);
  const double falls = t - rim_comes - on_rim;
  return {g * dt * std::sinh(grows * on_rim) / grows + velocity * falls + rounding, velocity};
}

/// "--player none --set ..." as the page's own comment says it.
std::string settings_on_page() {
  std::string words;
  std::istringstream lines(text_of_page("08_racket_game"));
  for (std::string line; std::getline(lines, line) && line.starts_with("//");) {
    if (const auto at = line.find("--"); at != std::string::npos) words += " " + line.substr(at);
  }
  return words;
}

double distance(const std::vector<double>& one, const std::vector<double>& other, std::size_t at) {
  return std::hypot(one[at] - other[at], one[at + 1] - other[at + 1], one[at + 2] - other[at + 2]);
}

}  // namespace

TEST_CASE("stage 8's plain program is as near to the stage's program as its first order allows") {
  const Trace plain = trace_of("08_racket_game_plain");
  const Trace stage = trace_of("08_racket_game" + same_method + settings_on_page());
  CHECK(plain.header == stage.header);
  REQUIRE(plain.rows.size() == 10001);
  REQUIRE(stage.rows.size() == plain.rows.size());
  for (std::size_t n = 0; n < plain.rows.size(); ++n) {
    const std::vector<double>&one = plain.rows[n], &other = stage.rows[n];
    REQUIRE(one.size() == 7);
    REQUIRE(other.size() == 7);
    const double t = one[0];
    CAPTURE(t);
    REQUIRE(t == other[0]);
    REQUIRE(distance(one, other, 1) <= bound(t).position);
    REQUIRE(distance(one, other, 4) <= bound(t).velocity);
  }
  // And the scene is what the page says it is: it bounces, lies on the racket, and is off in the
  // end.
  const auto height_over_racket = [&](std::size_t n) {
    return stage.rows[n][2] - rises * stage.rows[n][0];
  };
  CHECK(height_over_racket(600) > 2 * r);
  CHECK(height_over_racket(9000) == doctest::Approx(r - m * g / k).epsilon(1e-9));
  CHECK(height_over_racket(10000) < -1);
  CHECK(stage.rows[10000][1] > r);
}
