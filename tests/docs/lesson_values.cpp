#include "docs/lesson_values.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

namespace bounce::test {
namespace {

using Lines = std::vector<std::string>;
const std::string marker_begin = "<!-- value: ", marker_end = " -->", by_hand = " by hand: ";

bool is_marker(const std::string& line) { return line.rfind(marker_begin, 0) == 0; }

std::string inside(const std::string& marker) {
  if (marker.size() < marker_begin.size() + marker_end.size() ||
      marker.compare(marker.size() - marker_end.size(), marker_end.size(), marker_end) != 0) {
    throw Mistake("a marker looks like <!-- value: NUMBER = PROGRAM | ROW | COLUMN -->");
  }
  return marker.substr(marker_begin.size(),
                       marker.size() - marker_begin.size() - marker_end.size());
}

/// The number that a marker is about, as it stands there.
std::string number_of(const std::string& marker) { return marker.substr(0, marker.find(' ')); }

Lines parts_of(const std::string& text, const std::string& between) {
  Lines parts;
  std::size_t from = 0;
  for (std::size_t at = 0; at != std::string::npos; from = at + between.size()) {
    at = text.find(between, from);
    parts.push_back(trimmed(text.substr(from, at - from)));
  }
  return parts;
}

/// The cells of a row of a markdown table, or of a CSV.
Lines cells_of(const std::string& row) {
  if (row.rfind('|', 0) != 0) return parts_of(row, ",");
  Lines cells = parts_of(row.substr(1, row.rfind('|') - 1), "|");
  for (std::string& cell : cells) {
    cell.erase(std::remove(cell.begin(), cell.end(), '`'), cell.end());
  }
  return cells;
}

/// The number that a program's table has now. `where`: PROGRAM | first cells of the row | COLUMN
double looked_up(const std::string& where, const Runner& run) {
  const Lines path = parts_of(where, " | ");
  if (path.size() < 3) throw Mistake("a value is NUMBER = PROGRAM | ROW | COLUMN: " + where);
  const Lines table = output_of(path[0], run);
  const Lines names = table.empty() ? Lines{} : cells_of(table[0]);
  const auto column = std::find(names.begin(), names.end(), path.back());
  if (column == names.end()) throw Mistake(path[0] + " has no column '" + path.back() + "'");
  const Lines row(path.begin() + 1, path.end() - 1);
  Lines found;
  for (const std::string& line : table) {
    const Lines cells = cells_of(line);
    if (cells.size() != names.size() || cells.size() < row.size()) continue;
    if (std::equal(row.begin(), row.end(), cells.begin())) {
      found.push_back(cells[static_cast<std::size_t>(column - names.begin())]);
    }
  }
  if (found.size() != 1) {
    throw Mistake(std::to_string(found.size()) + " rows, and not one, begin as told: " + where);
  }
  const char* cell = found[0].c_str();
  char* end = nullptr;
  const double value = std::strtod(cell, &end);
  if (end == cell) throw Mistake("this cell does not begin with a number: " + found[0]);
  return value;
}

/// With as many digits behind the point as `like`, and with a plus if that has one.
std::string written(double value, const std::string& like) {
  const std::size_t point = like.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(like.size() - point - 1);
  char text[64];
  std::snprintf(text, sizeof text, like[0] == '+' ? "%+.*f" : "%.*f", digits, value);
  return text;
}

/// The sign tells "too high" from "too low"; the sentence says that in words.
std::string without_sign(const std::string& number) {
  return number.substr(number[0] == '+' || number[0] == '-' ? 1 : 0);
}

bool is_of_number(const std::string& line, std::size_t at) {
  return at < line.size() && std::isdigit(static_cast<unsigned char>(line[at])) != 0;
}

/// Where `number` stands in the line, and is not a part of a longer one.
std::size_t find_number(const std::string& line, const std::string& number, std::size_t from) {
  for (std::size_t at = line.find(number, from); at != std::string::npos;
       at = line.find(number, at + 1)) {
    const std::size_t end = at + number.size();
    const bool begins = at == 0 || (!is_of_number(line, at - 1) && line[at - 1] != '.');
    const bool ends = !is_of_number(line, end) &&
                      !(end < line.size() && line[end] == '.' && is_of_number(line, end + 1));
    if (begins && ends) return at;
  }
  return std::string::npos;
}

int replace_number(std::string& line, const std::string& number, const std::string& by) {
  int count = 0;
  for (std::size_t at = find_number(line, number, 0); at != std::string::npos;
       at = find_number(line, number, at + by.size())) {
    line.replace(at, number.size(), by);
    ++count;
  }
  return count;
}

/// Blanks for `code`, $formulas$ and (targets of links).
std::string only_words(const std::string& line) {
  std::string words = line;
  char until = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    if (until == 0 && (c == '`' || c == '$')) {
      until = c;
    } else if (until == 0 && c == '(' && i > 0 && line[i - 1] == ']') {
      until = ')';
    } else if (until == c) {
      until = 0;
    } else if (until == 0) {
      continue;
    }
    words[i] = ' ';
  }
  return words;
}

bool looks_measured(const std::string& number) {
  std::string digits = number;
  digits.erase(std::remove(digits.begin(), digits.end(), '.'), digits.end());
  digits.erase(0, digits.find_first_not_of('0'));
  const bool whole = number.find('.') == std::string::npos;
  if (whole) digits.erase(digits.find_last_not_of('0') + 1);
  return digits.size() >= (whole ? 3u : 2u);
}

Lines measured_in(const std::string& line) {
  const std::string words = only_words(line);
  Lines numbers;
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (!is_of_number(words, at)) continue;
    std::size_t end = words.find_first_not_of("0123456789.", at);
    if (end == std::string::npos) end = words.size();
    const std::size_t last = words.find_last_not_of('.', end - 1);
    const std::string number = words.substr(at, last + 1 - at);
    if (looks_measured(number)) numbers.push_back(number);
    at = end;
  }
  return numbers;
}

}  // namespace

Lines with_values(const Lines& paragraph, const Runner& run) {
  Lines made = paragraph;
  for (std::string& marker : made) {
    if (!is_marker(marker)) continue;
    const std::string what = inside(marker), shown = number_of(what);
    std::string now = shown;
    if (what.compare(shown.size(), by_hand.size(), by_hand) != 0) {
      const std::string equals = " = ";
      if (what.compare(shown.size(), equals.size(), equals) != 0) {
        throw Mistake("a value is NUMBER = PROGRAM | ROW | COLUMN, or NUMBER by hand: REASON: " +
                      what);
      }
      const std::string where = what.substr(shown.size() + equals.size());
      now = written(looked_up(where, run), shown);
      marker = marker_begin + now + equals + where + marker_end;
    }
    int count = 0;
    for (std::string& line : made) {
      if (!is_marker(line)) count += replace_number(line, without_sign(shown), without_sign(now));
    }
    if (count == 0) throw Mistake("the paragraph does not have this value: " + shown);
  }
  return made;
}

std::string without_values(const std::string& text) {
  const std::string equals = " = ";
  Lines values;
  std::istringstream lines(text);
  std::string made;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) values.clear();
    if (is_marker(line)) {
      const std::string number = number_of(line.substr(marker_begin.size()));
      if (line.compare(marker_begin.size() + number.size(), equals.size(), equals) == 0) {
        values.push_back(without_sign(number));
        line.replace(marker_begin.size(), number.size(), "#");
      }
    } else {
      for (const std::string& value : values) replace_number(line, value, "#");
    }
    made += line + "\n";
  }
  return made;
}

std::vector<Finding> unmarked_numbers(const std::string& text) {
  std::vector<Finding> findings;
  std::set<std::string> marked;
  std::istringstream stream(text);
  bool fence = false;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const auto begins = [&line](const char* with) { return line.rfind(with, 0) == 0; };
    if (begins("```")) fence = !fence;
    if (line.empty()) marked.clear();
    if (is_marker(line)) marked.insert(without_sign(number_of(inside(line))));
    if (fence || begins("```") || begins("<!--") || begins("|") || begins("$$")) continue;
    for (const std::string& measured : measured_in(line)) {
      if (marked.count(measured) > 0) continue;
      findings.push_back({number, "no <!-- value: " + measured + " ... --> above this paragraph"});
    }
  }
  return findings;
}

}  // namespace bounce::test
