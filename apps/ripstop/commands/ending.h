#pragma once

namespace ripstop::cli {

/// INT, TERM and HUP end the program after it has removed unfinished files. A signal that the caller ignores (nohup)
/// stays ignored. A closed pipe and an exceeded file size limit become write errors instead of ending the program.
void end_cleanly_on_signals();

}  // namespace ripstop::cli
