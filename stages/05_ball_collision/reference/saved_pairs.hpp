#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "05_ball_collision/reference/touching.hpp"

namespace bounce {

/// Who touches or has let go, as it is saved: five numbers for each two.
inline std::vector<double> as_numbers(const std::vector<ContactPair>& held) {
  std::vector<double> numbers;
  for (const ContactPair& two : held) {
    for (const int number : {two.first, two.second, two.axis, two.sign}) numbers.push_back(number);
    numbers.push_back(two.phase == Phase::touch ? 1 : 2);
  }
  return numbers;
}

/// The same back again, in order; nothing where the numbers do not fit so many balls.
inline std::optional<std::vector<ContactPair>> pairs_from_numbers(std::span<const double> numbers,
                                                                  Eigen::Index balls) {
  std::vector<ContactPair> held;
  if (numbers.size() % 5 != 0) return std::nullopt;
  for (; !numbers.empty(); numbers = numbers.subspan(5)) {
    const auto is_whole = [&](std::size_t i, double low, double high) {
      return numbers[i] >= low && numbers[i] <= high && numbers[i] == std::floor(numbers[i]);
    };
    const auto last = static_cast<double>(balls - 1);
    if (!is_whole(0, 0, last) || !is_whole(1, -1, last) || !is_whole(2, 0, 2) ||
        !is_whole(3, -1, 1) || !is_whole(4, 1, 2)) {
      return std::nullopt;
    }
    const auto whole = [&](std::size_t i) { return static_cast<int>(numbers[i]); };
    held.push_back(
        {whole(0), whole(1), whole(2), whole(3), whole(4) == 1 ? Phase::touch : Phase::let_go});
  }
  std::sort(held.begin(), held.end());
  return held;
}

}  // namespace bounce
