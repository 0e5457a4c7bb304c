#pragma once

namespace bounce {

/// From here on Ctrl-C (and a request to terminate) no longer ends the program at once: whoever
/// works in a loop asks `interrupted()`, keeps what was computed, and ends with exit code 130.
void catch_interrupts();

bool interrupted();

}  // namespace bounce
