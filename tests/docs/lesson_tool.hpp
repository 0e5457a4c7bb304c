#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace bounce::test {

// What a lesson shows is not typed in but made: listings are cut from compiled files, outputs come
// from runs. A marker on the line before a block tells where from:
//
//   <!-- cut: FILE NAME -->                    the lines of FILE between two `// [NAME]` lines
//   <!-- cut: FILE -->                         the whole of FILE
//   <!-- diff: FILE1 NAME1 | FILE2 NAME2 -->   what changed from the one cut to the other
//   <!-- run: PROGRAM ARGS -->                 what that program prints
//   <!-- list: 03_damping -->                  a stage's parameters, as a table
//   <!-- table: lesson_numbers NAME -->        what that program prints, as a table
//   <!-- cases: naive_numbers NAME -->         a table whose second column that program prints: a
//                                              line "CASE | TEXT" for each row, by its first cell
//   <!-- live: STAGE ... -->                   nothing: the web page has a live figure here
//   <!-- by hand: REASON -->                   not made; the reason says why
//   <!-- english: HASH -->                     on top of a page of docs/ja: docs/japanese.hpp
//
// A measured number that stands in a sentence has a marker above its paragraph (or list), with the
// digits that the sentence gives it. Where it stands: the program that prints a table or a CSV, the
// first cells of its row, its column. The sign, if any, stands in the marker only.
//
//   <!-- value: 11.7 = lesson_numbers rest | 0.001 | error of the first top [mm] -->
//   <!-- value: 9.81 by hand: REASON -->
//
// The first three are followed by a fenced block, the next three by a markdown table that ends at a
// blank line. FILE counts from the top of the project. In docs/ja a table is in the words of
// docs/ja/tables.txt.

/// Something wrong in a lesson: where, and what to do about it.
struct Finding {
  std::size_t line;  // from 1
  std::string message;
};

struct CheckedLesson {
  std::string text;               // the lesson, with every block as it should be
  std::vector<Finding> drifted;   // blocks that differ from that: `update_lessons` mends them
  std::vector<Finding> mistakes;  // what only an author can mend
};

using Runner = std::function<Outcome(const std::string& command)>;

/// Checks one markdown file, `file` (a path from `root`, the top of the project) with this `text`.
CheckedLesson check_lesson(const std::filesystem::path& root, const std::filesystem::path& file,
                           const std::string& text, const Runner& run);

/// Runs each command once, and tells the same again.
Runner remembering(const Runner& run);

/// README.md, docs/*.md, docs/deeper/*.md and docs/ja/*.md, as paths from `root`.
std::vector<std::filesystem::path> lesson_files(const std::filesystem::path& root);

}  // namespace bounce::test
