// Brings every block of README.md, docs/*.md and docs/deeper/*.md up to date with the code and the
// programs (the markers: lesson_tool.hpp). usage: update_lessons      exit code 1 when something is
// left that only an author can mend

#include <fstream>
#include <iostream>

#include "docs/lesson_tool.hpp"

using namespace bounce::test;

int main() {
  const std::filesystem::path root = BOUNCE_SOURCE_DIR;
  const Runner run = remembering(run_program);
  bool good = true;
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
