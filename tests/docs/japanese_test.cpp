// The Japanese edition, docs/ja: in step with the English one, and in the words of
// docs/ja/terms.md.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "docs/japanese.hpp"
#include "docs/phrases.hpp"

using namespace bounce::test;
namespace fs = std::filesystem;

namespace {

const fs::path pages_root = BOUNCE_SOURCE_DIR;

std::string text_of(const fs::path& file) { return read_file((pages_root / file).string()); }

/// All that is written in Japanese, but for the page that names the forbidden words.
std::vector<fs::path> japanese_files() {
  std::vector<fs::path> files{"tests/checks/japanese.txt"};
  for (const auto& entry : fs::directory_iterator(pages_root / "docs/ja")) {
    if (entry.path().filename() != "terms.md") files.push_back("docs/ja" / entry.path().filename());
  }
  for (const auto& entry : fs::recursive_directory_iterator(pages_root / "stages")) {
    const std::string name = entry.path().filename().string();
    if (name == "hints_ja.txt" || name == "gaps_ja.txt")
      files.push_back(fs::relative(entry.path(), pages_root));
  }
  return files;
}

std::vector<std::string> split(const std::string& text, const std::string& at) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t to; (to = text.find(at, from)) != std::string::npos; from = to + at.size()) {
    parts.push_back(text.substr(from, to - from));
  }
  parts.push_back(text.substr(from));
  return parts;
}

struct ForbiddenTerm {
  std::string word, say;
};

/// The third column of terms.md, and what stands in its second one.
std::vector<ForbiddenTerm> forbidden_words(const std::string& terms) {
  std::vector<ForbiddenTerm> all;
  std::istringstream lines(terms);
  int row = -2;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| ", 0) != 0 && line.rfind("|-", 0) != 0) continue;
    const std::vector<std::string> cells = split(line, "|");
    if (++row < 1 || cells.size() != 5) continue;
    for (std::string word : split(cells[3], "、")) {
      word.erase(0, word.find_first_not_of(' '));
      word.erase(word.find_last_not_of(' ') + 1);
      if (!word.empty()) all.push_back({word, cells[2]});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("each Japanese page says what the English one says") {
  const std::vector<fs::path> pages = japanese_pages(pages_root);
  CHECK(pages.size() >= 14);
  for (const fs::path& page : pages) {
    for (const std::string& said :
         differences(pages_root, page, text_of(english_of(page)), text_of(page)))
      FAIL_CHECK(page.string() << " and " << english_of(page).string() << " differ. " << said);
  }
}

TEST_CASE("no Japanese page is older than its English one") {
  const std::string tool = (fs::relative(BOUNCE_BIN_DIR, pages_root) / "update_lessons").string();
  for (const fs::path& page : japanese_pages(pages_root)) {
    const std::string text = text_of(page), stamp = stamp_of(text_of(english_of(page)));
    CHECK_MESSAGE(text.substr(0, text.find('\n')) == stamp, english_of(page).string(),
                  " has changed. Bring ", page.string(), " up to date, and then run  ", tool,
                  " --stamp ", page.string());
  }
}

TEST_CASE("every lesson is there in Japanese, and so is its exercise") {
  int lessons = 0;
  for (const auto& entry : fs::directory_iterator(pages_root / "stages")) {
    const fs::path stage = entry.path().filename();
    if (!fs::exists(entry.path() / "plain.cpp") || fs::exists(entry.path() / "tests")) continue;
    CAPTURE(stage.string());
    CHECK(fs::exists(pages_root / "docs/ja" / (stage.string() + ".md")));
    CHECK(fs::exists(entry.path() / "hints_ja.txt"));
    CHECK(fs::exists(entry.path() / "gaps_ja.txt"));
    ++lessons;
  }
  CHECK(lessons >= 8);
}

TEST_CASE("the words are those of docs/ja/terms.md") {
  const std::vector<ForbiddenTerm> words = forbidden_words(text_of("docs/ja/terms.md"));
  CHECK(words.size() > 40);
  for (const fs::path& file : japanese_files()) {
    std::istringstream lines(text_of(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      for (const ForbiddenTerm& one : words) {
        CHECK_MESSAGE(line.find(one.word) == std::string::npos, file.string(), ":", number, ": '",
                      one.word, "'. Say:", one.say);
      }
    }
  }
}

/// Signs that a browser would show as they are. `**` ends after 。, and begins before 「, only with
/// a space on its other side; $ begins and ends a formula only beside a space (or beside what is
/// ASCII). And * alone would slant what no Japanese book slants: **so**, or 「so」.
static std::string bare_sign(const std::string& line) {
  const auto ends_with_one_of = [](const std::string& text, const std::vector<std::string>& ends) {
    return std::any_of(ends.begin(), ends.end(), [&](const std::string& end) {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    });
  };
  const auto is_letter = [](char c) {
    return static_cast<unsigned char>(c) >= 128 || std::isalnum(c);
  };
  bool strong = false;  // between ** and **
  for (std::size_t at = line.find_first_of("*$"); at != std::string::npos;
       at = line.find_first_of("*$", at)) {
    const std::size_t end = std::min(line.find_first_not_of(line[at], at), line.size());
    const std::string before = line.substr(0, at), after = line.substr(end, 3);
    const char last = before.empty() ? ' ' : before.back(), next = after.empty() ? ' ' : after[0];
    const bool letters[] = {is_letter(last), is_letter(next)};
    const bool closes = ends_with_one_of(before, {"。", "、", "？", "！", "）", "」", "："});
    const bool opens = ends_with_one_of(after, {"（", "「"});
    const bool wide[] = {static_cast<unsigned char>(last) >= 128,
                         static_cast<unsigned char>(next) >= 128};
    const bool single = line[at] == '$' || end - at == 1;
    if (single && (wide[0] || wide[1])) return line.substr(at);
    if (!single && (strong ? closes && letters[1] : letters[0] && opens)) return line.substr(at);
    if (!single) strong = !strong;
    at = end;
  }
  return "";
}

TEST_CASE("what is emphasised, and what is a formula, is shown so") {
  CHECK(bare_sign("力 $F$ は**重力**です。 **ここで。** 次") == "");
  CHECK(bare_sign("では、**ここ**（**そこ**）") == "");
  CHECK(bare_sign("力$F$は") != "");
  CHECK(bare_sign("**床はばねです。**ボール") != "");
  CHECK(bare_sign("それは**「力」** です") != "");
  CHECK(bare_sign("それは *力* です") != "");
  for (const fs::path& page : japanese_pages(pages_root)) {
    std::istringstream lines(text_of(page));
    int number = 0;
    bool fence = false;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.rfind("```", 0) == 0) fence = !fence;
      const std::string bare = fence ? "" : bare_sign(line);
      CHECK_MESSAGE(bare.empty(), page.string(), ":", number,
                    ": put a space there, or make it bold: ", bare);
    }
  }
}

// ---- The tools themselves -----------------------------------------------------------------------

TEST_CASE("what two pages may not differ in") {
  const auto differ = [](const std::string& english, const std::string& japanese) {
    return differences(pages_root, "docs/ja/01_free_fall.md", english, japanese).size();
  };
  CHECK(differ("# Fall\n\nIt falls for 10 s, [twice](00_plan.md) as `v`.\n",
               "# 落下\n\n10 s間、[2回](00_plan.md)、 `v` で落ちる。\n") == 0);
  CHECK(differ("# Fall\n", "## 落下\n") == 1);
  CHECK(differ("# Fall\n\n## Next\n", "# 落下\n") == 1);
  CHECK(differ("<!-- cut: a b -->\n", "<!-- cut: a c -->\n") == 1);
  CHECK(differ("It is 10 m.\n", "1 mです。\n") == 2);
  CHECK(differ("It is 10 m.\n", "それです。\n") == 1);
  CHECK(differ("It is ten times 10 m.\n", "10 mの10倍です。\n") == 0);
  CHECK(differ("It is 10 m.\n", "10 mの10倍です。\n") == 1);
  CHECK(differ("It is $v$.\n", "$y$ です。\n") == 2);
  CHECK(differ("It is `v`.\n", "それです。\n") == 1);
  CHECK(differ("```sh\nls\n```\n", "```sh\ncd\n```\n") == 2);
  CHECK(differ("```text\n## It falls\nsee: 7 m\n```\n", "```text\n## 落ちる\nsee: 7 m\n```\n") ==
        0);
  CHECK(differ("```text\n## It falls\nsee: 7 m\n```\n", "```text\n## 落ちる\nsee: 8 m\n```\n") ==
        2);
  // A link leads to the Japanese page where there is one, and else to the same file.
  CHECK(differ("[a](deeper/01_free_fall.md#b)\n", "[あ](../deeper/01_free_fall.md#b)\n") == 0);
  CHECK(differ("[a](02_spring_floor.md)\n", "[あ](../02_spring_floor.md)\n") == 0);
  CHECK(differ("[a](../LICENSE)\n", "[あ](../../LICENSE)\n") == 0);
  CHECK(differ("[a](../LICENSE)\n", "[あ](../../README.md)\n") == 2);
  CHECK(differ("[a](ja/01_free_fall.md)\n", "[あ](../01_free_fall.md) [い](terms.md)\n") == 0);
  // What is made may differ: it is made anew.
  CHECK(differ("<!-- table: a b -->\n| 1 |\n", "<!-- table: a b -->\n| 2 |\n") == 0);
  CHECK(stamp_of("a\n<!-- table: a b -->\n| 1 |\n") == stamp_of("a\n<!-- table: a b -->\n| 2 |\n"));
  CHECK(stamp_of("a\n") != stamp_of("b\n"));
  // A sentence with a number that is looked up is a sentence; the number itself is made.
  const std::string mark = "<!-- value: 1.5 = fall | y -->\n";
  CHECK(differ(mark + "It is 1.5 m after 2 s.\n", mark + "2 s後に1.5 mです。\n") == 0);
  CHECK(differ(mark + "It is 1.5 m after 2 s.\n", mark + "3 s後に1.5 mです。\n") == 2);
  CHECK(stamp_of(mark + "It is 1.5 m.\n") ==
        stamp_of("<!-- value: -1.6 = fall | y -->\nIt is 1.6 m.\n"));
  CHECK(stamp_of(mark + "It is 1.5 m.\n") != stamp_of(mark + "It was 1.5 m.\n"));
  const std::string hand = " by hand: so -->\n";
  CHECK(stamp_of("<!-- value: 1.5" + hand + "It is 1.5 m.\n") !=
        stamp_of("<!-- value: 1.6" + hand + "It is 1.6 m.\n"));
}

TEST_CASE("what a phrase stands for") {
  const fs::path file = fs::path(work_folder()).parent_path() / "phrases.txt";
  std::ofstream(file)
      << "# a comment\n\nmass\n質量\n\nmore than {1} in {2} s\n{2}秒に{1}より多い\n";
  const Phrases phrases(file.string());
  CHECK(phrases.pairs().size() == 2);
  CHECK(phrases.japanese("mass") == "質量");
  CHECK(phrases.japanese("more than 30 in 5 s") == "5秒に30より多い");
  CHECK(!phrases.japanese("masses"));
  CHECK(!phrases.japanese("more than 30 in 5 min"));
  std::ofstream(file) << "mass\n\nforce\n力\n";
  CHECK_THROWS(Phrases(file.string()));
}
