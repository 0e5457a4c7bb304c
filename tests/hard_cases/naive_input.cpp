// Bad input, the naive way.

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

#include "03_damping/damping.hpp"
#include "hostile_lines.hpp"
#include "naive.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "physics/text.hpp"

namespace bounce::naive {
namespace {

struct Taken {
  int as_numbers = 0, infinite = 0, of_no_number = 0, uncaught = 0;
};

/// What std::stod makes of a word; it takes what begins like a number, and throws at the rest.
void try_stod(const std::string& word, Taken& taken) {
  try {
    taken.infinite += std::isfinite(std::stod(word)) ? 0 : 1;
    ++taken.as_numbers;
    taken.of_no_number += parse_number(word) ? 0 : 1;
  } catch (const std::exception&) {
    ++taken.uncaught;
  }
}

std::string values() {
  Taken taken;
  int zeros = 0;
  for (const std::string& value : test::bad_values) {
    try_stod(value, taken);
    zeros += value != "0" && std::atof(value.c_str()) == 0 ? 1 : 0;
  }
  const std::string all = std::to_string(test::bad_values.size());
  return "of " + all + " such values `std::stod` takes " + std::to_string(taken.as_numbers) + ", " +
         std::to_string(taken.infinite) + " of them not finite, and throws at " +
         std::to_string(taken.uncaught) + "; `std::atof` takes all, text and nothing (" +
         std::to_string(zeros) + ") as 0";
}

std::string files() {
  std::istringstream file("1 0.1 0 1 0\n1 O.1 0 2 0\n1 0.1 0 3 0\n");  // one letter for a digit
  int balls = 0;
  for (double mass, radius, x, y, z; file >> mass >> radius >> x >> y >> z;) ++balls;
  return "`while (file >> x)` stops at one bad letter: it takes " + std::to_string(balls) +
         " of 3 balls, without a word";
}

/// Cells cut at commas, each taken by std::stod.
std::vector<double> cut_at_commas(const std::string& row) {
  std::vector<double> numbers;
  std::istringstream cells(row);
  for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
  return numbers;
}

std::string spreadsheets() {
  const std::vector<double> ball{2, 0.1, 3};
  int right = 0, other = 0, uncaught = 0;
  for (const char* row :
       {"2,0.1,3", "2;0.1;3", "2;0,1;3", "2\t0.1\t3", "\"2\",\"0.1\",\"3\"", "2,0.1,3,,"}) {
    try {
      ++(cut_at_commas(row) == ball ? right : other);
    } catch (const std::exception&) {
      ++uncaught;
    }
  }
  return "of 6 ways to write 2, 0.1, 3 a reader that cuts at commas takes " +
         std::to_string(right) + ", takes " + std::to_string(other) +
         " for other numbers, and throws at " + std::to_string(uncaught);
}

std::string clock_that_stands() {
  double t = 1e4;
  for (int i = 0; i < 1000000; ++i) t += 1e-13;
  return "a million steps of 1e-13 s after 1e4 s bring the clock on by " + digits(t - 1e4) +
         " s: a run without end";
}

std::string bytes_of_a_trace() {
  const Damping scene;
  State<double> ball = scene.start;
  std::size_t bytes = 0;
  for (int i = 0; i < 1000; ++i) {
    semi_implicit_euler(scene, 0, ball, 1e-3);
    bytes += to_text(std::array{i * 1e-3, ball.position, ball.velocity}).size() + 1;
  }
  return "1000 rows of stage 3 are " + digits(static_cast<double>(bytes) / 1e3, 2) +
         " kB: the 1e10 rows of `--sample 1e-9` would be " +
         digits(static_cast<double>(bytes) / 1e3 * 1e10 / 1e9, 2) + " GB";
}

std::string random_words() {
  const std::string letters = "0123456789.+-eEinfa,x ";
  std::mt19937_64 random(1);
  Taken taken;
  for (int i = 0; i < 10000; ++i) {
    std::string word;
    for (auto length = 1 + random() % 8; length > 0; --length) {
      word += letters[random() % letters.size()];
    }
    try_stod(word, taken);
  }
  return "of 10 000 random words `std::stod` takes " + std::to_string(taken.of_no_number) +
         " that are no numbers, and throws at " + std::to_string(taken.uncaught);
}

/// As the program reads a row of --balls: eight numbers, and nothing besides.
bool is_a_ball(const std::string& row) {
  const std::vector<std::string> cells = split(row);
  for (const std::string& cell : cells) {
    if (!parse_number(cell)) return false;
  }
  return cells.size() == 8;
}

/// A number, whatever comes after it, and so eight times. (Not `sscanf`: glibc has changed what it
/// does with half an exponent.)
bool takes_by_strtod(const char* row) {
  for (int i = 0; i < 8; ++i) {
    char* end = nullptr;
    std::strtod(row, &end);
    if (end == row) return false;
    row = *end == '\0' ? end : end + 1;
  }
  return true;
}

std::string one_letter_changed() {
  const std::string good = "1,0.1,-0.5,1.25,0,2,0,-1e-3";
  int damaged = 0, taken = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (char letter = ' '; letter <= '~'; ++letter) {
      std::string row = good;
      row[at] = letter;
      if (is_a_ball(row)) continue;
      ++damaged;
      taken += takes_by_strtod(row.c_str());
    }
  }
  return "of " + std::to_string(damaged) +
         " rows damaged in one letter a reader with `strtod` takes " + std::to_string(taken);
}

}  // namespace

void print_input() {
  print_cases(
      {{"Every parameter and option with text, nothing, NaN, infinities, -1, 0, 1e308, 1e-320 and "
        "two values",
        values},
       {"The same in every entry of a saved state, recorded inputs, `--balls` and "
        "`--import-lammps`",
        files},
       {"A table of balls as a spreadsheet saves it", spreadsheets},
       {"More than 1e11 steps", clock_that_stands},
       {"More than 1e8 rows", bytes_of_a_trace},
       {"2500 command lines at random, under the sanitizers", random_words},
       {"Damaged files at random: `--balls` and saved states, fed by libFuzzer",
        one_letter_changed}});
}

}  // namespace bounce::naive
