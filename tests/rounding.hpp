#pragma once
#include <limits>

namespace bounce::test {

/// The relative size of a rounding, twice over: 2^-52.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace bounce::test
