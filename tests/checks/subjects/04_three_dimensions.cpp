#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "04_three_dimensions/three_dimensions.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include "adapt.hpp"

BOUNCE_SUBJECT(bounce::check::OneBall<bounce::ThreeDimensions>)
