#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bounce::test {

// docs/ja/NAME.md says in Japanese what docs/NAME.md says in English, and docs/ja/start.md what the
// README.md of the project says. Its first line tells of which English:
//
//   <!-- english: 0123456789abcdef -->
//
// That is a hash of the English page, without what is made or looked up (lesson_tool.hpp). When the
// English changes, a test names the Japanese page. Bring it up to date by hand, and then
// `update_lessons --stamp docs/ja/NAME.md`.

/// The pages of docs/ja that have an English one, as paths from `root`.
std::vector<std::filesystem::path> japanese_pages(const std::filesystem::path& root);
/// docs/ja/NAME.md -> docs/NAME.md, docs/ja/start.md -> README.md
std::filesystem::path english_of(const std::filesystem::path& japanese);

/// The first line of the Japanese page of an English text.
std::string stamp_of(const std::string& english);

/// Where two pages do not say the same: headings, markers, links, code, formulas, numbers. One
/// sentence each.
std::vector<std::string> differences(const std::filesystem::path& root,
                                     const std::filesystem::path& japanese,
                                     const std::string& english_text,
                                     const std::string& japanese_text);

}  // namespace bounce::test
