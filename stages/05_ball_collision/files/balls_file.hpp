#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "05_ball_collision/scenes/scenes.hpp"
#include "run/input_file.hpp"

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
/// each ball. Balls may overlap, also deeply. What spreadsheets make of such a table is understood:
/// `;` or tabs between the columns, quotes, capitals, empty rows, commas at the end; and lines that
/// begin with # are comments.
class BallsFile {
 public:
  explicit BallsFile(const std::string& path) : file_("--balls", path) {}

  Arrangement read() {
    if (!next_row()) file_.refuse("it is empty; line 1 must name the columns " + all_names());
    read_header();
    std::vector<std::array<double, 8>> rows;
    while (next_row()) rows.push_back(read_row());
    if (rows.empty()) file_.refuse("there is no ball in it: line 2 must be the first one");
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
  static std::string all_names() {
    std::vector<std::string> names;
    for (const BallColumn& column : ball_columns) names.push_back(column.name);
    return join(names, ",");
  }

  /// The words of the next line that has some.
  bool next_row() {
    while (file_.next_line()) {
      const std::string& line = file_.line();
      if (!line.empty() && line[0] == '#') continue;
      if (width_ == 0) {  // the header tells what is between the columns
        for (const char other : {';', '\t'}) {
          if (line.find(',') == line.npos && line.find(other) != line.npos) separator_ = other;
        }
      }
      words_ = split(line, separator_);
      while (!words_.empty() && words_.back().empty() && words_.size() > width_) words_.pop_back();
      const auto is_empty = [](const std::string& word) { return word.empty(); };
      if (!std::all_of(words_.begin(), words_.end(), is_empty)) return true;
    }
    return false;
  }

  void read_header() {
    for (std::string& name : words_) {
      if (name.size() > 1 && name.front() == '"' && name.back() == '"') {
        name = name.substr(1, name.size() - 2);
      }
      for (char& letter : name) {
        if ('A' <= letter && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
      }
    }
    width_ = words_.size();
    for (std::size_t i = 0; i < ball_columns.size(); ++i) {
      const auto found = std::find(words_.begin(), words_.end(), ball_columns[i].name);
      if (found == words_.end()) {
        file_.refuse_line(std::string("column ") + ball_columns[i].name +
                          " is missing; the columns must be " + all_names());
      }
      place_[i] = static_cast<std::size_t>(found - words_.begin());
    }
    if (width_ > ball_columns.size()) {
      file_.refuse_line("there are " + std::to_string(width_) + " columns; the columns must be " +
                        all_names());
    }
  }

  std::array<double, 8> read_row() const {
    std::array<double, 8> row{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      const BallColumn& column = ball_columns[i];
      const std::string name = std::string("column ") + column.name;
      if (place_[i] >= words_.size()) file_.refuse_line(name + ": the value is missing");
      const std::string& word = words_[place_[i]];
      if (separator_ != ',' && word.find(',') != word.npos) {
        file_.refuse_line(name + ": '" + word +
                          "' must be written with a point in place of the comma");
      }
      row[i] = file_.number(name, word, column.valid, column.unit);
    }
    if (words_.size() > width_) {
      file_.refuse_line("there are " + std::to_string(words_.size()) + " values for " +
                        std::to_string(width_) + " columns; there must be one for each");
    }
    return row;
  }

  InputFile file_;
  char separator_ = ',';
  std::vector<std::string> words_;      // of the line
  std::size_t width_ = 0;               // columns of this file
  std::array<std::size_t, 8> place_{};  // of each column in a row
};

}  // namespace bounce
