#pragma once

namespace wirepack {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGXCPU (the limit on processor time) are only noted, as
/// is SIGUSR1. A SIGINT after one of the first ends the program at once. What was ignored before,
/// by nohup or a shell's background job, stays ignored; what has been held back comes now.
void catch_stop_signals();
bool stop_was_requested();
/// A SIGUSR1 has come since the last call: everything is to be saved, and the run goes on.
bool save_was_requested();

}  // namespace wirepack
