#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "physics/parameters.hpp"

namespace bounce::json {

// What a page is told, as text that it reads with JSON.parse.

inline std::string of(const std::string& text) {
  std::string all = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') all += '\\';
    all += letter;
  }
  return all + "\"";
}
inline std::string of(double number) { return std::isfinite(number) ? to_text(number) : "null"; }
inline std::string of(bool yes) { return yes ? "true" : "false"; }

class Object;
std::string of(const Object& object);
std::string of(const Parameter& parameter);

template <class Value>
std::string list(const std::vector<Value>& values) {
  std::vector<std::string> words;
  for (const Value& value : values) words.push_back(of(value));
  return "[" + join(words, ",") + "]";
}

/// {"name":value,...}
class Object {
 public:
  template <class Value>
  Object& add(const std::string& name, const Value& value) {
    return add_text(name, of(value));
  }
  Object& add_text(const std::string& name, const std::string& json) {
    members_.push_back(of(name) + ":" + json);
    return *this;
  }
  std::string text() const { return "{" + join(members_, ",") + "}"; }

 private:
  std::vector<std::string> members_;
};
inline std::string of(const Object& object) { return object.text(); }

inline std::string of(const Parameter& parameter) {
  Object all;
  all.add("name", parameter.name).add("unit", parameter.unit).add("meaning", parameter.meaning);
  all.add("text", parameter.text()).add("whole", parameter.is_whole);
  all.add("lowest", parameter.slider.lowest).add("highest", parameter.slider.highest);
  if (const auto* choice = std::get_if<Choice>(&parameter.value)) {
    all.add_text("choices", list(choice->names));
  }
  return all.text();
}

}  // namespace bounce::json
