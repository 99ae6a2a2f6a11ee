#include "ripstop/report/words/page_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/words/proposals.h"

namespace ripstop {
namespace {

struct Meaning {
    std::string_view code, words, unit;
};
constexpr std::array meanings{Meaning{"isoperimetric", "no flat piece has this outline and this area", ""},
                              Meaning{"stretch_bound", "more curved than the cloth can stretch", ""},
                              Meaning{"unsolved", "no flattening was found", ""},
                              Meaning{"uncertified", "the flattening is not certain", ""},
                              Meaning{"flipped", "flipped triangles", ""},
                              Meaning{"outline", "the outline meets itself", ""},
                              Meaning{"overlap", "the piece overlaps itself", ""},
                              Meaning{"allowances_meet", "allowances do not fit between their edges", ""},
                              Meaning{"cut_line", "the cut line does not go round the sew line", ""},
                              Meaning{"area", "area", "\u00a0%"},
                              Meaning{"perimeter", "length of the outline", "\u00a0%"},
                              Meaning{"chain", "length of an edge", "\u00a0%"},
                              Meaning{"zigzag", "length of the curve that a zigzag edge represents", "\u00a0%"},
                              Meaning{"warp_strain", "strain along the warp", "\u00a0%"},
                              Meaning{"weft_strain", "strain along the weft", "\u00a0%"},
                              Meaning{"shear", "shear between the threads", "°"}};

Meaning meaning_of(std::string_view code) {
    for (const Meaning& meaning : meanings)
        if (meaning.code == code) return meaning;
    return {code, code, ""};
}

std::string counted(std::size_t number, const std::string& one) {
    return page_figure(static_cast<double>(number), 0) + " " + one + (number == 1 ? "" : "s");
}

std::string headline(const CutPlan& plan, std::size_t tiles, std::size_t seams) {
    const std::size_t all = plan.tiles.size(), sewn = plan.walks.size();
    if (plan.manufacturable())
        return (all == 1 ? "The tile" : "All " + counted(all, "tile")) + " can be made" +
               (sewn == 0   ? ""
                : sewn == 1 ? ", and the seam fits"
                            : ", and all " + counted(sewn, "seam") + " fit") +
               ".";
    std::string text;
    if (tiles > 0) text = std::to_string(tiles) + " of " + counted(all, "tile") + " cannot be made as drawn";
    if (seams > 0)
        text += (tiles > 0 ? ", and " : "") + std::to_string(seams) + " of " + counted(sewn, "seam") +
                (seams == 1 ? " does not fit" : " do not fit");
    return (text.empty() ? "The tiles can be made, but the drawing has faults" : text) + ".";
}

/// A code of findings, the number of tiles that have it, and the worst of them.
struct Kind {
    std::string code;
    std::set<const FlatTile*> tiles;
    const FlatTile* tile = nullptr;
    const Finding* worst = nullptr;
    double excess = 0;
};

std::vector<Kind> kinds_of(const CutPlan& plan) {
    std::vector<Kind> kinds;
    for (const FlatTile& tile : plan.tiles)
        for (const Finding& finding : tile.verdict.findings) {
            if (tile.verdict.manufacturable()) continue;
            auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.code == finding.code; });
            if (kind == kinds.end()) kind = kinds.insert(kinds.end(), Kind{finding.code, {}});
            kind->tiles.insert(&tile);
            const double excess = std::abs(finding.value / (finding.limit != 0 ? finding.limit : 1));
            if (kind->worst && !(excess > kind->excess)) continue;
            kind->tile = &tile;
            kind->worst = &finding;
            kind->excess = excess;
        }
    std::stable_sort(kinds.begin(), kinds.end(),
                     [](const Kind& a, const Kind& b) { return a.tiles.size() > b.tiles.size(); });
    return kinds;
}

PagePart name_of(const FlatTile& tile) {
    return {tile.tile.name, PagePart::Kind::tile};
}

PageSentence reason(const Kind& kind) {
    const Meaning meaning = meaning_of(kind.code);
    const std::string unit(meaning.unit), words(meaning.words);
    const std::string figures = unit.empty() ? ""
                                             : ": " + short_figure(std::abs(kind.worst->value)) + unit + ", allowed " +
                                                   short_figure(kind.worst->limit) + unit;
    if (kind.tiles.size() == 1) return {name_of(*kind.tile), {": " + words + figures + "."}};
    return {{counted(kind.tiles.size(), "tile") + ": " + words + ". Worst "}, name_of(*kind.tile), {figures + "."}};
}

PageSentence seams_reason(const CutPlan& plan, std::size_t failing) {
    std::size_t worst = plan.walks.size();
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        if (!plan.walks[i].ok && (worst == plan.walks.size() || plan.walks[i].drift_max > plan.walks[worst].drift_max))
            worst = i;
    return {{counted(failing, "seam") + ": the two sides differ in length. Worst "},
            {plan.seams[worst].id, PagePart::Kind::seam},
            {": " + short_figure(plan.walks[worst].drift_max / millimetre) + "\u00a0mm apart, allowed " +
             short_figure(plan.walks[worst].limit / millimetre) + "\u00a0mm."}};
}

std::vector<PageSentence> redesign(const CutPlan& plan) {
    constexpr std::size_t shown = 6;
    std::vector<PageSentence> lines;
    const std::vector<ProposedKind> kinds = proposed_kinds(plan);
    for (std::size_t i = 0; i < std::min(shown, kinds.size()); ++i) {
        const FlatTile& tile = plan.tiles[kinds[i].tile];
        const std::string alike = kinds[i].count > 1 ? " and " + std::to_string(kinds[i].count - 1) + " alike" : "";
        lines.push_back(
            {name_of(tile), {alike + ": draw a seam " + tile.proposal->direction + "; " + halves_words(tile) + "."}});
    }
    if (kinds.size() > shown)
        lines.push_back({{"and " + std::to_string(kinds.size() - shown) + " more, each shown with its tile."}});
    if (!plan.merges.empty())
        lines.push_back(
            {{counted(plan.merges.size(), "pair") + " of neighbours could be one tile; report.json names them."}});
    return lines;
}

std::vector<std::string> notes_on(const CutPlan& plan) {
    std::vector<std::string> notes;
    const auto uncertain = static_cast<std::size_t>(
        std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return !walk.is_certain(); }));
    if (uncertain > 0)
        notes.push_back(counted(uncertain, "seam") + (uncertain == 1 ? " is" : " are") +
                        " not certain: the meshes leave their length uncertain by more than the tolerance.");
    notes.insert(notes.end(), plan.remarks.begin(), plan.remarks.end());
    return notes;
}

}  // namespace

std::string page_figure(double value, int decimals, bool is_signed) {
    if (!std::isfinite(value)) return "–";
    const std::string text = format_fixed(std::abs(value), decimals);
    const bool is_zero = text.find_first_of("123456789") == std::string::npos;
    std::string whole = text.substr(0, text.find('.'));
    const std::string fraction = text.substr(whole.size());
    if (whole.size() > 4)
        for (int at = static_cast<int>(whole.size()) - 3; at > 0; at -= 3)
            whole.insert(static_cast<std::size_t>(at), "\u202f");
    const std::string sign = is_zero ? "" : value < 0 ? "−" : is_signed ? "+" : "";
    return sign + whole + fraction;
}

std::string short_figure(double value) {
    const double size = std::abs(value);
    std::string text = page_figure(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string plain(const PageSentence& sentence) {
    std::string text;
    for (const PagePart& part : sentence) text += part.text;
    return text;
}

std::vector<std::string> plain(const std::vector<PageSentence>& sentences) {
    std::vector<std::string> texts;
    for (const PageSentence& sentence : sentences) texts.push_back(plain(sentence));
    return texts;
}

std::string finding_words(const std::string& code) {
    return std::string(meaning_of(code).words);
}

PageWords page_words(const CutPlan& plan) {
    const auto tiles = static_cast<std::size_t>(std::count_if(
        plan.tiles.begin(), plan.tiles.end(), [](const FlatTile& tile) { return !tile.verdict.manufacturable(); }));
    const auto seams = static_cast<std::size_t>(
        std::count_if(plan.walks.begin(), plan.walks.end(), [](const SeamWalk& walk) { return !walk.ok; }));
    PageWords words;
    words.word = plan.manufacturable() ? "Manufacturable." : "Not manufacturable as drawn.";
    words.headline = headline(plan, tiles, seams);
    words.redesign = redesign(plan);
    words.notes = notes_on(plan);
    if (plan.manufacturable()) return words;
    for (const Kind& kind : kinds_of(plan)) words.why.push_back(reason(kind));
    if (seams > 0) words.why.push_back(seams_reason(plan, seams));
    std::map<std::string, std::size_t> more;  // the first of each code speaks for all
    for (const Finding& finding : plan.findings) ++more[finding.code];
    more.erase("seam");
    for (const Finding& finding : plan.findings) {
        const auto count = more.find(finding.code);
        if (count == more.end()) continue;
        words.why.push_back(
            {{finding.message +
              (count->second > 1 ? "; and " + std::to_string(count->second - 1) + " more like this" : std::string())}});
        more.erase(count);
    }
    return words;
}

std::string tile_word(const FlatTile& tile) {
    if (tile.verdict.manufacturable()) return "can be made";
    return tile.verdict.findings.empty() ? "not judged" : "cannot be made as drawn";
}

std::string seam_word(const SeamWalk& walk) {
    if (!walk.ok) return "does not fit";
    return walk.is_certain() ? "fits" : "fits, as far as the meshes can tell";
}

}  // namespace ripstop
