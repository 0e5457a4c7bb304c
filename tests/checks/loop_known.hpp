#pragma once
#include <functional>
#include <string>
#include <vector>

#include "checks/subject.hpp"

namespace bounce::check {

/// A way to take a step that somebody has taken before: a method that has a name, or a mistake.
struct KnownMethod {
  std::string name;
  std::string says;  // of a mistake: what to do about it
  std::function<Walked(const Walk&)> walk;
};

const std::vector<KnownMethod>& built_in_methods();
const std::vector<KnownMethod>& methods_of_textbooks();
const std::vector<KnownMethod>& usual_mistakes();

/// Whether the subject does the same, to rounding, at every step of some walks: where the force
/// depends on place and time, and `with_damper` on the velocity as well.
bool is_twin(const KnownMethod& known, bool with_damper);
/// The first of them that is a twin without a damper, or nullptr.
const KnownMethod* find_twin(const std::vector<KnownMethod>& all);

}  // namespace bounce::check
