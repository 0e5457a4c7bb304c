#include "physics/contact.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace bounce;

namespace {

struct Row {
  double zeta, e_may_pull, e_push_only, t_may_pull, t_push_only;
};
// Computed with 40 digits from the two end-of-contact rules; omega0 = 1.
constexpr Row known_contacts[] = {
    {0.05, 0.8544678930, 0.8587581018, 3.145527, 3.045360},
    {0.1, 0.7292476143, 0.7440793977, 3.157419, 2.956075},
    {0.2, 0.5266205993, 0.5717400276, 3.206375, 2.795354},
    {0.5, 0.1630335348, 0.2984360592, 3.627599, 2.418399},
    {0.98, 1.909e-7, 0.1390151854, 15.7871, 2.013441},
    {1, 0, 0.1353352832, INFINITY, 2},
    {2.31, 0, 0.0375036144, INFINITY, 1.421350},
};

SpringDamper contact_with(double zeta, ContactLaw law, double k, double m) {
  return {k, 2 * zeta * std::sqrt(k * m), law};
}

}  // namespace

TEST_CASE("restitution and contact time of both laws, for any mass and stiffness") {
  for (const Row& row : known_contacts) {
    for (const double k : {1.0, 1e4, 3.1e6}) {
      for (const double m : {1.0, 0.021, 1e-12}) {
        CAPTURE(row.zeta);
        CAPTURE(k);
        CAPTURE(m);
        const double omega0 = natural_frequency(k, m);
        const SpringDamper may_pull = contact_with(row.zeta, ContactLaw::may_pull, k, m);
        const SpringDamper push = contact_with(row.zeta, ContactLaw::push_only, k, m);
        CHECK(damping_ratio(k, may_pull.damping, m) == doctest::Approx(row.zeta).epsilon(1e-14));
        // The table has 10 and 7 digits; 1.909e-7 has 4. At zeta = 1, omega_d is pure rounding.
        if (row.zeta > 1) {
          CHECK(restitution(may_pull, m) == 0);
          CHECK(contact_time(may_pull, m) == INFINITY);
        } else if (row.zeta < 1) {
          CHECK(restitution(may_pull, m) ==
                doctest::Approx(row.e_may_pull).epsilon(1e-4).scale(1e-6));
          CHECK(contact_time(may_pull, m) * omega0 ==
                doctest::Approx(row.t_may_pull).epsilon(1e-6));
        } else {
          CHECK(restitution(may_pull, m) < 1e-300);
        }
        CHECK(restitution(push, m) == doctest::Approx(row.e_push_only).epsilon(1e-9));
        CHECK(contact_time(push, m) * omega0 == doctest::Approx(row.t_push_only).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("the push-only formula is Schwager and Poeschel's, and smooth through critical damping") {
  for (const double zeta : {0.01, 0.3, 0.7, 0.9}) {
    const SpringDamper push = contact_with(zeta, ContactLaw::push_only, 1, 1);
    const double beta = zeta, wd = std::sqrt(1 - zeta * zeta);
    const double t = (std::acos(-1.0) - std::atan2(2 * beta * wd, 1 - 2 * beta * beta)) / wd;
    CAPTURE(zeta);
    CHECK(contact_time(push, 1) == doctest::Approx(t).epsilon(1e-14));
  }
  for (const double zeta : {1.1, 3.0, 20.0}) {
    const SpringDamper push = contact_with(zeta, ContactLaw::push_only, 1, 1);
    const double O = std::sqrt(zeta * zeta - 1);
    CAPTURE(zeta);
    // The textbook form subtracts beta - O and so loses about zeta^2 in digits; ours does not.
    CHECK(contact_time(push, 1) ==
          doctest::Approx(std::log((zeta + O) / (zeta - O)) / O).epsilon(1e-12));
  }
  for (const double off : {1e-6, 1e-9, 1e-12}) {
    // t_c = 2 (1 - (zeta - 1) / 3 * 2 ...): near 1 it changes less than twice the distance.
    for (const double side : {-off, off}) {
      const SpringDamper push = contact_with(1 + side, ContactLaw::push_only, 1, 1);
      CAPTURE(side);
      CHECK(std::abs(contact_time(push, 1) - 2) < 2 * off + 1e-15);
    }
  }
}

TEST_CASE("push-only never pulls, the slides' law does") {
  const SpringDamper may_pull{100, 30, ContactLaw::may_pull}, push{100, 30, ContactLaw::push_only};
  CHECK(may_pull.force(0.1, 1) == doctest::Approx(-20));  // 100 x 0.1 - 30 x 1
  CHECK(push.force(0.1, 1) == 0);
  CHECK(push.force(0.1, -1) == may_pull.force(0.1, -1));
  for (const double overlap : {0.0, -1e-9, -1.0}) {
    CHECK(may_pull.force(overlap, -5) == 0);  // no overlap, no force, not even a near miss
    CHECK(push.force(overlap, -5) == 0);
  }
}
