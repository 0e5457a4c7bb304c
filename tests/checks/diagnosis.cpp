#include "checks/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "checks/composition.hpp"

namespace bounce::check {

namespace {

bool right(const Evidence& e, std::size_t i) {
  return near(e.got[i], e.expected[i], e.rounding[i]);
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
    std::vector<std::string> all;  // in the order in which they are said, and the longest list last
    const bool many_right = right.size() > 3;
    if (!right.empty() && !many_right) all.push_back("right " + listed(right));
    if (!mixed.empty()) all.push_back("right " + listed(mixed));
    const bool rest_is_wrong = wrong.size() > 2 && !many_right && !all.empty();
    if (rest_is_wrong) all.push_back("wrong elsewhere");
    if (!rest_is_wrong && !wrong.empty()) all.push_back("wrong " + listed(wrong));
    if (many_right) all.push_back("right elsewhere");
    std::string text;
    for (const std::string& words : all) text += (text.empty() ? "" : "; ") + words;
    return text;
  }
};

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
    no_number += !is_number(e.got[i]);
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
    return "not a number (no value given, 0 / 0, or the root of a negative number?) in " +
           std::to_string(no_number) + " of " + std::to_string(n) + " cases";
  }
  const char* memory = "your code remembers something from one call to the next (`static`?)";
  if (changed > 0) {
    return std::string("the same question, asked twice, got two answers: a variable was never ") +
           "given a value, or " + memory;
  }
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
