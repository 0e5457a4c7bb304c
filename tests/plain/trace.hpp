#pragma once
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace bounce::test {

/// What a program wrote as CSV: the names of the columns, and the numbers.
struct Trace {
  std::string header;
  std::vector<std::vector<double>> rows;
};

inline Trace trace_of(const std::string& command) {
  Trace trace;
  std::string text = run_program(command).out;
  std::erase(text, '\r');  // a plain program knows nothing of how Windows ends a line
  std::istringstream lines(text);
  std::getline(lines, trace.header);
  for (std::string line; std::getline(lines, line);) {
    std::vector<double>& row = trace.rows.emplace_back();
    const char* at = line.c_str();
    while (*at != '\0') {
      char* end = nullptr;
      row.push_back(std::strtod(at, &end));
      if (end == at) break;  // no number: the row is then like no other
      at = *end == ',' ? end + 1 : end;
    }
  }
  return trace;
}

inline std::string text_of_page(const std::string& stage) {
  return read_file(BOUNCE_SOURCE_DIR "/stages/" + stage + "/plain.cpp");
}

inline const std::string same_method = " --headless --csv - --method semi-implicit-euler ";

}  // namespace bounce::test
