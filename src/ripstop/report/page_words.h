#pragma once

#include <string>
#include <vector>

#include "ripstop/model/cut_plan.h"

namespace ripstop {

/// Figures as report.html writes them (apps/report/src/format.js): a true minus, thousands apart, a dash for what is
/// unknown.
std::string page_figure(double value, int decimals = 2, bool is_signed = false);
/// About three digits, none of them idle: 2 and not 2.000.
std::string short_figure(double value);

/// What report.html says of a plan (apps/report/src/verdict.js; a test holds both to the same words), for pages that
/// are only looked at.
struct PageWords {
    std::string word, headline;    ///< `Not manufacturable as drawn.`, then what is wrong in one sentence
    std::vector<std::string> why;  ///< each kind of finding once with the worst of it, then the seams, then the rest
    std::vector<std::string> redesign;  ///< the first six proposals, and how many more
};
PageWords page_words(const CutPlan& plan);

/// `can be made`, `cannot be made as drawn` or `not judged`.
std::string tile_word(const FlatTile& tile);
/// `fits`, `fits, as far as the meshes can tell` or `does not fit`.
std::string seam_word(const SeamWalk& walk);

}  // namespace ripstop
