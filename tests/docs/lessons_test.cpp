#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "docs/lesson_tool.hpp"
#include "docs/lesson_values.hpp"

using namespace bounce::test;
namespace fs = std::filesystem;

TEST_CASE("the lessons show what the code says and what the programs print" *
          doctest::skip(on_windows)) {  // last digits, where its C library rounds otherwise
  const fs::path root = BOUNCE_SOURCE_DIR;
  const Runner run = remembering(run_program);
  const std::string update =
      (fs::relative(BOUNCE_BIN_DIR, root) / "update_lessons").string() + "   mends it";
  for (const fs::path& file : lesson_files(root)) {
    const CheckedLesson checked = check_lesson(root, file, read_file((root / file).string()), run);
    for (const Finding& drift : checked.drifted) {
      FAIL_CHECK(file.string() << ":" << drift.line << ": " << drift.message << update);
    }
    for (const Finding& mistake : checked.mistakes) {
      FAIL_CHECK(file.string() << ":" << mistake.line << ": " << mistake.message);
    }
  }
}

TEST_CASE("every test that a page names is there") {
  const fs::path root = BOUNCE_SOURCE_DIR;
  std::string names = run_program("physics_tests -ltc").out;
  std::erase(names, '\r');  // Windows
  int found = 0;
  for (const fs::path& file : lesson_files(root)) {
    const std::string text = read_file((root / file).string());
    const std::string quote = "`stage ";
    for (std::size_t at = text.find(quote); at != std::string::npos;
         at = text.find(quote, at + 1)) {
      const std::string name = text.substr(at + 1, text.find('`', at + 1) - at - 1);
      if (name.find(": ") == std::string::npos) continue;  // no test's name
      INFO(file.string(), " names the test '", name, "'");
      CHECK(names.find("\n" + name + "\n") != std::string::npos);
      ++found;
    }
  }
  CHECK(found > 10);
}

/// "./course play 3 --set damping=18" and "build/release/bin/03_damping --set damping=18" are both
/// "03_damping --set damping=18"; empty for other commands.
static std::string stage_command(std::string line) {
  line.erase(std::min(line.find(" #"), line.size()));  // a comment
  line.erase(line.find_last_not_of(' ') + 1);
  const std::string play = "./course play ", bin = "build/release/bin/";
  if (line.rfind(bin, 0) == 0) return line.substr(bin.size());
  if (line.rfind(play, 0) != 0) return "";
  for (const auto& entry : fs::directory_iterator(fs::path(BOUNCE_SOURCE_DIR) / "stages")) {
    const std::string name = entry.path().filename().string();
    if (name[1] == line[play.size()]) return name + line.substr(play.size() + 1);
  }
  return "00_there_is_no_such_stage";
}

#ifdef BOUNCE_NO_PICTURES
constexpr bool has_pictures = false;
#else
constexpr bool has_pictures = true;
#endif

TEST_CASE("every command in the lessons runs") {
  const fs::path root = BOUNCE_SOURCE_DIR;
  int commands = 0;
  for (const fs::path& file : lesson_files(root)) {
    // The stage there is the reader's: tests/new_stage makes it and plays it.
    if (file.filename() == "contributing.md") continue;
    if (file.parent_path() == "docs/ja") continue;  // the same ones: japanese_test.cpp
    std::ifstream text(root / file);
    for (std::string line; std::getline(text, line);) {
      const std::string command = stage_command(line);
      if (command.empty()) continue;
      if (!has_pictures && command.find("--screenshot") != std::string::npos) {
        MESSAGE("left out, since this build has no pictures: ", line);
        continue;
      }
      ++commands;
      CAPTURE(line);
      const Outcome outcome = run_program(command + " --headless");
      CHECK_MESSAGE(outcome.code == 0, file.string(), ": ", outcome.err);
    }
  }
  CHECK(commands > 10);
}

TEST_CASE("the recorded hand in the clip of stage 8 keeps the ball up") {
  const Outcome outcome = run_program("08_racket_game --headless --duration 7.2 --replay " +
                                      quoted(BOUNCE_SOURCE_DIR "/docs/images/08_racket_game.txt"));
  CHECK_MESSAGE(outcome.err.find("hits=5 lost=no") != std::string::npos, outcome.err);
}

// ---- The tool itself, on a small project of its own ---------------------------------------------

namespace {

struct Project {
  fs::path root = fs::path(work_folder()).parent_path() / "project";
  Project() {
    fs::create_directories(root / "docs" / "deeper");
    std::ofstream(root / "docs" / "01_law.md") << "# Law\n";
    std::ofstream(root / "docs" / "deeper" / "01_law.md") << "# Law, deeper\n";
    std::ofstream(root / "plain.cpp") << "int main() {\n  // falls\n}\n";
    std::ofstream(root / "old.hpp") << "  // [law]\n  F = -m * g;\n  a = F / m;\n  // [law]\n";
    std::ofstream(root / "new.hpp") << "// [law]\nF = -m * g;\nif (y < r) {\n  F += k * (r - y);\n"
                                       "}\na = F / m;\n// [law]\n// [once]\n";
  }
  ~Project() { fs::remove_all(root); }

  /// The check of a lesson; the only program is `fall`.
  CheckedLesson check(const std::string& text, const std::string& name = "01_law.md") const {
    return check_lesson(root, fs::path("docs") / name, text, [](const std::string& command) {
      if (command == "fall --list") {
        return Outcome{0,
                       "fall: a ball\n\nparameter  unit   default   valid     meaning\n"
                       "mass       kg     1         positive  how much\n"
                       "contact           may-pull  a or b    may it pull?\n",
                       ""};
      }
      if (command == "fall cases") return Outcome{0, "a stone | 5 m\na leaf | 0.1 m\n", ""};
      return command == "fall --at 1" ? Outcome{0, "t,y\n1,0.095\n", ""} : Outcome{2, "", "what?"};
    });
  }
};

void check_clean(const CheckedLesson& checked, const std::string& text) {
  CHECK(checked.drifted.empty());
  CHECK(checked.mistakes.empty());
  CHECK(checked.text == text);
}

}  // namespace

TEST_CASE("a block that is as it should be passes, and one that drifted is found and mended") {
  const Project project;
  struct Case {
    std::string marker, block, drifted;
  };
  const Case cases[] = {
      {"<!-- cut: old.hpp law -->", "```cpp\nF = -m * g;\na = F / m;\n```\n",
       "```cpp\nF = m * g;\na = F / m;\n```\n"},
      {"<!-- cut: plain.cpp -->", "```cpp\nint main() {\n  // falls\n}\n```\n",
       "```cpp\nint main() {\n  // flies\n}\n```\n"},
      {"<!-- diff: old.hpp law | new.hpp law -->",
       "```diff\n  F = -m * g;\n+ if (y < r) {\n+   F += k * (r - y);\n+ }\n  a = F / m;\n```\n",
       "```diff\n  F = -m * g;\n+ if (y < r) F += k * (r - y);\n  a = F / m;\n```\n"},
      {"`fall --at 1` prints\n<!-- run: fall --at 1 -->", "```text\nt,y\n1,0.095\n```\n",
       "```text\nt,y\n1,0.096\n```\n"},
      {"<!-- list: fall -->",
       "| parameter | unit | default | valid | meaning |\n|---|---|---|---|---|\n"
       "| `mass` | kg | 1 | positive | how much |\n"
       "| `contact` |  | may-pull | a or b | may it pull? |\n",
       "| parameter | unit | default | valid | meaning |\n|---|---|---|---|---|\n"
       "| `mass` | kg | 2 | positive | how much |\n"},
      {"`fall --at 1`\n<!-- table: fall --at 1 -->", "t,y\n1,0.095\n", "t,y\n1,0.96\n"}};
  for (const Case& one : cases) {
    CAPTURE(one.marker);
    const std::string before = "# Law\n\n" + one.marker + "\n", after = "\nNext.\n";
    const std::string right = before + one.block + after;
    check_clean(project.check(right), right);

    for (const std::string& wrong : {one.drifted, std::string()}) {  // empty: not yet there
      const CheckedLesson checked = project.check(before + wrong + after);
      REQUIRE(checked.drifted.size() == 1);
      CHECK(checked.mistakes.empty());
      CHECK(checked.text == right);
      const long lines_before = std::count(before.begin(), before.end(), '\n');
      CHECK(checked.drifted[0].line == static_cast<std::size_t>(lines_before) + 1);
      CHECK(checked.drifted[0].message.find(one.block) != std::string::npos);
    }
  }
}

TEST_CASE("a table of cases has its second column from the program, and the rest from its author") {
  const Project project;
  const std::string before =
      "<!-- cases: fall cases -->\n| case | after 1 s | why |\n|---|---|---|\n";
  const std::string right =
      before + "| a leaf | 0.1 m | air |\n| a stone | 5 m | $g t^2/2$ |\n\nNext.\n";
  check_clean(project.check(right), right);
  const CheckedLesson checked =
      project.check(before + "| a leaf | ? | air |\n| a stone |  | $g t^2/2$ |\n\nNext.\n");
  CHECK(checked.drifted.size() == 1);
  CHECK(checked.text == right);
}

TEST_CASE("a number in a sentence is looked up where its marker says") {
  const Project project;
  const auto page = [](const std::string& number) {
    return "# Law\n\n<!-- value: " + number + " = fall --at 1 | 1 | y -->\n" +
           "<!-- value: 9.81 by hand: a constant -->\n- At " + number + " m, not at 10.10 m,\n" +
           "  so " + number + ". With 9.81.\n\nAt 0.11 m.\n";
  };
  check_clean(project.check(page("0.10")), page("0.10"));
  const CheckedLesson checked = project.check(page("0.11"));
  REQUIRE(checked.drifted.size() == 1);
  CHECK(checked.drifted[0].line == 3);
  CHECK(checked.mistakes.empty());
  CHECK(checked.text == page("0.10"));
  // The sign stands in the marker only. (The program says +0.095.)
  const std::string low = "<!-- value: -0.10 = fall --at 1 | 1 | y -->\n0.10 m too low.\n";
  CHECK(project.check(low).drifted.size() == 1);
}

TEST_CASE("numbers that look measured are found where no marker names them") {
  const std::string settings = "With 0.1 m, 1 ms, 1000 steps, 25 N, at 0 (and $9.81$ or `9.81`).\n";
  CHECK(unmarked_numbers(settings).empty());
  const std::string text =
      "<!-- value: 1.29 by hand: so -->\n1.29 times, 0.642.\n\nNow 1.29, 1853.";
  const std::vector<Finding> found = unmarked_numbers(text);
  REQUIRE(found.size() == 3);
  CHECK(found[0].message.find("0.642") != std::string::npos);
  CHECK(found[1].line == 4);
  CHECK(found[2].message.find("1853") != std::string::npos);
  CHECK(unmarked_numbers("| 1.29 |\n```sh\nfall --dt 0.015\n```\n[5.12](../0.12.md)\n").size() ==
        1);
}

TEST_CASE("what only an author can mend is said, with its line, and the text is left alone") {
  const Project project;
  struct Case {
    std::string text, says;
    std::size_t line;
  };
  const Case cases[] = {
      {"# Law\n<!-- cut: old.hpp low -->\n```cpp\n```\n", "// [low] 0 times", 2},
      {"<!-- cut: new.hpp once -->\n```cpp\n```\n", "// [once] 1 times", 1},
      {"<!-- cut: lost.hpp law -->\n```cpp\n```\n", "no file lost.hpp", 1},
      {"<!-- cut: old.hpp law 2 -->\n```cpp\n```\n", "FILE or FILE NAME", 1},
      {"<!-- diff: old.hpp law -->\n```diff\n```\n", "FILE1 NAME1 | FILE2 NAME2", 1},
      {"`fall --at 2`\n<!-- run: fall --at 2 -->\n```text\n```\n", "exit code 2: what?", 2},
      {"<!-- run: fall --at 1 -->\n```text\nt,y\n1,0.095\n```\n", "does not show the command", 1},
      {"<!-- list: fell -->\n", "exit code 2", 1},
      {"\n<!-- cut: old.hpp law -->\n```cpp\nF = -m * g;\n", "never closed: ```cpp", 2},
      {"```sh\nls\n\n```sh\nls\n```\n", "never closed: ```sh", 1},
      {"```cpp\nint x;\n```\n", "no marker", 1},
      {"- x\n  ```cpp\n", "beginning of a line", 2},
      {"~~~\n", "beginning of a line", 1},
      {"<!-- cases: fall cases -->\n| c | n |\n|---|---|\n| a stone | 5 m |\n",
       "a case without a row: a leaf", 1},
      {"<!-- cases: fall cases -->\n| c | n |\n|---|---|\n| a cat | 1 m |\n",
       "no line for the case", 1},
      {"<!-- cases: fall --at 1 -->\n| c | n |\n|---|---|\n", "should print CASE | TEXT", 1},
      {"<!-- value: 0.1 = fall --at 1 | 2 | y -->\n0.1 m\n", "0 rows, and not one", 1},
      {"<!-- value: 0.1 = fall --at 1 | 1 | z -->\n0.1 m\n", "no column 'z'", 1},
      {"<!-- value: 0.1 = fall --at 1 -->\n0.1 m\n", "NUMBER = PROGRAM | ROW | COLUMN", 1},
      {"<!-- value: 0.1 by heart -->\n0.1 m\n", "NUMBER by hand: REASON", 1},
      {"<!-- value: 0.1 = fall --at 1 | 1 | y -->\n0.15 m and 20.1 m\n", "does not have", 1},
      {"<!-- value: 0.1 = fell | 1 | y -->\n0.1 m\n", "exit code 2", 1},
      {"<!-- cuts: old.hpp law -->\n", "no marker of the kind 'cuts'", 1},
      {"<!-- cut: old.hpp law\n", "a marker looks like", 1},
      {"<!-- cut: -->\n", "a marker looks like", 1},
      {"One.\nSee [two](02_gone.md#start).\n", "leads nowhere: 02_gone.md", 2},
      {"![a ball](images/gone.png)\n", "leads nowhere: images/gone.png", 1},
  };
  for (const Case& one : cases) {
    CAPTURE(one.text);
    const CheckedLesson checked = project.check(one.text);
    REQUIRE(checked.mistakes.size() == 1);
    CHECK(checked.mistakes[0].message.find(one.says) != std::string::npos);
    CHECK(checked.mistakes[0].line == one.line);
    CHECK(checked.drifted.empty());
    CHECK(checked.text == one.text);
  }
}

TEST_CASE("the second pages are checked too, and their links count from their own folder") {
  const Project project;
  const std::vector<fs::path> expected{"docs/01_law.md", "docs/deeper/01_law.md"};
  CHECK(lesson_files(project.root) == expected);
  const std::string up = "Back to [the lesson](../01_law.md), [code](../../old.hpp).\n";
  check_clean(project.check(up, "deeper/01_law.md"), up);
  const std::string not_from_here = "See [code](../old.hpp).\n";
  CHECK(project.check(not_from_here).mistakes.empty());
  CHECK(project.check(not_from_here, "deeper/01_law.md").mistakes.size() == 1);
  CHECK(project.check("```cpp\nint x;\n```\n", "deeper/01_law.md").mistakes.size() == 1);
}

TEST_CASE("a table of a Japanese page has its words from docs/ja/tables.txt") {
  const Project project;
  fs::create_directories(project.root / "docs" / "ja");
  std::ofstream words(project.root / "docs" / "ja" / "tables.txt");
  words << "parameter\nパラメータ\n\nunit\n単位\n\ndefault\n既定値\n\nvalid\n許される値\n\n"
           "meaning\n意味\n\nkg\nkg（キログラム）\n\npositive\n正\n\nhow much\nどれだけ\n\n"
           "may-pull\nmay-pull\n\na or b\na or b\n\n";
  words.flush();
  const std::string page = "<!-- english: 0123456789abcdef -->\n# 法則\n\n<!-- list: fall -->\n";
  const CheckedLesson checked = project.check(page, "ja/01_law.md");
  REQUIRE(checked.mistakes.size() == 1);  // the last one has no words yet
  CHECK(checked.mistakes[0].message == "docs/ja/tables.txt has no Japanese for: may it pull?");
  words << "may it pull?\n引くか\n" << std::flush;
  const CheckedLesson whole = project.check(page, "ja/01_law.md");
  CHECK(whole.mistakes.empty());
  CHECK(whole.text ==
        page +
            "| パラメータ | 単位 | 既定値 | 許される値 | 意味 |\n|---|---|---|---|---|\n"
            "| `mass` | kg（キログラム） | 1 | 正 | どれだけ |\n"
            "| `contact` |  | may-pull | a or b | 引くか |\n");
}

TEST_CASE("what may be written by hand") {
  const Project project;
  const std::string shell = "```sh\n./course play 1\n```\n";
  const std::string explained = "<!-- by hand: it is wrong on purpose -->\n```cpp\nint x\n```\n";
  const std::string links = "[code](../old.hpp) [web](https://example.org/a) [here](#law)\n";
  for (const std::string& text : {shell, explained, links}) check_clean(project.check(text), text);
  const std::string free = "```cpp\nint x;\n```\n";
  check_clean(project.check(free, "architecture.md"), free);  // only the numbered lessons are cut
}
