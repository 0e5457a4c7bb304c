#include "docs/lesson_tool.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>

#include "docs/lesson_values.hpp"
#include "docs/phrases.hpp"

namespace bounce::test {

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();  // as programs print on Windows
    lines.push_back(line);
  }
  return lines;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

bool is_fence(const std::string& line) { return line.rfind("```", 0) == 0; }

// ---- Where blocks come from ---------------------------------------------------------------------

/// "FILE": all its lines. "FILE NAME": those between two `// [NAME]` lines, without the spaces that
/// all of them begin with.
Lines cut(const fs::path& root, const std::string& what) {
  std::istringstream words(what);
  std::string file, name, more;
  words >> file >> name;
  if (file.empty() || words >> more) throw Mistake("a cut is FILE or FILE NAME: " + what);
  if (!fs::is_regular_file(root / file)) throw Mistake("there is no file " + file);
  if (name.empty()) return lines_of(read_file((root / file).string()));
  const std::string anchor = "// [" + name + "]";
  Lines found;
  int anchors = 0;
  for (const std::string& line : lines_of(read_file((root / file).string()))) {
    if (trimmed(line) == anchor) {
      ++anchors;
    } else if (anchors == 1) {
      found.push_back(line);
    }
  }
  if (anchors != 2) {
    throw Mistake(file + " has the line " + anchor + " " + std::to_string(anchors) +
                  " times: it takes one before the lines and one after them");
  }
  std::size_t indent = std::string::npos;
  for (const std::string& line : found) indent = std::min(indent, line.find_first_not_of(' '));
  for (std::string& line : found) line.erase(0, std::min(indent, line.size()));
  return found;
}

/// Line by line, by the longest common subsequence.
Lines difference(const Lines& a, const Lines& b) {
  const std::size_t n = a.size(), m = b.size();
  std::vector<std::vector<std::size_t>> common(n + 1, std::vector<std::size_t>(m + 1, 0));
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = m; j-- > 0;) {
      common[i][j] =
          a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  Lines lines;
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    if (i < n && j < m && a[i] == b[j]) {
      lines.push_back("  " + a[i++]);
      ++j;
    } else if (j == m || (i < n && common[i + 1][j] >= common[i][j + 1])) {
      lines.push_back("- " + a[i++]);
    } else {
      lines.push_back("+ " + b[j++]);
    }
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

}  // namespace

Lines output_of(const std::string& command, const Runner& run) {
  const Outcome outcome = run(command);
  if (outcome.code == 0) return lines_of(outcome.out);
  throw Mistake(command + " ended with exit code " + std::to_string(outcome.code) + ": " +
                outcome.err);
}

namespace {

/// The table that `--list` prints in columns; its header line tells where they begin.
Lines parameter_table(const std::string& stage, const Runner& run) {
  std::vector<std::size_t> begin;
  Lines table;
  for (const std::string& line : output_of(stage + " --list", run)) {
    if (begin.empty() && line.rfind("parameter", 0) == 0) {
      for (const char* word : {"parameter", "unit", "default", "valid", "meaning"}) {
        begin.push_back(line.find(word));
      }
    }
    if (begin.empty()) continue;
    std::string row = "|";
    for (std::size_t i = 0; i < begin.size(); ++i) {
      if (begin[i] > line.size() || (i > 0 && line[begin[i] - 1] != ' ')) {
        throw Mistake(stage + " --list: this line is not in its columns: " + line);
      }
      const std::size_t end = i + 1 < begin.size() ? begin[i + 1] : std::string::npos;
      const std::string cell = trimmed(line.substr(begin[i], end - begin[i]));
      const bool is_name = i == 0 && !table.empty();
      row += (is_name ? " `" + cell + "`" : " " + cell) + " |";
    }
    table.push_back(row);
    if (table.size() == 1) table.push_back("|---|---|---|---|---|");
  }
  if (table.size() < 3) throw Mistake(stage + " --list shows no parameters");
  return table;
}

/// The table `found`, but each row's second cell as the program tells it, by the row's first cell.
Lines table_of_cases(const std::string& command, const Lines& found, const Runner& run) {
  const std::string bar = " | ";
  std::map<std::string, std::string> told;
  for (const std::string& line : output_of(command, run)) {
    const std::size_t at = std::min(line.find(bar), line.size());
    if (at == line.size() || !told.emplace(line.substr(0, at), line.substr(at + 3)).second) {
      throw Mistake(command + " should print CASE | TEXT, each case once: " + line);
    }
  }
  Lines table(found.begin(), found.begin() + std::min<long>(2, std::ssize(found)));
  for (std::size_t i = 2; i < found.size(); ++i) {
    const std::string& row = found[i];
    const std::size_t first = row.find(bar), second = row.find(" |", first + 2);
    if (std::max(first, second) == std::string::npos)
      throw Mistake("a row of cases has more cells: " + row);
    const auto text = told.extract(row.substr(2, first - 2));
    if (text.empty()) throw Mistake(command + " has no line for the case " + row);
    table.push_back(row.substr(0, first) + bar + text.mapped() + row.substr(second));
  }
  if (!told.empty())
    throw Mistake(command + " tells of a case without a row: " + told.begin()->first);
  return table;
}

/// The block that belongs after the marker, with its fence; `found` is what stands there.
Lines block_for(const std::string& kind, const std::string& what, const Lines& found,
                const fs::path& root, const Runner& run) {
  const auto fenced = [](const std::string& language, Lines lines) {
    lines.insert(lines.begin(), "```" + language);
    lines.push_back("```");
    return lines;
  };
  if (kind == "cut") return fenced("cpp", cut(root, what));
  if (kind == "run") return fenced("text", output_of(what, run));
  if (kind == "list") return parameter_table(what, run);
  if (kind == "table") return output_of(what, run);
  if (kind == "cases") return table_of_cases(what, found, run);
  const std::size_t bar = what.find(" | ");
  if (bar == std::string::npos) throw Mistake("a diff is FILE1 NAME1 | FILE2 NAME2: " + what);
  return fenced("diff",
                difference(cut(root, what.substr(0, bar)), cut(root, what.substr(bar + 3))));
}

/// A table in the words of docs/ja/tables.txt: its head, and the cells that are neither numbers nor
/// code.
Lines in_japanese(const Lines& table, const fs::path& root) {
  const Phrases phrases((root / "docs/ja/tables.txt").string());
  const auto has_words = [](const std::string& cell) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return cell.find('`') == std::string::npos && std::any_of(cell.begin(), cell.end(), letter);
  };
  Lines made;
  for (const std::string& row : table) {
    std::string line;
    std::istringstream cells(row);
    for (std::string cell; std::getline(cells, cell, '|');) {
      const std::string text = trimmed(cell);
      const auto said = phrases.japanese(text);
      if (!said && has_words(text))
        throw Mistake("docs/ja/tables.txt has no Japanese for: " + text);
      line += (said ? " " + *said + " " : cell) + "|";
    }
    made.push_back(line);
  }
  return made;
}

// ---- The lesson ---------------------------------------------------------------------------------

/// Where the block that begins at line `at` ends (one beyond its last line); `at` when there is
/// none.
std::size_t end_of_block(const Lines& lines, std::size_t at, bool table) {
  if (table) {
    while (at < lines.size() && !trimmed(lines[at]).empty()) ++at;
    return at;
  }
  if (at == lines.size() || !is_fence(lines[at])) return at;
  for (std::size_t i = at + 1; i < lines.size(); ++i) {
    if (lines[i] == "```") return i + 1;
    if (is_fence(lines[i])) break;
  }
  throw Mistake("this fence is never closed: " + lines[at]);
}

/// `<!-- KIND: WHAT -->`
struct Marker {
  std::string kind, what;
  explicit Marker(const std::string& line) {
    const std::string begin = "<!-- ", end = " -->";
    const std::size_t colon = line.find(": ");
    if (line.rfind(begin, 0) != 0 || colon == std::string::npos ||
        line.size() < colon + 2 + end.size() ||
        line.compare(line.size() - end.size(), end.size(), end) != 0) {
      throw Mistake("a marker looks like <!-- cut: FILE NAME -->");
    }
    kind = line.substr(begin.size(), colon - begin.size());
    what = trimmed(line.substr(colon + 2, line.size() - end.size() - colon - 2));
    const Lines kinds{"cut",   "diff",  "run",     "list",   "table",
                      "cases", "value", "by hand", "english"};
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
      throw Mistake("there is no marker of the kind '" + kind + "'");
    }
  }
};

void check_links(const std::string& line, const fs::path& folder) {
  for (std::size_t at = line.find("]("); at != std::string::npos; at = line.find("](", at + 2)) {
    std::string target = line.substr(at + 2, line.find(')', at) - at - 2);
    target.erase(std::min(target.find_first_of("# "), target.size()));
    const bool elsewhere = target.empty() || target.find("://") != std::string::npos ||
                           target.rfind("mailto:", 0) == 0;
    if (!elsewhere && !fs::exists(folder / target)) {
      throw Mistake("this link leads nowhere: " + target);
    }
  }
}

}  // namespace

CheckedLesson check_lesson(const fs::path& root, const fs::path& file, const std::string& text,
                           const Runner& run) {
  const bool all_marked = file.filename().string().rfind("0", 0) == 0;  // in the numbered lessons
  const bool japanese = file.parent_path().filename() == "ja";
  const Lines lines = lines_of(text);
  CheckedLesson checked;
  Lines made;
  for (std::size_t i = 0, end; i < lines.size(); i = end) {
    end = i + 1;
    try {
      if (lines[i].rfind("<!-- live: ", 0) == 0) {  // docs/site/site.mjs reads it
      } else if (lines[i].rfind("<!--", 0) == 0) {
        const auto [kind, what] = Marker(lines[i]);
        if (kind == "value") {
          end = end_of_block(lines, i, true);
          const Lines found(lines.begin() + static_cast<long>(i),
                            lines.begin() + static_cast<long>(end));
          for (const std::string& line : found) check_links(line, (root / file).parent_path());
          const Lines paragraph = with_values(found, run);
          if (found != paragraph) {
            checked.drifted.push_back({i + 1, "the paragraph is\n" + text_of(found) +
                                                  "and should be\n" + text_of(paragraph)});
          }
          made.insert(made.end(), paragraph.begin(), paragraph.end());
          continue;
        }
        end = lines.size();  // a fence that is never closed swallows the rest
        end = end_of_block(lines, i + 1, kind == "list" || kind == "table" || kind == "cases");
        if (kind == "english") {
          end = i + 1;
        } else if (kind != "by hand") {
          if (kind == "run" && text.find(what) == text.rfind(what)) {
            throw Mistake("the text does not show the command of this block: " + what);
          }
          const Lines found(lines.begin() + static_cast<long>(i) + 1,
                            lines.begin() + static_cast<long>(end));
          Lines block = block_for(kind, what, found, root, run);
          if (japanese && (kind == "list" || kind == "table")) block = in_japanese(block, root);
          if (found != block) {
            checked.drifted.push_back(
                {i + 2, "the block is\n" + text_of(found) + "and should be\n" + text_of(block)});
          }
          made.push_back(lines[i]);
          made.insert(made.end(), block.begin(), block.end());
          continue;
        }
      } else if (is_fence(lines[i])) {
        end = lines.size();
        end = end_of_block(lines, i, false);
        if (all_marked && lines[i] != "```sh") {
          throw Mistake("no marker says where this block comes from (or <!-- by hand: reason -->)");
        }
      } else if (all_marked && (is_fence(trimmed(lines[i])) || lines[i].rfind("~~~", 0) == 0)) {
        throw Mistake("a fence is ``` at the beginning of a line");
      } else {
        check_links(lines[i], (root / file).parent_path());
      }
    } catch (const Mistake& mistake) {
      checked.mistakes.push_back({i + 1, mistake.what()});
    }
    made.insert(made.end(), lines.begin() + static_cast<long>(i),
                lines.begin() + static_cast<long>(end));
  }
  checked.text = text_of(made);
  return checked;
}

Runner remembering(const Runner& run) {
  const auto outcomes = std::make_shared<std::map<std::string, Outcome>>();
  return [=](const std::string& command) {
    const auto known = outcomes->find(command);
    return known != outcomes->end() ? known->second
                                    : outcomes->emplace(command, run(command)).first->second;
  };
}

std::vector<fs::path> lesson_files(const fs::path& root) {
  std::vector<fs::path> files;
  if (fs::exists(root / "README.md")) files.push_back("README.md");
  for (const fs::path folder : {"docs", "docs/deeper", "docs/ja"}) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") files.push_back(folder / entry.path().filename());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace bounce::test
