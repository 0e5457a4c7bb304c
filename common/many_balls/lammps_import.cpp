#include "many_balls/lammps_import.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "physics/text.hpp"
#include "run/input_file.hpp"

namespace bounce::many {
namespace {

constexpr std::array<const char*, 12> names{"id", "x",    "y",      "z",  "vx", "vy",
                                            "vz", "mass", "radius", "fx", "fy", "fz"};
constexpr std::size_t needed = 7;  // of these
constexpr std::size_t absent = std::string::npos;

class Dump {
 public:
  Dump(const std::string& option, const std::string& path) : file_(option, path) {}

  LammpsFrame last_frame() {
    if (!file_.next_line())
      file_.refuse_line("there is nothing: it must be a LAMMPS dump, dump custom as text");
    do {
      read_frame();
    } while (file_.next_line());
    return std::move(frame_);
  }

 private:
  /// The header up to "ITEM: ATOMS id ...", then the rows. The first line has been read.
  void read_frame() {
    long long count = -1;
    bool has_step = false;
    while (text().rfind("ITEM: ATOMS", 0) != 0) {
      if (text().rfind("ITEM: ", 0) != 0)
        file_.refuse_line("'" + text().substr(0, 40) + "' should be an ITEM:");
      if (text() == "ITEM: TIMESTEP") {
        frame_.step = read_count("TIMESTEP", {0, 1e15});
        has_step = true;
      } else if (text() == "ITEM: NUMBER OF ATOMS") {
        count = read_count("NUMBER OF ATOMS", {1, 1e9});
      } else {  // the box, the units, the time: not needed here
        const int lines = text().rfind("ITEM: BOX BOUNDS", 0) == 0 ? 3 : 1;
        for (int i = 0; i < lines; ++i) need_line();
      }
      need_line();
    }
    if (!has_step || count < 1)
      file_.refuse_line("TIMESTEP and NUMBER OF ATOMS must come before ATOMS");
    find_columns();
    read_rows(count);
  }

  void need_line() {
    if (!file_.next_line()) file_.refuse_line("the file ends in the middle of a frame");
  }

  long long read_count(const std::string& item, Range valid) {
    need_line();
    return file_.whole_number(item, text(), valid);
  }

  std::size_t split_words() {
    words_.clear();
    const std::string_view text = this->text();
    for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != text.npos;) {
      const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
      words_.push_back(text.substr(at, end - at));
      at = end;
    }
    return words_.size();
  }

  void find_columns() {
    columns_ = split_words() - 2;  // without "ITEM: ATOMS"
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto found = std::find(words_.begin() + 2, words_.end(), names[i]);
      place_[i] =
          found == words_.end() ? absent : static_cast<std::size_t>(found - words_.begin() - 2);
      if (place_[i] == absent && i < needed) {
        file_.refuse_line(std::string("column ") + names[i] +
                          " is missing; there must be id x y z vx vy vz");
      }
    }
    // A force without all of its components is none.
    const bool has_force =
        std::all_of(place_.begin() + 9, place_.end(), [](std::size_t at) { return at != absent; });
    if (!has_force) std::fill(place_.begin() + 9, place_.end(), absent);
  }

  void read_rows(long long count) {
    const auto size = static_cast<Eigen::Index>(count);
    std::vector<bool> seen(static_cast<std::size_t>(count), false);
    for (Eigen::Index row = 0; row < size; ++row) {
      need_line();
      if (row == 0) make_room(size);  // for a number of balls of which there is at least one
      if (split_words() != columns_) {
        file_.refuse_line("there are " + std::to_string(words_.size()) + " values for " +
                          std::to_string(columns_) + " columns; there must be one for each");
      }
      const long long id =
          file_.whole_number("column id", words_[place_[0]], {1, static_cast<double>(count)});
      const auto ball = static_cast<Eigen::Index>(id - 1);
      if (seen[static_cast<std::size_t>(ball)])
        file_.refuse_line("ball " + std::to_string(id) + " comes twice");
      seen[static_cast<std::size_t>(ball)] = true;
      read_ball(ball);
    }
  }

  void make_room(Eigen::Index size) {
    frame_.balls.position.resize(3, size);
    frame_.balls.velocity.resize(3, size);
    frame_.mass.resize(place_[7] == absent ? 0 : size);
    frame_.radius.resize(place_[8] == absent ? 0 : size);
    frame_.force.resize(3, place_[9] == absent ? 0 : size);
  }

  void read_ball(Eigen::Index ball) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<Eigen::Index>(axis);
      frame_.balls.position(row, ball) = value(1 + axis, -1e15, 1e15);
      frame_.balls.velocity(row, ball) = value(4 + axis, -1e15, 1e15);
      if (place_[9] != absent) frame_.force(row, ball) = value(9 + axis, -1e300, 1e300);
    }
    if (place_[7] != absent) frame_.mass[ball] = value(7, 1e-30, 1e30);
    if (place_[8] != absent) frame_.radius[ball] = value(8, 1e-30, 1e15);
  }

  double value(std::size_t column, double lowest, double highest) const {
    return file_.number(std::string("column ") + names[column], words_[place_[column]],
                        {lowest, highest});
  }
  const std::string& text() const { return file_.line(); }

  InputFile file_;
  std::vector<std::string_view> words_;  // of the line
  std::size_t columns_ = 0;
  std::array<std::size_t, names.size()> place_{};  // of each column in a row
  LammpsFrame frame_;
};

}  // namespace

LammpsFrame read_lammps_dump(const std::string& option, const std::string& path) {
  return Dump(option, path).last_frame();
}

}  // namespace bounce::many
