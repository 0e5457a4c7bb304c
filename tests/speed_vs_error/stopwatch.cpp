#include "speed_vs_error/stopwatch.hpp"

#include <fstream>

namespace bounce::report {
namespace {

volatile double looked_at;

double seconds_for(const Work& work, long n) {
  const double begin = cpu_seconds();
  looked_at = work(n);
  return cpu_seconds() - begin;
}

/// How often to do the work, so that it takes about `seconds`.
long repeats_for(const Work& work, double seconds) {
  for (long n = 1;; n *= 4) {
    const double took = seconds_for(work, n);
    if (took > seconds / 8) {
      return std::max(1L, static_cast<long>(static_cast<double>(n) * seconds / took));
    }
  }
}

}  // namespace

std::vector<double> cost_in_alternation(const std::vector<Work>& works, int rounds,
                                        double seconds_each) {
  std::vector<long> repeats;
  for (const Work& work : works) repeats.push_back(repeats_for(work, seconds_each));
  std::vector<std::vector<double>> times(works.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      times[i].push_back(seconds_for(works[i], repeats[i]) / static_cast<double>(repeats[i]));
    }
  }
  std::vector<double> cost;
  for (const std::vector<double>& each : times) cost.push_back(median(each));
  return cost;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace bounce::report
