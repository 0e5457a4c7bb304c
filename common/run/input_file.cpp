#include "run/input_file.hpp"

#include <filesystem>

#include "physics/text.hpp"
#include "run/file_name.hpp"

namespace bounce {
InputFile::InputFile(std::string option, std::string path, const std::string& hint)
    : option_(std::move(option)),
      path_(std::move(path)),
      hint_(hint.empty() ? "" : "; " + hint),
      file_(path_, std::ios::binary) {
  std::error_code error;
  if (std::filesystem::is_directory(path_of(path_), error))
    refuse("it is a folder, and must be a file");
  if (!file_.is_open()) refuse("it must be a file that can be read");
}

bool InputFile::next_line() {
  const bool is_there = static_cast<bool>(std::getline(file_, line_));
  if (file_.bad()) refuse("it must be a file that can be read");
  if (++number_of_line_ == 1) {
    if (line_.rfind("\xEF\xBB\xBF", 0) == 0) line_.erase(0, 3);
    if (line_.rfind("\xFF\xFE", 0) == 0 || line_.rfind("\xFE\xFF", 0) == 0) {
      refuse("it is written in UTF-16, and must be in UTF-8 (in a spreadsheet: \"CSV UTF-8\")");
    }
  }
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  return is_there;
}

std::string InputFile::whole() {
  const std::filesystem::path path = path_of(path_);
  if (!std::filesystem::is_regular_file(path)) refuse("it is no file that can be read");
  std::string text(static_cast<std::size_t>(std::filesystem::file_size(path)), ' ');
  file_.seekg(0);
  if (!file_.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    refuse("it must be a file that can be read");
  }
  return text;
}

double InputFile::number(const std::string& name, std::string_view word, Range valid,
                         const std::string& unit, bool is_whole) const {
  if (const auto value = parse_number_in(word, valid, is_whole)) return *value;
  refuse_line(name + ": '" + std::string(word.substr(0, 40)) + "' must be " +
              number_in(valid, unit, is_whole));
}

void InputFile::refuse(const std::string& why) const {
  throw BadInput(option_ + " '" + path_ + "' is not allowed: " + why + hint_);
}

void InputFile::refuse_line(const std::string& why) const {
  refuse("line " + std::to_string(number_of_line_) + ": " + why);
}

}  // namespace bounce
