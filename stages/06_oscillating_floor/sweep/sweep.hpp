#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/text.hpp"

namespace bounce {

/// One bounce: where in its swing the floor was hit, and how high the ball rose after it.
struct Bounce {
  double phase;   // rad, 0 to 2 pi
  double height;  // m
};

/// The bounces of a ball after it has had time to settle: `discarded` go unseen, then `kept` are
/// written down. Fewer when the ball comes to stay on the floor, or flies away without gravity.
inline std::vector<Bounce> settled_bounces(const OscillatingFloor& scene, int discarded, int kept) {
  EventDriven<OscillatingFloorExact> walker(OscillatingFloorExact(scene), 0, scene.start);
  std::vector<Bounce> bounces;
  double impact = 0;  // the floor's angle
  bool hit = false;
  for (int n = 0; n < discarded + kept && walker.next_event() != never;) {
    const Phase before = walker.phase();
    walker.pass_event();
    const Phase now = walker.phase();
    if (before == Phase::flight && now != Phase::flight) {
      impact = scene.angular_frequency * walker.last_event() + scene.phase;
      hit = true;
    }
    if (before == Phase::flight || now != Phase::flight || !hit) continue;
    if (walker.next_event() == never) break;
    // The flight's highest point: its top, unless the floor comes before it.
    const State<double>& start = walker.state_at_last_event();
    const double length = walker.next_event() - walker.last_event();
    const double to_top = std::clamp(start.velocity / scene.gravity, 0.0, length);
    if (n++ < discarded) continue;
    bounces.push_back({within_one_turn(impact), fly(start, scene.gravity, to_top).position});
  }
  return bounces;
}

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
