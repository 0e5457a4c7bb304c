#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "02_spring_floor/spring_floor.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

BOUNCE_SUBJECT(bounce::check::OneBall<bounce::SpringFloor>)
