#include "app/palette.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace bounce;

namespace {

using Vec = std::array<double, 3>;

Vec linear(Colour c) {
  const auto channel = [](double value) {
    value /= 255;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return {channel(c.red), channel(c.green), channel(c.blue)};
}

/// WCAG 2 contrast ratio.
double contrast(Colour a, Colour b) {
  const auto luminance = [](Colour c) {
    const Vec rgb = linear(c);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  };
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return x > y ? x / y : y / x;
}

Vec lab(const Vec& rgb) {
  const double x = (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505;
  const double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const double z = (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

/// Machado, Oliveira, Fernandes 2009, severity 1, on linear RGB.
constexpr double protan[9] = {0.152286, 1.052583,  -0.204868, 0.114503, 0.786281,
                              0.099216, -0.003882, -0.048116, 1.051998};
constexpr double deutan[9] = {0.367322, 0.860646,  -0.227968, 0.280085, 0.672501,
                              0.047413, -0.011820, 0.042940,  0.968881};
constexpr double tritan[9] = {1.255528, -0.076749, -0.178779, -0.078411, 0.930809,
                              0.147602, 0.004733,  0.691367,  0.303900};

double distance_seen(Colour a, Colour b, const double (&eye)[9]) {
  const auto seen = [&eye](Colour c) {
    const Vec rgb = linear(c);
    Vec out{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = eye[3 * i] * rgb[0] + eye[3 * i + 1] * rgb[1] + eye[3 * i + 2] * rgb[2];
      out[i] = std::fmin(1, std::fmax(0, value));
    }
    return lab(out);
  };
  const Vec x = seen(a), y = seen(b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

constexpr Colour quantities[] = {palette::motion, palette::gravity, palette::spring,
                                 palette::damper, palette::ink};

}  // namespace

TEST_CASE("every colour can be seen on paper: contrast 3 for marks, 4.5 for text") {
  for (const Colour colour : quantities) CHECK(contrast(colour, palette::paper) >= 3);
  CHECK(contrast(palette::ink, palette::paper) >= 4.5);
  CHECK(contrast(palette::exact, palette::paper) >= 4.5);
  CHECK(contrast(palette::ink, palette::warning) >= 4.5);
}

TEST_CASE("the four quantities and ink are told apart with any colour vision (CIE76 at least 15)") {
  for (const Colour& a : quantities) {
    for (const Colour& b : quantities) {
      if (&a == &b) continue;
      CHECK(distance_seen(a, b, protan) >= 15);
      CHECK(distance_seen(a, b, deutan) >= 15);
      CHECK(distance_seen(a, b, tritan) >= 15);
    }
  }
}
