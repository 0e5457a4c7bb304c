#pragma once
#include <cstdio>
#include <initializer_list>
#include <string>

#include "physics/text.hpp"

// What goes wrong naively, measured: each function does it the naive way, and says how wrong it
// is. These sentences are the column `naively` of docs/hard_cases.md.
namespace bounce::naive {

/// A row of that page: its first cell, and what measures the second one.
struct Case {
  const char* name;
  std::string (*measure)();
};

inline void print_cases(std::initializer_list<Case> cases) {
  for (const Case& one : cases) std::printf("%s | %s\n", one.name, one.measure().c_str());
}

// The page's sections.
void print_steps();
void print_long();
void print_far();
void print_rackets();
void print_planes();
void print_balls();
void print_input();
void print_builds();

/// Rounded to so many digits, and then as short as can be: 180 and 2e-9, not 1.8e+02 and 2e-09.
inline std::string digits(double value, int count = 3) {
  std::string text = to_text(*parse_number(to_rounded_text(value, count)));
  const std::size_t exponent = text.find('e') + 1;
  if (exponent == 0) return text;
  if (text[exponent] == '+') text.erase(exponent, 1);
  const std::size_t zeros = text.find_first_of("0123456789", exponent);
  return text.erase(zeros, text.find_first_not_of('0', zeros) - zeros);
}

/// The slides' step of the contact, as the page writes it.
inline const std::string omega0_dt = R"(\omega_0 \Delta t)";

}  // namespace bounce::naive
