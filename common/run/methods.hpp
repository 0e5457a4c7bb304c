#pragma once
#include <string>
#include <vector>

#include "physics/methods/all_methods.hpp"

namespace bounce {

/// For messages.
inline std::string name_of(const Method& method) { return std::string(method.name); }

std::vector<std::string> names_of(const std::vector<Method>& methods);

/// The method of that name among those that the stage offers. Throws BadInput.
Method find_method(const std::string& name, const std::vector<Method>& offered);

}  // namespace bounce
