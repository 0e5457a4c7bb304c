#include "physics/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <version>

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
// clang-format off
EM_JS(double, text_as_number, (const char* text), { return Number(UTF8ToString(text)); });
// Of the two ways to write the shortest digits the shorter one, as std::to_chars does.
EM_JS(void, number_as_text, (double value, char* text, int size), {
  const size_of = Math.abs(value), sign = value < 0 || Object.is(value, -0) ? "-" : "", whole = size_of.toExponential().split("e");
  let shorter = isNaN(value) ? "nan" : "inf";
  if (isFinite(value)) {
    const digits = whole[0], power = Number(whole[1]), decimals = Math.max(0, Math.max(0, digits.length - 2) - power);
    const scientific = digits + "e" + (power < 0 ? "-" : "+") + String(Math.abs(power)).padStart(2, "0");
    const fixed = size_of >= 1e21 ? String(BigInt(size_of)) : decimals > 100 ? scientific : size_of.toFixed(decimals);
    shorter = fixed.length <= scientific.length ? fixed : scientific;
  }
  stringToUTF8(sign + shorter, text, size);
});
// clang-format on
#endif

namespace bounce {

#ifdef __cpp_lib_to_chars  // <charconv> has floating point
std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string to_text(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc{} ? std::string(digits.data(), end) : "?";
}
#else  // LLVM's library has it late: Apple's, and the one that makes web pages. The same answers:
std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  // strtod also takes spaces, "nan", "inf", hexadecimal numbers, and 1e-400 for 0.
  if (text.empty() || text.find_first_not_of("+-.0123456789eE") != text.npos) return std::nullopt;
  if (text[0] == '+') return std::nullopt;
  const std::string word(text);
#ifdef __EMSCRIPTEN__
  const double value = text_as_number(word.c_str());
  if (!std::isfinite(value)) return std::nullopt;
#else
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size() || !std::isfinite(value)) return std::nullopt;
#endif
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  if (value == 0 && digits.find_first_of("123456789") != digits.npos) return std::nullopt;
  return value;
}

#ifdef __EMSCRIPTEN__  // JavaScript knows the shortest digits, and a page need not load what finds
                       // them
std::string to_text(double value) {
  std::array<char, 400> text{};
  number_as_text(value, text.data(), static_cast<int>(text.size()));
  return text.data();
}
#else
std::string to_text(double value) {
  std::array<char, 400> shortest{}, fixed{};
  const auto reads_back = [&](int digits) {
    std::snprintf(shortest.data(), shortest.size(), "%.*e", digits, value);
    return std::strtod(shortest.data(), nullptr) == value;
  };
  // Most numbers of a trace need 16 or 17 digits: those are not tried with fewer.
  for (int digits = reads_back(14) ? 0 : 15; digits < 17; ++digits) {
    if (!reads_back(digits)) continue;
    // Of the two ways to write these digits the shorter one; as to_chars does.
    const std::string scientific = shortest.data();
    const std::size_t e = scientific.find('e');
    const int decimals = digits - (e == scientific.npos ? 0 : std::atoi(&scientific[e + 1]));
    std::snprintf(fixed.data(), fixed.size(), "%.*f", std::max(0, decimals), value);
    return std::string(fixed.data()).size() <= scientific.size() ? fixed.data() : scientific;
  }
  return std::isnan(value) ? (std::signbit(value) ? "-nan" : "nan") : shortest.data();
}
#endif
#endif

std::string to_text(std::span<const double> values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(to_text(value));
  return join(words, ",");
}

std::string to_rounded_text(double value, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < name.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const std::size_t replace = diagonal + (name[i] == candidate[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = nearest_name(name, candidates);
  return best.empty() ? "" : " (did you mean " + best + "?)";
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) all += separator;
    all += words[i];
  }
  return all;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> words;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(separator);
    words.push_back(trimmed(text.substr(0, end)));
    text.remove_prefix(end == std::string_view::npos ? 0 : end + 1);
  }
  return words;
}

}  // namespace bounce
