// The same result everywhere. Runs of all stages and methods, each boiled down to 64 bits of hash;
// the committed state_hashes.txt must come out of every build: debug, release, sanitizers, g++,
// clang++, -O0 to -O3 (.ci/run). After a change that means to change results:
//   build/release/bin/state_hashes > tests/hard_cases/state_hashes.txt
// and look at the difference: rows that were not meant to change must not.

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "all_stages.hpp"
#include "physics/events/event_driven.hpp"

using namespace bounce;

namespace {

/// FNV-1a over the bits of numbers.
class Hash {
 public:
  void add(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8)
      hash_ = (hash_ ^ (bits & 255)) * 1099511628211u;
  }
  void add(const std::vector<double>& numbers) {
    for (const double number : numbers) add(number);
  }
  std::string text() const {
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash_));
    return digits.data();
  }

 private:
  std::uint64_t hash_ = 14695981039346656037u;
};

/// What a run needs besides + - * / and square roots, which round alike on every machine.
enum class Needs { arithmetic, functions };

struct Runs {
  std::size_t stage;  // from 1
  Needs needs;        // of the stepping methods; formulas always need functions
  std::string settings;
  double duration = 5;  // s
};

const Runs all_runs[] = {
    {1, Needs::arithmetic, ""},
    {2, Needs::arithmetic, ""},
    {2, Needs::arithmetic, "--dt 0.0037 --set mass=0.021 --set stiffness=3.1e6", 1},
    {3, Needs::arithmetic, ""},
    {3, Needs::arithmetic, "--set contact=push-only --set damping=100"},
    {3, Needs::arithmetic, "--set damping=462 --set position=0.05"},
    {4, Needs::arithmetic, "--set velocity=0.3,0,-0.2"},
    {4, Needs::arithmetic, "--set floor=off"},
    {5, Needs::arithmetic, "--set scene=pair --set gap=0.07"},
    {5, Needs::arithmetic, "--set scene=break --set contact=push-only --set damping=10", 2},
    {5, Needs::arithmetic, "--set scene=cradle"},
    {5, Needs::arithmetic, "--set scene=tower", 2},
    {5, Needs::functions, "--set scene=drop --set count=10", 1},
    {5, Needs::functions, "--set scene=drop --set count=100", 1},
    {5, Needs::functions, "--set scene=drop --set count=100 --threads 2", 1},
    {6, Needs::functions, ""},
    {6, Needs::functions, "--set floor_law=absolute --set contact=push-only"},
    {6, Needs::functions, "--set floor_law=fixed-switch --set floor_velocity=0.01"},
    {7, Needs::arithmetic, ""},
    {7, Needs::arithmetic, "--set normal=1,3,-0.5 --set offset=0.2 --set contact=push-only"},
    {8, Needs::arithmetic, "--player none"},
    {8, Needs::arithmetic,
     "--player none --set racket_normal=0.1,1,0 --set racket_velocity=0,0.2,0"},
    {8, Needs::functions, "--player none --set position=0.33,1,0.1 --set racket_velocity=0.1,0.3,0",
     1},
    {8, Needs::functions, "--player autopilot"},
    {8, Needs::functions, "--player blind"},
    {8, Needs::functions, "--player idle"}};

/// "HASH  arithmetic  03_damping --method rk4  ends at 0.1,0.2": the hash is of a row of the trace
/// every 0.05 s, and of all that the next step would depend on. The end is for people.
std::string row(const Runs& runs, Method method) {
  const test::Stage& stage = test::all_stages().at(runs.stage - 1);
  const bool formula = method == methods::exact;
  const std::string words = "--method " + name_of(method) + " " + runs.settings;
  Hash hash;
  std::string end;
  Options options;
  const std::unique_ptr<Simulation> simulation = test::set_up(stage, words, options);
  try {
    for (double row = 0; row * 0.05 <= runs.duration; ++row) {
      simulation->advance_to(row * 0.05);
      hash.add(simulation->values());
    }
    hash.add(simulation->memory().numbers);
    std::vector<double> values = simulation->values();
    values.resize(simulation->columns().size());
    end = "ends at " + to_text(values);
  } catch (const NoClosedForm& no) {
    end = "stops at " + to_text(no.t);
  }
  return hash.text() +
         (formula || runs.needs == Needs::functions ? "  functions   " : "  arithmetic  ") +
         stage.name.name + " " + words + "  " + end;
}

/// sin, cos and their like are not rounded alike by every C library, nor by one library on every
/// processor (glibc has versions with and without fused multiply-add). This tells whether they are
/// those with which the table was made.
std::string fingerprint_of_functions() {
  std::mt19937_64 random(1);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  Hash hash;
  for (int i = 0; i < 20000; ++i) {
    const double any = between(-50, 50), share = between(0, 1), positive = between(1e-3, 50);
    hash.add({std::sin(any), std::cos(any), std::tan(any), std::exp(any), std::expm1(any),
              std::sinh(share), std::log(positive), std::log1p(share), std::cbrt(positive),
              std::pow(positive, any), std::acos(share), std::asin(share),
              std::atan2(any, positive), std::hypot(any, positive)});
    const std::complex<double> z(any, share), e = std::exp(z), s = std::sinh(z), q = 1.0 / z;
    hash.add({e.real(), e.imag(), s.real(), s.imag(), q.real(), q.imag()});
  }
  return hash.text() + "  functions   sin, cos, exp and the others of this C library";
}

std::vector<std::string> table() {
  std::vector<std::string> rows{fingerprint_of_functions()};
  for (const Runs& runs : all_runs) {
    for (const Method method : test::all_stages().at(runs.stage - 1).make()->methods()) {
      // With a hundred balls the reference takes seconds.
      if (method == methods::reference && runs.settings.find("count=100") != std::string::npos) {
        continue;
      }
      try {
        rows.push_back(row(runs, method));
      } catch (const BadInput&) {  // a method that is not for these settings
      }
    }
  }
  return rows;
}

/// Says what differs. Where the C library is another one, rows that need its functions may differ.
int check(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> expected, got = table();
  for (std::string line; std::getline(file, line);) expected.push_back(line);
  if (expected.size() != got.size()) {
    std::cout << path << " has " << expected.size() << " rows, and this program makes "
              << got.size() << "\n";
    return 1;
  }
  const bool same_functions = got[0] == expected[0];
  std::size_t wrong = 0, skipped = 0;
  for (std::size_t i = 1; i < got.size(); ++i) {
    if (got[i] == expected[i]) continue;
    if (!same_functions && got[i].find("  functions  ") != std::string::npos) {
      ++skipped;
      continue;
    }
    ++wrong;
    std::cout << "expected " << expected[i] << "\ngot      " << got[i] << "\n\n";
  }
  if (!same_functions) {
    std::cout << "the C library's functions differ from those of the table (docs/architecture.md): "
              << skipped << " rows that need them differ, and were let pass\n";
  }
  std::cout << wrong << " of " << got.size() - 1 << " rows are wrong\n";
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--check") return check(argv[2]);
  for (const std::string& row : table()) std::cout << row << "\n";
  return 0;
}
