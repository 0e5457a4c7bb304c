#pragma once
#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "05_ball_collision/scenes/scenes.hpp"
#include "physics/parameters.hpp"

namespace bounce {

/// A column of a balls file: name, unit, and what its numbers may be.
struct BallColumn {
  const char* name;
  const char* unit;
  Range valid;
};

inline constexpr std::array<BallColumn, 8> ball_columns{{{"mass", "kg", {1e-30, 1e30}},
                                                         {"radius", "m", {1e-30, 1e15}},
                                                         {"x", "m", {-1e15, 1e15}},
                                                         {"y", "m", {-1e15, 1e15}},
                                                         {"z", "m", {-1e15, 1e15}},
                                                         {"vx", "m/s", {-1e15, 1e15}},
                                                         {"vy", "m/s", {-1e15, 1e15}},
                                                         {"vz", "m/s", {-1e15, 1e15}}}};

/// Reads `--balls FILE`: a header line with the eight names above, in any order, then a line for
/// each ball. Throws BadInput with line and column. Balls may overlap, also deeply.
class BallsFile {
 public:
  explicit BallsFile(std::string path) : path_(std::move(path)), file_(path_) {}

  Arrangement read() {
    if (!file_.is_open()) refuse("it must be a file that can be read");
    std::vector<std::string> header;
    if (!next_line(header)) refuse("it is empty; line 1 must name the columns " + all_names());
    read_header(header);
    std::vector<std::array<double, 8>> rows;
    for (std::vector<std::string> words; next_line(words);) {
      if (words.size() == 1 && words[0].empty()) continue;
      rows.push_back(read_row(words));
    }
    if (file_.bad()) refuse("it must be a file that can be read");
    if (rows.empty()) refuse("there is no ball in it: line 2 must be the first one");
    Arrangement start(static_cast<Eigen::Index>(rows.size()));
    for (Eigen::Index ball = 0; ball < start.mass.size(); ++ball) {
      const std::array<double, 8>& row = rows[static_cast<std::size_t>(ball)];
      start.mass[ball] = row[0];
      start.radius[ball] = row[1];
      start.balls.position.col(ball) << row[2], row[3], row[4];
      start.balls.velocity.col(ball) << row[5], row[6], row[7];
    }
    return start;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw BadInput("--balls '" + path_ + "' is not allowed: " + why);
  }
  [[noreturn]] void refuse_line(const std::string& why) const {
    refuse("line " + std::to_string(line_) + ": " + why);
  }

  static std::string all_names() {
    std::vector<std::string> names;
    for (const BallColumn& column : ball_columns) names.push_back(column.name);
    return join(names, ",");
  }

  /// The words of the next line, without the spaces around them (or the \r that Windows leaves).
  bool next_line(std::vector<std::string>& words) {
    std::string line;
    if (!std::getline(file_, line)) return false;
    if (++line_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // some editors' mark
    words = split(line);
    for (std::string& word : words) {
      const std::size_t first = word.find_first_not_of(" \t\r");
      const std::size_t last = word.find_last_not_of(" \t\r");
      word = first == std::string::npos ? "" : word.substr(first, last - first + 1);
    }
    return true;
  }

  void read_header(const std::vector<std::string>& header) {
    width_ = header.size();
    for (std::size_t i = 0; i < ball_columns.size(); ++i) {
      const std::string name = ball_columns[i].name;
      const auto found = std::find(header.begin(), header.end(), name);
      if (found == header.end()) {
        refuse_line("column " + name + " is missing; the columns must be " + all_names());
      }
      place_[i] = static_cast<std::size_t>(found - header.begin());
    }
    if (width_ > ball_columns.size()) {
      refuse_line("there are " + std::to_string(width_) + " columns; the columns must be " +
                  all_names());
    }
  }

  std::array<double, 8> read_row(const std::vector<std::string>& words) const {
    std::array<double, 8> row{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      const BallColumn& column = ball_columns[i];
      const std::string place = std::string("column ") + column.name + ": ";
      if (place_[i] >= words.size()) refuse_line(place + "the value is missing");
      const std::string& word = words[place_[i]];
      const std::optional<double> value = parse_number(word);
      if (!value || !column.valid.contains(*value)) {
        refuse_line(place + "'" + word + "' must be a number from " + to_text(column.valid.lowest) +
                    " to " + to_text(column.valid.highest) + " (" + column.unit + ")");
      }
      row[i] = *value;
    }
    if (words.size() > width_) {
      refuse_line("there are " + std::to_string(words.size()) + " values for " +
                  std::to_string(width_) + " columns; there must be one for each");
    }
    return row;
  }

  std::string path_;
  std::ifstream file_;
  int line_ = 0;
  std::size_t width_ = 0;               // columns of this file
  std::array<std::size_t, 8> place_{};  // of each column in a row
};

}  // namespace bounce
