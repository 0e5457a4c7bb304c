#pragma once
#include <algorithm>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace bounce::report {

/// CPU time of this process so far [s]. Unlike the clock on the wall it does not count the time for
/// which other programs have the processor.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Something to measure: `work(n)` does it n times. What it returns is looked at, so that the
/// compiler cannot leave the work out.
using Work = std::function<double(long n)>;

/// CPU seconds for doing each work once: the median of `rounds` rounds, in alternation (each round
/// measures all of them), so that a slow moment of the machine hits all alike.
std::vector<double> cost_in_alternation(const std::vector<Work>& works, int rounds,
                                        double seconds_each);

/// Its name, as the system tells it.
std::string processor();

}  // namespace bounce::report
