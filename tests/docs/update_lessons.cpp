// Brings every block of README.md, docs/*.md, docs/deeper/*.md and docs/ja/*.md up to date with the
// code and the programs (the markers: lesson_tool.hpp). usage: update_lessons      exit code 1 when
// something is left that only an author can mend
//   update_lessons --stamp docs/ja/NAME.md...   says that these pages follow the English ones of
//   today, and no more

#include <fstream>
#include <iostream>

#include "docs/japanese.hpp"
#include "docs/lesson_tool.hpp"

using namespace bounce::test;

namespace {

const std::filesystem::path root = BOUNCE_SOURCE_DIR;

bool stamp(const std::filesystem::path& page) {
  const std::string path = (root / page).string(),
                    english = read_file((root / english_of(page)).string());
  std::string text = read_file(path);
  if (text.empty() || english.empty() || page.parent_path() != "docs/ja") {
    std::cerr << page.string()
              << ": a page to stamp is docs/ja/NAME.md, and stands beside docs/NAME.md\n";
    return false;
  }
  if (text.rfind("<!-- english: ", 0) == 0) text.erase(0, text.find('\n') + 1);
  return static_cast<bool>((std::ofstream(path, std::ios::binary) << stamp_of(english) << "\n"
                                                                  << text)
                               .flush());
}

}  // namespace

int main(int argc, char** argv) {
  bool good = true;
  if (argc > 1 && std::string(argv[1]) != "--stamp") {
    std::cerr << "usage: update_lessons [--stamp docs/ja/NAME.md...]\n";
    return 2;
  }
  for (int i = 2; i < argc; ++i) good = stamp(argv[i]) && good;
  if (argc > 1) return good ? 0 : 1;
  const Runner run = remembering(run_program);
  for (const auto& file : lesson_files(root)) {
    const std::string path = (root / file).string();
    const CheckedLesson checked = check_lesson(root, file, read_file(path), run);
    for (const Finding& mistake : checked.mistakes) {
      std::cerr << file.string() << ":" << mistake.line << ": " << mistake.message << "\n";
      good = false;
    }
    if (checked.drifted.empty()) continue;
    if (!(std::ofstream(path, std::ios::binary) << checked.text).flush()) {
      std::cerr << file.string() << ": cannot be written\n";
      good = false;
      continue;
    }
    std::cout << file.string() << ": " << checked.drifted.size() << " blocks updated\n";
  }
  return good ? 0 : 1;
}
