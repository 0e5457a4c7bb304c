#include <doctest/doctest.h>

#include <string>

#include "hard_cases/stability_measured.hpp"
#include "physics/contact.hpp"
#include "physics/stability.hpp"
#include "physics/text.hpp"
#include "run_program.hpp"
#include "speed_vs_error/results.hpp"

using namespace bounce;
using namespace bounce::hard_cases;

TEST_CASE("hard case: the stability map is what theory says, to 1e-6") {
  const std::string csv = test::read_file(BOUNCE_SOURCE_DIR "/docs/stability_map.csv");
  int rows = 0, sharp = 0;
  for (const std::string& line : split(csv, '\n')) {
    const auto words = split(line);
    if (words.size() != 4 || words[0] == "method") continue;
    CAPTURE(line);
    const double zeta = *parse_number(words[1]);
    const double theory = *parse_number(words[2]), measured = *parse_number(words[3]);
    // Where both eigenvalues meet at the boundary (critical damping), what dies there first grows
    // like the number of steps, and 1e4 of them tell no better than 3e-4.
    const bool meet = zeta == 1 && (words[0] == "explicit-euler" || words[0] == "rk4");
    // Both are rounded to 1e-6.
    CHECK(std::abs(measured - theory) <= (meet ? 3e-4 : 2.1e-6));
    ++rows;
    if (!meet) ++sharp;
  }
  CHECK(rows == 4 * 61 - 1);
  CHECK(sharp == rows - 2);
}

TEST_CASE("hard case: the committed map is what the methods do today") {
  // The method, not the file: some rows measured anew (all 243 take seconds).
  for (const Method method : {methods::explicit_euler, methods::semi_implicit_euler,
                              methods::velocity_verlet, methods::rk4}) {
    for (const double zeta : {0.1, 2.31}) {
      CAPTURE(name_of(method));
      CAPTURE(zeta);
      CHECK(std::abs(measured_limit(method, zeta) - method.largest_stable_step(1, zeta)) < 1e-6);
    }
  }
  const std::string limits = test::read_file(BOUNCE_SOURCE_DIR "/docs/stability_map.csv");
  const std::string ranges = test::read_file(BOUNCE_SOURCE_DIR "/docs/restitution_range.csv");
  INFO("draw it again with build/release/bin/stability_map");
  CHECK(test::read_file(BOUNCE_SOURCE_DIR "/docs/images/stability_map.svg")
            .find(report::fingerprint(limits + ranges)) != std::string::npos);
}

TEST_CASE("hard case: below the limit an undamped bounce is wrong, within sqrt(1 - w^2/4)") {
  for (const double w : {0.1, 0.37, 0.5, 0.83, 1.3, 1.9}) {
    const double bound = std::sqrt(1 - w * w / 4);
    const RestitutionRange range = restitution_range(methods::semi_implicit_euler, {0}, w, 1000);
    CAPTURE(w);
    CHECK(range.lowest >= bound);
    CHECK(range.highest <= 1 / bound);
    CHECK(range.highest - range.lowest > 0.1 * (1 / bound - bound));  // and not by luck right
  }
  // Where a contact is a whole number of steps, luck: right at every phase, and it proves nothing.
  const RestitutionRange lucky = restitution_range(methods::semi_implicit_euler, {0}, 1, 1000);
  CHECK(std::abs(lucky.lowest - 1) < 1e-12);  // some 4 roundings a step
  CHECK(std::abs(lucky.highest - 1) < 1e-12);
}

TEST_CASE("hard case: the step for a wanted restitution keeps its promise at every phase") {
  for (const double zeta : {0.0, 0.02, 0.07, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
    for (const double accuracy : {0.1, 0.03, 0.01, 0.001}) {
      const double w = restitution_step(1, zeta, accuracy);
      const double e = restitution({1, 2 * zeta}, 1);
      const RestitutionRange range =
          restitution_range(methods::semi_implicit_euler, {zeta}, w, 200);
      CAPTURE(zeta);
      CAPTURE(accuracy);
      CAPTURE(w);
      // The series of sqrt(1 - w^2/4) goes on: its next term is 3 w^4 / 128.
      const double allowed = accuracy + 3 * w * w * w * w / 128;
      CHECK(range.highest - e <= allowed);
      CHECK(e - range.lowest <= allowed);
      // It is no smaller than it must be by more than a factor of 10 (the worst phase and damping).
      CHECK(std::max(range.highest - e, e - range.lowest) >= accuracy / 10);
    }
  }
  CHECK(comfortable_step(100, 0) == doctest::Approx(1e-3).epsilon(1e-14));
  CHECK(comfortable_step(100, 0.3) == restitution_step(100, 0.3, 0.01));
}
