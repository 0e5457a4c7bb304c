#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "physics/text.hpp"

namespace bounce {

/// `--sweep amplitude=FROM,TO,N`: a parameter that takes N values from FROM to TO.
struct Sweep {
  std::string name;
  std::vector<double> values;
};

/// Reads and checks it, against what `scene` allows. Throws BadInput.
inline Sweep read_sweep(const std::string& text, OscillatingFloor scene) {
  const auto refuse = [&text](const std::string& why) {
    throw BadInput("--sweep '" + text + "' is not allowed: " + why +
                   "; it must be NAME=FROM,TO,N, such as amplitude=0.05,0.1,400");
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse("it names no parameter");
  const std::vector<Parameter> parameters = scene.parameters();
  const Parameter& parameter = find_parameter(parameters, text.substr(0, equals));
  if (!std::holds_alternative<double*>(parameter.value)) {
    refuse("'" + parameter.name + "' is no number");
  }
  const std::vector<std::string> words = split(text.substr(equals + 1));
  if (words.size() != 3) refuse("it needs three numbers");
  parameter.set(words[0]);  // these throw for what the parameter does not allow
  parameter.set(words[1]);
  const double from = parse_number(words[0]).value(), to = parse_number(words[1]).value();
  const double count = parse_number(words[2]).value_or(0);
  if (!(count >= 2 && count <= 1e6) || count != std::floor(count)) {
    refuse("N must be a whole number from 2 to 1e6");
  }
  if (!(from < to)) refuse("FROM must be smaller than TO");
  Sweep sweep{parameter.name, {}};
  for (double i = 0; i < count; ++i) {
    sweep.values.push_back(from + (to - from) * i / (count - 1));
  }
  return sweep;
}

}  // namespace bounce
