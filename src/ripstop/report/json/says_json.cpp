#include "ripstop/report/json/says_json.h"

#include <nlohmann/json.hpp>

#include "ripstop/report/words/page_words.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

/// Sentences as parts: texts, and names of tiles and seams.
Json sentences_json(const std::vector<PageSentence>& sentences) {
    Json list = Json::array();
    for (const PageSentence& sentence : sentences) {
        Json parts = Json::array();
        for (const PagePart& part : sentence) {
            if (part.kind == PagePart::Kind::words)
                parts.push_back(part.text);
            else
                parts.push_back({{part.kind == PagePart::Kind::tile ? "tile" : "seam", part.text}});
        }
        list.push_back(parts);
    }
    return list;
}

}  // namespace

Json says_json(const CutPlan& plan) {
    const PageWords words = page_words(plan);
    Json codes = Json::object();
    for (const FlatTile& tile : plan.tiles)
        for (const Finding& finding : tile.verdict.findings) codes[finding.code] = finding_words(finding.code);
    return {{"word", words.word},
            {"headline", words.headline},
            {"why", sentences_json(words.why)},
            {"redesign", sentences_json(words.redesign)},
            {"notes", words.notes},
            {"codes", codes}};
}

}  // namespace ripstop
