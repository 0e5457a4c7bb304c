#pragma once
#include <fstream>
#include <string>
#include <string_view>

#include "physics/parameters.hpp"

namespace bounce {

/// A text file that the user names after an option. It is read line by line, whatever system wrote
/// it, and it says in one sentence what is wrong with it, and where. Throws BadInput.
class InputFile {
 public:
  /// `hint` ends each sentence, for files of which there is one way to get them: "it must be a file
  /// that --save wrote".
  InputFile(std::string option, std::string path, const std::string& hint = "");

  /// Takes the next line, without its end (a Windows file has two letters there) and without the
  /// mark that some editors put before the first one. False at the end of the file.
  bool next_line();
  const std::string& line() const { return line_; }
  /// The whole of a file on a disk, as it stands there.
  std::string whole();

  /// A word as a number. What is none, or is not in the range, is refused: "column mass: '-1' must
  /// be a number from 1e-30 to 1e+30 (kg)".
  double number(const std::string& name, std::string_view word, Range valid,
                const std::string& unit = "", bool is_whole = false) const;
  long long whole_number(const std::string& name, std::string_view word, Range valid) const {
    return static_cast<long long>(number(name, word, valid, "", true));
  }

  [[noreturn]] void refuse(const std::string& why) const;       // the file
  [[noreturn]] void refuse_line(const std::string& why) const;  // "line 3: ..."

 private:
  std::string option_, path_, hint_;
  std::ifstream file_;
  std::string line_;
  long long number_of_line_ = 0;
};

}  // namespace bounce
