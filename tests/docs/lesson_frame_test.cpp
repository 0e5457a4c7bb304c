// A lesson says one thing: what is counted here keeps it short and plain. All else is on its second
// page, docs/deeper/NN_name.md.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "docs/lesson_values.hpp"
#include "run_program.hpp"

using bounce::test::read_file;

namespace {

/// A stage has a lesson: "03_damping". The page that follows them is like one.
std::vector<std::string> all_lessons() {
  std::vector<std::string> lessons{"your_project"};
  for (const auto& stage : std::filesystem::directory_iterator(BOUNCE_SOURCE_DIR "/stages")) {
    if (!std::filesystem::exists(stage.path() / "main.cpp")) continue;
    lessons.push_back(stage.path().filename().string());
  }
  return lessons;
}

// Words for which there is a common one, or that do not belong here: with the reason.
struct ForbiddenWords {
  std::string words, reason;
};
const ForbiddenWords forbidden[] = {
    {"slides", "the learner has none"},
    {"by lot", "say: random"},
    {"dearer", "say: costs more"},
    {"henceforth", "say: from now on"},
    {"obviously", "it is not, to the one who asks"},
    {"the ball is a spring", "say: the floor is a spring"},
    {"made of a spring", "say: the floor is a spring"},
    {"notwithstanding", "say: but"},
};

struct Counts {
  int words = 0;
  int listings = 0;  // without commands (```sh), and without those inside <details>
  int tables = 0;    // not inside <details> either
  int sentences = 0;
};

/// A word has a letter or a digit in it: "-", "|" and "$=$" are none.
bool is_word(const std::string& text) {
  for (const char c : text) {
    const bool ascii = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (ascii) return true;
  }
  return false;
}

/// A sentence ends with . ? or !, and perhaps a closing mark after it.
bool ends_sentence(const std::string& word) {
  const std::size_t last = word.find_last_not_of("*\")_");
  return last != std::string::npos && std::string(".?!").find(word[last]) != std::string::npos;
}

/// Counts the words of a line of prose. `open` is how many the sentence that goes on has so far.
void count_prose(const std::string& line, Counts& counts, int& open) {
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    if (is_word(word)) {
      ++counts.words;
      ++open;
    }
    if (open > 0 && ends_sentence(word)) {
      ++counts.sentences;
      open = 0;
    }
  }
}

Counts count(const std::string& lesson) {
  Counts counts;
  std::istringstream stream(lesson);
  bool fence = false, folded = false, table = false;
  int open = 0;
  for (std::string line; std::getline(stream, line);) {
    const auto begins = [&line](const char* with) { return line.rfind(with, 0) == 0; };
    if (begins("```")) {
      if (!fence && !folded && line != "```sh") ++counts.listings;
      fence = !fence;
      continue;
    }
    if (fence || begins("<!--")) continue;
    if (begins("<details>")) folded = true;
    if (begins("</details>")) folded = false;
    if (begins("|") && !table && !folded) ++counts.tables;
    table = begins("|");
    // What ends a sentence without a full stop: an empty line, a heading, a formula on its own.
    if (line.empty() || begins("#") || begins("$$") || table) {
      if (open > 0) ++counts.sentences;
      open = 0;
    }
    if (begins("<") || begins("#") || begins("$$") || table) continue;
    count_prose(line, counts, open);
  }
  if (open > 0) ++counts.sentences;
  return counts;
}

}  // namespace

TEST_CASE("a lesson is short, and says it in plain words") {
  const std::vector<std::string> lessons = all_lessons();
  CHECK(lessons.size() >= 9);
  for (const std::string& lesson : lessons) {
    const std::string file = "docs/" + lesson + ".md";
    CAPTURE(file);
    const std::string text = read_file(std::string(BOUNCE_SOURCE_DIR) + "/" + file);
    const Counts counts = count(text);
    CHECK(counts.words > 100);  // the file is there
    CHECK(counts.words <= 900);
    CHECK(counts.listings <= 3);
    CHECK(counts.tables <= 1);
    CHECK_MESSAGE(counts.words <= 20 * counts.sentences,
                  "a sentence has more than 20 words: ", counts.words, " words in ",
                  counts.sentences, " sentences");
    for (const ForbiddenWords& one : forbidden) {
      CHECK_MESSAGE(text.find(one.words) == std::string::npos, "'", one.words, "': ", one.reason);
    }
  }
}

TEST_CASE(
    "a measured number in a sentence of a lesson has a marker: it is checked, or says why not") {
  for (const std::string& lesson : all_lessons()) {
    if (lesson == "your_project") continue;  // nothing there was measured
    for (const char* folder : {"docs/", "docs/ja/"}) {
      const std::string file = folder + lesson + ".md";
      const std::string text = read_file(std::string(BOUNCE_SOURCE_DIR) + "/" + file);
      for (const bounce::test::Finding& one : bounce::test::unmarked_numbers(text)) {
        FAIL_CHECK(file << ":" << one.line << ": " << one.message);
      }
    }
  }
}

TEST_CASE("how words, sentences, listings and tables are counted") {
  const std::string lesson =
      "# A heading is no prose\n\nOne two - three. Four *five*? $$\n\n"
      "<!-- cut: a b c -->\n```cpp\nint x;\n```\n\n```sh\nls a b c\n```\n\n"
      "<details>\n<summary>Open it</summary>\n\n```cpp\nint y;\n```\n\n| t |\n|---|\n\n</details>\n"
      "| a b c |\n|---|\n\n- six\n  seven\n";
  const Counts counts = count(lesson);
  CHECK(counts.words == 7);
  CHECK(counts.sentences == 3);
  CHECK(counts.listings == 1);
  CHECK(counts.tables == 1);
}
