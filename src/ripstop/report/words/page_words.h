#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// Formats figures as report.html does (apps/report/src/format.js): a true minus sign, separated thousands, a dash
/// for unknown.
std::string page_figure(double value, int decimals = 2, bool is_signed = false);
/// About three digits without trailing zeros: 2 and not 2.000.
std::string short_figure(double value);

/// A part of a sentence: text, or the name of a tile or a seam, which a page turns into a link.
struct PagePart {
    enum class Kind { words, tile, seam };
    std::string text;
    Kind kind = Kind::words;
};
using PageSentence = std::vector<PagePart>;
std::string plain(const PageSentence& sentence);
std::vector<std::string> plain(const std::vector<PageSentence>& sentences);

/// The texts about a plan. report.html takes them from report.json, the PNG pictures from here.
struct PageWords {
    std::string word, headline;          ///< `Not manufacturable as drawn.`, then the reason in one sentence
    std::vector<PageSentence> why;       ///< each kind of finding once, with its worst; then the seams, then the rest
    std::vector<PageSentence> redesign;  ///< the first six kinds of proposals, and the number of others
    std::vector<std::string> notes;      ///< uncertain seams, then the input's remarks
};
PageWords page_words(const CutPlan& plan);

/// The meaning of a finding's code in plain words: `length of an edge`; the code itself if it is unknown.
std::string finding_words(const std::string& code);

/// `can be made`, `cannot be made as drawn` or `not judged`.
std::string tile_word(const FlatTile& tile);
/// `fits`, `fits, as far as the meshes can tell` or `does not fit`.
std::string seam_word(const SeamWalk& walk);

}  // namespace ripstop
