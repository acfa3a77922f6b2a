#pragma once

namespace wirepack {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the program.
void catch_stop_signals();
bool stop_was_requested();

}  // namespace wirepack
