#include "random_numbers.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>

using namespace bounce;

TEST_CASE("random numbers are the same on every machine") {
  // What these generators answer first, with the seed they have by themselves, is in the papers of
  // their authors.
  std::mt19937_64 long_words;
  CHECK(test::uniform(long_words, 0, 1) == 14514284786278117030.0 * 0x1p-64);
  CHECK(test::uniform(long_words, -3, 5) == 4620546740167642908.0 * 0x1p-61 - 3);
  std::mt19937 words;
  CHECK(test::uniform(words, 0, 1) == 3499211612.0 * 0x1p-64 + 581869302.0 * 0x1p-32);
  // The largest number that a generator has is still below the end.
  struct {
    static constexpr std::uint64_t min() { return 0; }
    static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }
    std::uint64_t operator()() { return max(); }
  } most;
  CHECK(test::uniform(most, 0, 1) == 1 - 0x1p-53);
}

TEST_CASE("normal random numbers have the moments of the normal distribution") {
  std::mt19937_64 random(1);
  test::Normal normal;
  constexpr int count = 100000;
  std::array<double, 4> moments{};
  double product = 0, before = 0;
  for (int i = 0; i < count; ++i) {
    const double x = normal(random);
    double power = 1 / double{count};
    for (double& moment : moments) moment += power *= x;
    product += x * before / count;
    before = x;
  }
  // The mean of so many x^n has the deviation sqrt((m_2n - m_n^2) / count), with the moments m = 1,
  // 3, 15, 105 of orders 2, 4, 6, 8. Four times that.
  const double four = 4 / std::sqrt(count);
  CHECK(std::abs(moments[0]) < four);
  CHECK(std::abs(moments[1] - 1) < four * std::sqrt(2));
  CHECK(std::abs(moments[2]) < four * std::sqrt(15));
  CHECK(std::abs(moments[3] - 3) < four * std::sqrt(96));
  CHECK(std::abs(product) < four);  // one tells nothing of the next
}

TEST_CASE("after a shuffle every order is as likely") {
  std::mt19937_64 random(1);
  std::map<std::array<int, 3>, int> seen;
  for (int i = 0; i < 60000; ++i) {
    std::array<int, 3> order{1, 2, 3};
    test::shuffle(order.begin(), order.end(), random);
    ++seen[order];
  }
  CHECK(seen.size() == 6);
  // Counts with the mean 10000 have the deviation sqrt(60000 * 1/6 * 5/6) = 91. Four times that.
  for (const auto& [order, times] : seen) CHECK(std::abs(times - 10000) < 365);
}
