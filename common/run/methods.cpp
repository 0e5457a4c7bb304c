#include "run/methods.hpp"

#include "physics/text.hpp"

namespace bounce {
namespace {

std::vector<std::string> words(const std::vector<Method>& methods) {
  std::vector<std::string> names;
  for (const Method& method : methods) names.push_back(name_of(method));
  return names;
}

}  // namespace

Method find_method(const std::string& name, const std::vector<Method>& offered) {
  for (const Method& method : offered) {
    if (method.name == name) return method;
  }
  throw BadInput("--method '" + name + "' is not known here" + did_you_mean(name, words(offered)) +
                 ": it must be one of " + names_of(offered));
}

std::string names_of(const std::vector<Method>& methods) { return join(words(methods)); }

}  // namespace bounce
