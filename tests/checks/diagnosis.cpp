#include "checks/diagnosis.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/text.hpp"

namespace bounce::check {

namespace {

using Indices = std::vector<std::size_t>;

double size_of(const Triple& t) {
  return std::max({std::abs(t[0]), std::abs(t[1]), std::abs(t[2])});
}
bool finite(const Triple& t) { return std::isfinite(t[0] + t[1] + t[2]); }
bool right(const Evidence& e, std::size_t i) {
  return near(e.got[i], e.expected[i], e.rounding[i]);
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

/// Where answers are right, wrong, or either.
struct Places {
  std::vector<std::string> right, wrong, mixed;
  std::string worst;  // where most are wrong
  explicit Places(const Evidence& e) {
    std::vector<std::string> names = e.place;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    long most = 0;
    for (const std::string& name : names) {
      long all = 0, bad = 0;
      for (std::size_t i = 0; i < e.got.size(); ++i) {
        all += e.place[i] == name;
        bad += e.place[i] == name && !check::right(e, i);
      }
      if (bad > most) most = bad, worst = name;
      if (bad == 0) right.push_back(name);
      if (bad == all) wrong.push_back(name);
      if (bad == 0 || bad == all) continue;
      mixed.push_back("in " + std::to_string(all - bad) + " of " + std::to_string(all) + " cases" +
                      (name.empty() ? "" : " " + name));
    }
  }
  std::string text() const {
    if (right.empty() && mixed.empty() && wrong.size() > 1) return "wrong in every case";
    std::string all = right.empty() ? "" : "right " + listed(right);
    if (!mixed.empty()) all += (all.empty() ? "right " : "; right ") + listed(mixed);
    if (!wrong.empty()) all += (all.empty() ? "wrong " : "; wrong ") + listed(wrong);
    return all;
  }
};

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
    if (is(found, 0)) missing.push_back(name);
    if (wanted == 0 && is(found, 1)) instead.push_back(name);
    if (wanted == 0 && !is(found, 1)) instead.push_back(so_often + " " + name);
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
  return listed(words);
}

/// Tries the parts of the right answer, then one or two more.
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
  if (e.parts.empty()) return "";
  for (const Part* first : extra) {
    for (const Part* second : extra) {
      if (first && (!second || second <= first)) continue;
      std::vector<const Part*> tried = wanted;
      if (first) tried.push_back(first);
      if (second) tried.push_back(second);
      if (tried.empty()) continue;
      if (const auto times = made_of(e, tried, where)) return spelled(tried, *times);
    }
  }
  return "";
}

std::string sizes(const Evidence& e, const Indices& wrong) {
  const auto all = [&](auto holds) { return std::all_of(wrong.begin(), wrong.end(), holds); };
  if (all([&](std::size_t i) { return size_of(e.got[i]) == 0; })) return "your answer is 0";
  if (all([&](std::size_t i) { return size_of(e.got[i]) < size_of(e.expected[i]); })) {
    return "your answer is too small in size";
  }
  if (all([&](std::size_t i) { return size_of(e.got[i]) > size_of(e.expected[i]); })) {
    return "your answer is too large in size";
  }
  return "";
}

/// "right in x, wrong in y", when some components are right in all cases.
std::string by_component(const Evidence& e) {
  std::vector<std::string> good, bad;
  for (std::size_t c = 0; c < 3; ++c) {
    if (e.components.at(c).empty()) continue;
    bool all = true;
    for (std::size_t i = 0; i < e.got.size(); ++i) {
      all = all && std::abs(e.got[i][c] - e.expected[i][c]) <= e.rounding[i];
    }
    (all ? good : bad).push_back(e.components[c]);
  }
  return good.empty() ? "" : listed(good) + " right, " + listed(bad) + " wrong";
}

/// What is so, whatever was asked: no number, no memory, too few digits; or nothing.
std::string in_general(const Evidence& e) {
  const std::size_t n = e.got.size();
  std::size_t no_number = 0, changed = 0, same = 0, wrong = 0, moved = 0;
  double error = 0;
  for (std::size_t i = 0; i < n; ++i) {
    no_number += !finite(e.got[i]);
    changed += !near(e.got[i], e.again[i], 0);
    same += near(e.got[i], e.got[0], 0);
    moved += !near(e.expected[i], e.expected[0], 0);
    wrong += !right(e, i);
    double size = size_of(e.expected[i]);
    for (const Part& part : e.parts) size = std::max(size, size_of(part.value[i]));
    const Triple& x = e.got[i];
    const Triple off{x[0] - e.expected[i][0], x[1] - e.expected[i][1], x[2] - e.expected[i][2]};
    if (!right(e, i)) error = std::max(error, size_of(off) / size);
  }
  if (no_number > 0) {
    return "not a number (0 / 0, or the root of a negative number?) in " +
           std::to_string(no_number) + " of " + std::to_string(n) + " cases";
  }
  const char* memory = "your code remembers something from one call to the next (`static`?)";
  if (changed > 0) return std::string("the same question, asked twice, got two answers: ") + memory;
  if (n > 1 && same == n && moved > 0 && size_of(e.got[0]) > 0) {
    return right(e, 0)
               ? std::string("right for the first case, and the same for all others: ") + memory
               : "your answer is the same in every case, whatever is asked";
  }
  if (2 * wrong > n && error < 1e-4) {
    const int digits = static_cast<int>(-std::log10(error));
    return "right to " + std::to_string(digits) + " digits and no further: is there a " +
           (digits < 6 ? "rounded number" : "`float` in place of a `double`") + "?";
  }
  return "";
}

}  // namespace

bool near(const Triple& a, const Triple& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;  // "not a number" is near nothing
  }
  return true;
}

std::string diagnose(const Evidence& e) {
  const Places places(e);
  const std::string in_places = places.text(), general = in_general(e);
  const bool one_place = places.right.empty() && places.mixed.empty() && places.wrong.size() == 1;
  std::vector<std::string> said;
  if (!one_place || !e.place[0].empty()) said.push_back(in_places);
  if (!general.empty()) {
    said.push_back(general);
  } else {
    Indices all_wrong_places, worst, wrong;
    for (std::size_t i = 0; i < e.got.size(); ++i) {
      const auto& good = places.right;
      if (!right(e, i)) wrong.push_back(i);
      if (e.place[i] == places.worst) worst.push_back(i);
      if (std::find(good.begin(), good.end(), e.place[i]) == good.end())
        all_wrong_places.push_back(i);
    }
    if (const std::string parts = by_component(e); !parts.empty()) said.push_back(parts);
    std::string made = composition(e, all_wrong_places);
    const bool some_right = !places.right.empty() || !places.mixed.empty();
    if (!made.empty() && some_right) made = "where it is wrong: " + made;
    if (made.empty() && places.wrong.size() + places.mixed.size() > 1) {
      made = composition(e, worst);
      if (!made.empty()) made = places.worst + ": " + made;
    }
    if (made.empty()) made = sizes(e, wrong);
    if (!made.empty()) said.push_back(made);
  }
  std::string text;
  for (const std::string& words : said) text += (text.empty() ? "" : "; ") + words;
  return text;
}

}  // namespace bounce::check
