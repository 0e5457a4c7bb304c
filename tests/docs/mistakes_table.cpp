// The table of the named mistakes for docs/mistakes.md: what stands in the first lines of the files
// in tests/mistakes. usage: mistakes_table NN_name

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

static std::string after(const std::string& line, const std::string& key) {
  return line.rfind(key, 0) == 0 ? line.substr(key.size()) : "";
}

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: mistakes_table NN_name\n"), 2;
  const fs::path folder = fs::path(BOUNCE_SOURCE_DIR) / "tests/mistakes" / argv[1];
  if (!fs::is_directory(folder))
    return std::fprintf(stderr, "no folder %s\n", folder.string().c_str()), 2;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::printf(
      "| mistake | | the check that catches it | what the learner is told |\n|---|---|---|---|\n");
  for (const fs::path& path : files) {
    std::ifstream file(path);
    std::string why, check, told, seen;
    std::getline(file, why);
    std::getline(file, check);
    std::getline(file, told);
    std::getline(file, seen);
    check = after(check, "// check: ");
    told = after(told, "// told: ");
    seen = after(seen, "// seen: ");  // what the diagnosis says, where no known mistake fits
    if (!seen.empty()) told = "\"" + seen + "\"";
    if (after(why, "// ").empty() || check.empty() || told.empty()) {
      std::fprintf(stderr,
                   "%s: the first three lines must be // WHY, // check: ..., // told: ...\n",
                   path.string().c_str());
      return 1;
    }
    std::printf("| `%s` | %s | %s | %s |\n", path.stem().string().c_str(),
                after(why, "// ").c_str(), check.c_str(), told.c_str());
  }
}
