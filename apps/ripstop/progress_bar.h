#pragma once

#include "ripstop/base/progress.h"

namespace ripstop::cli {

/// A bar on stderr where that is a terminal, a plain line every tenth of the work elsewhere, nothing when `quiet`. The
/// bar is wiped when the work is done.
Progress progress_bar(bool quiet);

}  // namespace ripstop::cli
