#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "random_numbers.hpp"

using namespace bounce;

namespace {

QuickContact<double> quick_contact_of(const OscillatingFloor& scene) {
  return quick_contact<double>(scene.contact, [&](auto member) { return scene.*member; });
}

std::vector<Bounce> exact_bounces(const OscillatingFloor& scene, int discarded, int kept) {
  ExactBounces exact(scene);
  std::vector<Bounce> bounces;
  for (int n = 0; n < discarded + kept; ++n) {
    const std::optional<Bounce> bounce = exact.next();
    if (!bounce) break;
    if (n >= discarded) bounces.push_back(*bounce);
  }
  return bounces;
}

}  // namespace

TEST_CASE("stage 6: sines, cosines and exponentials of quick bounces are the C library's") {
  std::mt19937_64 random(60);
  for (int n = 0; n < 100000; ++n) {
    const double angle = test::uniform(random, -1000, 1000), x = test::uniform(random, -0.25, 0.25);
    const Swing<double> swing = turn(angle);
    // The sine's last digit, and that of the reduced angle.
    REQUIRE(std::abs(swing.sine - std::sin(angle)) < 4e-16);
    REQUIRE(std::abs(swing.cosine - std::cos(angle)) < 4e-16);
    REQUIRE(std::abs(small_exponential(x) - std::exp(x)) < 5e-16);
    const double reduced = within_turn(angle);
    REQUIRE(reduced >= -1e-15);
    REQUIRE(reduced <= 2 * std::numbers::pi + 1e-15);
    REQUIRE(std::abs(std::sin(reduced) - std::sin(angle)) < 2e-15);
  }
}

TEST_CASE("stage 6: a quick bounce is the exact one, or it says that it is not sure") {
  std::mt19937_64 random(61);
  const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
  int sure = 0, tried = 0;
  for (; sure < 24000; ++tried) {
    OscillatingFloor scene;
    scene.contact = tried % 2 == 0 ? ContactLaw::may_pull : ContactLaw::push_only;
    scene.mass = std::exp(uniform(-3, 3));
    scene.stiffness = scene.mass * std::exp(uniform(std::log(1e3), std::log(1e7)));
    const double omega0 = natural_frequency(scene.stiffness, scene.mass);
    scene.damping = tried % 5 == 0 ? 0 : uniform(0, 0.399) * omega0 * scene.mass;
    scene.angular_frequency = std::exp(uniform(0, std::log(omega0 / 2)));
    scene.amplitude = 9.81 / std::pow(scene.angular_frequency, 2) * std::exp(uniform(-2, 2));
    REQUIRE(has_quick_contact(scene));
    const Touch<double> touch{uniform(0, 2 * std::numbers::pi), -std::exp(uniform(-5, 2))};
    const NextTouch<double> next = next_touch(quick_contact_of(scene), touch);
    if (!next.is_sure) continue;
    ++sure;

    ExactBounces exact(scene, touch, {0, 0, touch.velocity, {}, false});
    const std::optional<Bounce> bounce = exact.next();
    REQUIRE(bounce.has_value());
    const Touch<double> expected = exact.touch_after();
    // Heights are rounded at 1e-16 of their size, up to ten times. At the lift-off that is a
    // velocity of omega0 times as much, and a height of the flight's length times that. The gap
    // closes with the velocity of the touch: so much earlier or later it comes.
    const double size = scene.radius + scene.amplitude + std::abs(bounce->height);
    const double length = 2 * std::sqrt(2 * size / scene.gravity);
    const double rounding = 1e-15 * size * (1 + omega0 * length);
    const double turns = std::abs(next.touch.angle - expected.angle);
    const double late = std::min(turns, 2 * std::numbers::pi - turns) / scene.angular_frequency;
    const double most = scene.gravity + scene.amplitude * std::pow(scene.angular_frequency, 2);
    CAPTURE(tried);
    CAPTURE(touch.velocity);
    CAPTURE(expected.velocity);
    CHECK(std::abs(next.highest - bounce->height) < rounding);
    CHECK(late * std::abs(expected.velocity) < rounding);
    CHECK(std::abs(next.touch.velocity - expected.velocity) <
          rounding * (1 / length + most / std::abs(expected.velocity)));
  }
  // What is never sure is never wrong; but then nothing would be gained.
  CHECK(tried < 3 * sure);
}

TEST_CASE("stage 6: bounces settle where the exact ones do") {
  for (const ContactLaw contact : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const double amplitude : {0.056, 0.062, 0.07, 0.074}) {
      OscillatingFloor scene;
      scene.contact = contact;
      scene.amplitude = amplitude;
      scene.angular_frequency = 4 * std::numbers::pi;
      scene.phase = 1;
      const std::vector<Bounce> got = settled_bounces(scene, 300, 100);
      const std::vector<Bounce> expected = exact_bounces(scene, 300, 100);
      REQUIRE(got.size() == expected.size());
      for (std::size_t n = 0; n < got.size(); ++n) {
        CHECK(std::abs(got[n].height - expected[n].height) < 1e-10);
        CHECK(std::abs(got[n].phase - expected[n].phase) < 1e-9);
      }
    }
  }
}

TEST_CASE("stage 6: bounces of balls side by side are those of each alone, to the bit") {
  std::vector<OscillatingFloor> scenes;
  for (int n = 0; n < 43; ++n) {
    OscillatingFloor scene;
    scene.amplitude = 0.002 * n;  // at rest, regular, and chaos
    scene.damping = n % 10 == 9 ? 190 : 14.17;
    scene.contact = n < 20 ? ContactLaw::may_pull : ContactLaw::push_only;
    scenes.push_back(scene);
  }
  const std::vector<std::vector<Bounce>> together = settled_bounces(scenes, 100, 50);
  REQUIRE(together.size() == scenes.size());
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    const std::vector<Bounce> alone = settled_bounces(scenes[n], 100, 50);
    CAPTURE(n);
    REQUIRE(together[n].size() == alone.size());
    if (n > 20 && n % 10 != 9) CHECK(alone.size() == 50);
    for (std::size_t i = 0; i < alone.size(); ++i) {
      CHECK(together[n][i].height == alone[i].height);
      CHECK(together[n][i].phase == alone[i].phase);
      CHECK(together[n][i].speed == alone[i].speed);
    }
  }
}

TEST_CASE("stage 6: quick bounces have the same bits in every build") {
  // Sums, products, quotients and square roots only: IEEE 754 rounds them in one way.
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const ContactLaw contact : {ContactLaw::may_pull, ContactLaw::push_only}) {
    OscillatingFloor scene;
    scene.contact = contact;
    scene.amplitude = 0.072;
    const QuickContact<double> quick = quick_contact_of(scene);
    Touch<double> touch{1, -3};
    for (int n = 0; n < 1000; ++n) {
      const NextTouch<double> next = next_touch(quick, touch);
      REQUIRE(next.is_sure);
      touch = next.touch;
      for (const double value : {touch.angle, touch.velocity, next.highest}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
      }
    }
  }
  CHECK(hash == 18282734929696913772u);
}

TEST_CASE(
    "stage 6: a ball that is let go in every swing and never leaves the floor does not bounce") {
  OscillatingFloor scene;
  scene.contact = ContactLaw::push_only;
  scene.damping = 400;  // twice critical
  for (const double amplitude : {0.055, 0.06}) {
    scene.amplitude = amplitude;
    CHECK(settled_bounces(scene, 200, 100).empty());
  }
}
