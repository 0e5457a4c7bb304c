// Stage 3 as the checks see it (tests/checks/subject.hpp).
#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "03_damping/damping.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "checks/subjects/adapt.hpp"

// Mass, gravity, radius, stiffness, damping and contact are handed over by adapt.hpp. What only
// this stage has is handed over here: the check writes it into setting.own[0], [1], ...
static void take_own(bounce::Damping& /*scene*/, const bounce::check::Setting& /*setting*/) {}

using SubjectDamping = bounce::check::OneBall<bounce::Damping, take_own>;
BOUNCE_SUBJECT(SubjectDamping)
