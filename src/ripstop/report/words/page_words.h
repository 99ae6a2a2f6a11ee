#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Figures as report.html writes them (apps/report/src/format.js): a true minus, thousands apart, a dash for what is
/// unknown.
std::string page_figure(double value, int decimals = 2, bool is_signed = false);
/// About three digits, none of them idle: 2 and not 2.000.
std::string short_figure(double value);

/// A part of a sentence: words, or the name of a tile or a seam, which a page makes a link of.
struct PagePart {
    enum class Kind { words, tile, seam };
    std::string text;
    Kind kind = Kind::words;
};
using PageSentence = std::vector<PagePart>;
std::string plain(const PageSentence& sentence);
std::vector<std::string> plain(const std::vector<PageSentence>& sentences);

/// What is said of a plan, once for all: report.html has it from report.json, the PNG pictures from here.
struct PageWords {
    std::string word, headline;     ///< `Not manufacturable as drawn.`, then what is wrong in one sentence
    std::vector<PageSentence> why;  ///< each kind of finding once with the worst of it, then the seams, then the rest
    std::vector<PageSentence> redesign;  ///< the first six kinds of proposals, and how many more
    std::vector<std::string> notes;      ///< seams that are not certain, then the input's remarks
};
PageWords page_words(const CutPlan& plan);

/// What a finding's code means to a maker: `length of an edge`; the code itself where nobody knows it.
std::string finding_words(const std::string& code);

/// `can be made`, `cannot be made as drawn` or `not judged`.
std::string tile_word(const FlatTile& tile);
/// `fits`, `fits, as far as the meshes can tell` or `does not fit`.
std::string seam_word(const SeamWalk& walk);

}  // namespace ripstop
