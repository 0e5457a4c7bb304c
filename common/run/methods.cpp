#include "run/methods.hpp"

#include "physics/text.hpp"

namespace bounce {

std::vector<std::string> names_of(const std::vector<Method>& methods) {
  std::vector<std::string> names;
  for (const Method& method : methods) names.push_back(name_of(method));
  return names;
}

Method find_method(const std::string& name, const std::vector<Method>& offered) {
  for (const Method& method : offered) {
    if (method.name == name) return method;
  }
  const std::vector<std::string> names = names_of(offered);
  throw BadInput("--method '" + name + "' is not known here" + did_you_mean(name, names) +
                 ": it must be one of " + join(names));
}

}  // namespace bounce
