#include "checks/composition.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/text.hpp"

namespace bounce::check {

namespace {

/// How many times each part is in the answers, by least squares; nothing unless *all* of the
/// answers are made of these parts.
std::optional<std::vector<double>> made_of(const Evidence& e, const std::vector<const Part*>& parts,
                                           const Indices& where) {
  const auto rows = static_cast<Eigen::Index>(3 * where.size());
  const auto n = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd a(rows, n);
  Eigen::VectorXd b(rows), fuzz(rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t q = where[static_cast<std::size_t>(r / 3)],
                      c = static_cast<std::size_t>(r % 3);
    double size = size_of(e.got[q]);
    for (const Part* part : parts) size = std::max(size, size_of(part->value[q]));
    const double weight = size > 0 ? 1 / size : 0;  // each question counts the same
    for (Eigen::Index k = 0; k < n; ++k) {
      a(r, k) = weight * parts[static_cast<std::size_t>(k)]->value[q][c];
    }
    b[r] = weight * e.got[q][c];
    fuzz[r] = 1e-9 + weight * e.rounding[q];
  }
  if ((b.array() != 0).count() < n + 3) return {};  // too few answers to tell
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  if (qr.rank() < n) return {};
  const Eigen::VectorXd times = qr.solve(b);
  if (!((a * times - b).array().abs() <= fuzz.array()).all()) return {};
  return std::vector<double>(times.begin(), times.end());
}

std::string spelled(const std::vector<const Part*>& parts, const std::vector<double>& times) {
  const auto is = [](double value, double other) { return std::abs(value - other) < 1e-5; };
  std::vector<std::string> missing, instead, words;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& name = parts[i]->name;
    const double wanted = parts[i]->wanted, found = times[i];
    const std::string so_often = to_rounded_text(found, 4) + " times";
    if (is(found, wanted)) continue;
    if (is(found, 0) || (parts[i]->inside && is(found, -1))) {
      missing.push_back(name);
    } else if (wanted == 0) {
      instead.push_back(is(found, 1)    ? name
                        : is(found, -1) ? "minus " + name
                                        : so_often + " " + name);
    }
    if (wanted == 1 && is(found, -1)) words.push_back(name + " has the wrong sign");
    if (wanted == 1 && !is(found, 0) && !is(found, -1))
      words.push_back(name + " is taken " + so_often);
  }
  const std::string lost = listed(missing), found = listed(instead);
  if (!lost.empty() && !found.empty()) {
    words.push_back(found + " in place of " + lost);
  } else if (!lost.empty()) {
    words.push_back(lost + (missing.size() > 1 ? " are missing" : " is missing"));
  } else if (!found.empty()) {
    words.push_back("too much: " + found);
  }
  std::string text = listed(words);
  if (text.ends_with(',')) text.pop_back();  // of a name that is set off by commas
  return text;
}

}  // namespace

double size_of(const Triple& t) {
  return std::max({std::abs(t[0]), std::abs(t[1]), std::abs(t[2])});
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

bool near(const Triple& a, const Triple& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;  // "not a number" is near nothing
  }
  return true;
}

bool is_number(const Triple& answer) {
  return std::all_of(answer.begin(), answer.end(), [](double x) { return std::abs(x) < 1e200; });
}

std::string composition(const Evidence& e, const Indices& where) {
  const Part whole{"the right answer", 1, e.expected};
  if (const auto times = made_of(e, {&whole}, where)) {
    return "your answer is " + to_rounded_text((*times)[0], 4) + " times the right one";
  }
  std::vector<const Part*> wanted, extra{nullptr};
  for (const Part& part : e.parts) {
    const bool there = std::any_of(where.begin(), where.end(),
                                   [&](std::size_t q) { return size_of(part.value[q]) != 0; });
    if (there) (part.wanted != 0 ? wanted : extra).push_back(&part);
  }
  const auto with = [&](const Part* first, const Part* second) -> std::string {
    std::vector<const Part*> tried = wanted;
    if (first) tried.push_back(first);
    if (second) tried.push_back(second);
    if (tried.empty()) return "";
    const auto times = made_of(e, tried, where);
    return times ? spelled(tried, *times) : "";
  };
  for (const Part* one : extra) {
    if (const std::string words = with(one, nullptr); !words.empty()) return words;
  }
  for (const Part& one : e.products) {
    if (const std::string words = with(&one, nullptr); !words.empty()) return words;
  }
  for (std::size_t i = 1; i < extra.size(); ++i) {
    for (std::size_t j = i + 1; j < extra.size(); ++j) {
      if (const std::string words = with(extra[i], extra[j]); !words.empty()) return words;
    }
  }
  return "";
}

}  // namespace bounce::check
