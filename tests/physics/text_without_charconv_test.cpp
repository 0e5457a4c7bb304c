// Some C++ libraries cannot read and write floating-point numbers by <charconv>: Apple's, and the
// one that makes web pages. What text.cpp has for them must give the same answers.
#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "floating_point_traps.hpp"
#include "physics/text.hpp"

// The same file once more, as such a library compiles it, in a namespace of its own.
#include <version>
#undef __cpp_lib_to_chars
namespace without {
using namespace bounce;
}
#define bounce without
#include "physics/text.cpp"  // NOLINT
#undef bounce

TEST_CASE("numbers are read and written alike without <charconv>") {
  const bounce::test::WithoutTraps strtod_overflows;
  std::mt19937_64 random(1);
  const auto same = [](double number) {
    const std::string text = bounce::to_text(number);
    CHECK(without::to_text(number) == text);
    if (!std::isfinite(number)) return;
    REQUIRE(without::parse_number(text));
    CHECK(*without::parse_number(text) == number);
  };
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();  // of any size
    double number = 0;
    std::memcpy(&number, &bits, sizeof bits);
    same(number);
    same(static_cast<double>(static_cast<int>(bits % 2000001) - 1000000) /
         1000);  // as people write
  }
  using Limits = std::numeric_limits<double>;
  for (const double number : {0.0, -0.0, 1e15, 1e16, 1e21, 1e22, 1e23, 123456789012345678.0, 0.1,
                              1e-4, 1e-5, 5e-324, Limits::min(), Limits::max(), Limits::infinity(),
                              -Limits::infinity(), Limits::quiet_NaN()}) {
    same(number);
  }
}

TEST_CASE("what is no number is none without <charconv>, too") {
  const bounce::test::WithoutTraps strtod_overflows;
  for (const char* text :
       {"",      " ",      "1 ",     " 1",     "1,2",  "x",     "nan",    "inf",      "-inf",
        "1e400", "-1e400", "1e-400", "0e-400", "0x10", "+1",    "++1",    "+-1",      "-+1",
        "--1",   "+",      "-",      ".",      "1.",   ".5",    "1e",     "1e+",      "1e5",
        "1E5",   "1e+5",   "1d5",    "1_000",  "(1)",  "1e5.5", "0.0000", "4.9e-324", "2e-324"}) {
    CAPTURE(text);
    CHECK(without::parse_number(text) == bounce::parse_number(text));
  }
}
