#pragma once

namespace ripstop::cli {

/// INT, TERM and HUP end the program after it has removed what it had not finished; one that the caller ignores
/// (nohup) stays
/// ignored. A reader that closes the pipe and a file that grows beyond its limit are errors of writing, not the
/// program's end.
void end_cleanly_on_signals();

}  // namespace ripstop::cli
