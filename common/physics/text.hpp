#pragma once
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bounce {

/// What the user gave is not allowed. The message is one sentence that names the parameter, the
/// value and what is allowed; programs print it and end with exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole text as a finite number; nothing for text, an empty string, nan or infinity.
std::optional<double> parse_number(std::string_view text);

/// The shortest decimal that reads back as the same double: 0.1 stays "0.1".
std::string to_text(double value);

/// The same for several numbers, with commas: "0,1,0".
std::string to_text(std::span<const double> values);

/// For messages to people: `digits` significant digits, "1.23e-05" where that is shorter.
std::string to_rounded_text(double value, int digits = 3);

/// The candidate most like `name`, for "did you mean ...?"; empty when nothing is near
/// (more than a third of the letters would have to change; Levenshtein distance).
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// ", did you mean X?" or nothing.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

/// Without the blanks before and after it.
std::string trimmed(std::string_view text);

/// "a, b,c" cut at the commas, without the blanks around them; an empty text gives one empty word.
std::vector<std::string> split(std::string_view text, char separator = ',');

}  // namespace bounce
