// The files that the stages read, each with one entry spoilt.

#include "hostile_lines.hpp"

namespace bounce::test {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

struct Spoilt {
  std::string text;
  std::string field;       // what was spoilt, as a sentence names it
  std::string value = "";  // what it is now; empty where it is gone
};

/// A file of "name value" lines again and again, each time with one of its numbers replaced by a
/// bad value, or a line gone. With `only`, just the lines that begin like that.
std::vector<Spoilt> spoilt(const std::string& text, const std::string& only = "") {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<Spoilt> all;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t space = lines[i].find(' ');
    if (space == std::string::npos || lines[i].rfind(only, 0) != 0) continue;
    const std::string name = lines[i].substr(0, space);
    const auto put = [&](const std::string& line, const std::string& value) {
      Spoilt changed{"", name == "numbers" ? "state" : name.substr(name.rfind('.') + 1), value};
      for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::string& text_of_it = k == i ? line : lines[k];
        if (!text_of_it.empty()) changed.text += text_of_it + "\n";
      }
      all.push_back(changed);
    };
    put("", "");
    const std::vector<std::string> numbers = split(lines[i].substr(space + 1));
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      if (n >= 60 && n + 1 < numbers.size()) continue;  // of a long list the first, and the last
      for (const std::string& value : bad_values) {
        std::vector<std::string> changed = numbers;
        changed[n] = value;
        put(name + " " + join(changed, ","), value);
      }
    }
  }
  return all;
}

std::string counted(const std::string& field) {
  return field == "steps" || field == "grid_steps" ? "whole " : "";
}

void add_saved_states(const std::vector<Known>& all, std::vector<Line>& lines) {
  ChildFolder folder;
  for (const Known& known : all) {
    const std::string& program = known.stage->name.name;
    for (const std::string& method : known.methods) {
      std::vector<std::string> words{"--headless", "--duration", "0.46", "--save",
                                     "state",      "--method",   method};
      if (program == "08_racket_game" && (method == "exact" || method == "reference"))
        words.insert(words.end(), {"--player", "none"});
      folder.run(program, words, {}, 60);
      const std::string saved = folder.read("state");
      const std::size_t end = saved.find("checksum ");
      if (end == std::string::npos) continue;
      // Parameters and clock are read alike for all methods; what each remembers is its own.
      const std::string only = method == known.methods[0] ? "" : "numbers ";
      for (const Spoilt& one : spoilt(saved.substr(0, end), only)) {
        std::vector<std::string> names{"--load", one.field};
        // A number of the state may fit nothing else there; of the rest it is said what it is.
        const bool is_number = parse_number(one.value).has_value() || one.value == "1,2";
        if (one.field != "state" || !is_number) names.push_back(one.value);
        // A clock whose parts contradict each other is told with the sum that they should be.
        const std::size_t line = saved.find("\n" + one.field + " ");
        const bool is_clock =
            one.field == "state" || (line != std::string::npos && line >= saved.find("\ntime "));
        if (is_clock && !is_number && (one.field != "state" || !one.value.empty())) {
          names.push_back("must be a " + counted(one.field) + "number from ");
        }
        lines.push_back({program,
                         {"--headless", "--load", "../in/state", "--duration", "0.5", "--csv", "-"},
                         names,
                         {{"state", with_checksum(one.text)}}});
      }
    }
  }
}

void add_recorded_inputs(std::vector<Line>& lines) {
  ChildFolder folder;
  folder.run("08_racket_game",
             {"--headless", "--duration", "0.2", "--player", "autopilot", "--record-input", "log"},
             {}, 60);
  for (const Spoilt& one : spoilt(folder.read("log"))) {
    lines.push_back({"08_racket_game",
                     {"--headless", "--replay", "../in/log", "--duration", "0.2", "--csv", "-"},
                     {one.field, one.value},
                     {{"log", one.text}}});
  }
}

/// Two balls in a file with these columns. `write` makes a file of a header and rows of words.
template <class Write>
void add_columns(const std::string& option, const std::vector<std::string>& columns,
                 const std::vector<std::vector<std::string>>& balls, const Write& write,
                 std::vector<Line>& lines) {
  const auto add = [&](const std::string& text, const std::vector<std::string>& names) {
    lines.push_back({"05_ball_collision",
                     {"--headless", option, "../in/balls", "--method", "velocity-verlet",
                      "--duration", "0.2", "--csv", "-"},
                     names,
                     {{"balls", text}}});
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const std::string& value : bad_values) {
      auto changed = balls;
      changed[0][i] = value;
      // Two values in one are one too many, and an empty one between spaces is none: then it is the
      // row that is wrong.
      const bool in_row = value == "1,2" ? option == "--balls" : value.empty();
      std::vector<std::string> names{option, in_row ? "columns" : columns[i]};
      if (option == "--balls" && value.empty()) names[1] = columns[i];
      if (!in_row && !value.empty()) names.push_back(value);
      add(write(columns, changed), names);
    }
    auto without = columns;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    auto fewer = balls;
    for (auto& ball : fewer) ball.erase(ball.begin() + static_cast<std::ptrdiff_t>(i));
    add(write(without, fewer), {option, columns[i]});
    auto twice = balls;
    twice[0].insert(twice[0].begin() + static_cast<std::ptrdiff_t>(i), twice[0][i]);
    add(write(columns, twice), {option, "line"});
  }
}

void add_balls_files(std::vector<Line>& lines) {
  add_columns(
      "--balls", {"mass", "radius", "x", "y", "z", "vx", "vy", "vz"},
      {{"1", "0.1", "0", "1", "0", "0", "0", "0"}, {"1", "0.1", "0.15", "1", "0", "0", "0", "0"}},
      [](const std::vector<std::string>& header, const auto& rows) {
        std::string text = join(header, ",") + "\n";
        for (const auto& row : rows) text += join(row, ",") + "\n";
        return text;
      },
      lines);
}

std::string dump(const std::string& step, const std::string& count, const std::string& rows) {
  return "ITEM: TIMESTEP\n" + step + "\nITEM: NUMBER OF ATOMS\n" + count +
         "\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\n" + rows;
}

void add_lammps_dumps(std::vector<Line>& lines) {
  const auto rows_of = [](const std::vector<std::string>& header, const auto& rows) {
    std::string text = "ITEM: ATOMS " + join(header, " ") + "\n";
    for (const auto& row : rows) text += join(row, " ") + "\n";
    return text;
  };
  const std::vector<std::string> columns{"id", "x",    "y",      "z",  "vx", "vy",
                                         "vz", "mass", "radius", "fx", "fy", "fz"};
  const std::vector<std::vector<std::string>> balls{
      {"1", "0", "1", "0", "0", "0", "0", "1", "0.1", "0", "-9.81", "0"},
      {"2", "0.15", "1", "0", "0", "0", "0", "1", "0.1", "0", "-9.81", "0"}};
  add_columns(
      "--import-lammps", columns, balls,
      [&](const auto& header, const auto& rows) { return dump("10", "2", rows_of(header, rows)); },
      lines);
  for (const std::string& value : bad_values) {
    for (const bool is_step : {true, false}) {
      lines.push_back(
          {"05_ball_collision",
           {"--headless", "--import-lammps", "../in/balls", "--duration", "0.2", "--csv", "-"},
           {"--import-lammps", "line"},
           {{"balls",
             dump(is_step ? value : "10", is_step ? "2" : value, rows_of(columns, balls))}}});
    }
  }
}

}  // namespace

std::vector<Line> lines_about_files(const std::vector<Known>& all) {
  std::vector<Line> lines;
  add_saved_states(all, lines);
  add_recorded_inputs(lines);
  add_balls_files(lines);
  add_lammps_dumps(lines);
  return lines;
}

}  // namespace bounce::test
