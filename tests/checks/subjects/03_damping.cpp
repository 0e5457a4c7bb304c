#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "03_damping/damping.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

BOUNCE_SUBJECT(bounce::check::OneBall<bounce::Damping>)
