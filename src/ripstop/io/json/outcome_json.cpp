#include "ripstop/io/json/outcome_json.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/json_text.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;
using nlohmann::json;

template <class Owner, class Value>
struct Field {
    const char* key;
    Value Owner::*member;
};

constexpr std::array<Field<Accuracy, double>, 16> accuracy_numbers{
    {{"area", &Accuracy::area},
     {"flat_area", &Accuracy::flat_area},
     {"area_error", &Accuracy::area_error},
     {"area_error_abs", &Accuracy::area_error_abs},
     {"perimeter", &Accuracy::perimeter},
     {"flat_perimeter", &Accuracy::flat_perimeter},
     {"perimeter_error", &Accuracy::perimeter_error},
     {"edge_error_abs", &Accuracy::edge_error_abs},
     {"boundary_error_abs", &Accuracy::boundary_error_abs},
     {"boundary_error_max", &Accuracy::boundary_error_max},
     {"warp_strain_min", &Accuracy::warp_strain_min},
     {"warp_strain_max", &Accuracy::warp_strain_max},
     {"weft_strain_min", &Accuracy::weft_strain_min},
     {"weft_strain_max", &Accuracy::weft_strain_max},
     {"shear_max", &Accuracy::shear_max},
     {"energy", &Accuracy::energy}}};
constexpr std::array<Field<Accuracy, int>, 3> accuracy_counts{{{"flipped", &Accuracy::flipped},
                                                               {"overlaps", &Accuracy::overlaps},
                                                               {"outline_crossings", &Accuracy::outline_crossings}}};
constexpr std::array<Field<Accuracy, Vec3>, 6> accuracy_places{{{"worst_edge", &Accuracy::worst_edge},
                                                                {"worst_warp", &Accuracy::worst_warp},
                                                                {"worst_weft", &Accuracy::worst_weft},
                                                                {"worst_shear", &Accuracy::worst_shear},
                                                                {"worst_flip", &Accuracy::worst_flip},
                                                                {"worst_overlap", &Accuracy::worst_overlap}}};
constexpr std::array<Field<Remeshed, double>, 5> remeshed_numbers{{{"edge_length", &Remeshed::edge_length},
                                                                   {"turn_max", &Remeshed::turn_max},
                                                                   {"area_before", &Remeshed::area_before},
                                                                   {"perimeter_before", &Remeshed::perimeter_before},
                                                                   {"distance_max", &Remeshed::distance_max}}};
constexpr std::array terminations{Termination::failed, Termination::converged, Termination::stagnated,
                                  Termination::iteration_limit};
constexpr double most_counted = 2e9;

/// JSON has no infinity.
Json number_json(double value) {
    if (std::isnan(value)) return nullptr;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;
}

double number_from(const PlanReader& from, const json& value, const char* key) {
    if (value.is_number()) return value.get<double>();
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (value == "inf") return std::numeric_limits<double>::infinity();
    if (value == "-inf") return -std::numeric_limits<double>::infinity();
    from.refuse(std::string(key) + " is not a number");
}

double number_of(const PlanReader& from, const char* key) {
    if (!from.has(key)) from.refuse(std::string(key) + " is missing, expected a number");
    return number_from(from, from.value().at(key), key);
}

Json place_json(const Vec3& at) {
    return {number_json(at.x()), number_json(at.y()), number_json(at.z())};
}

Vec3 place_from(const PlanReader& from, const json& value, const char* key) {
    if (!value.is_array() || value.size() != 3)
        from.refuse(std::string(key) + " is not a point, expected three numbers");
    return {number_from(from, value[0], key), number_from(from, value[1], key), number_from(from, value[2], key)};
}

Vec3 place_of(const PlanReader& from, const char* key) {
    if (!from.has(key)) from.refuse(std::string(key) + " is missing, expected three numbers");
    return place_from(from, from.value().at(key), key);
}

std::vector<std::string> texts_of(const PlanReader& from, const char* key) {
    return texts_at(from.value(), key, from.place());
}

Json accuracy_json(const Accuracy& accuracy) {
    Json object = Json::object(), chains = Json::array();
    for (const auto& [key, member] : accuracy_numbers) object[key] = number_json(accuracy.*member);
    for (const auto& [key, member] : accuracy_counts) object[key] = accuracy.*member;
    for (const auto& [key, member] : accuracy_places) object[key] = place_json(accuracy.*member);
    for (const ChainAccuracy& chain : accuracy.chains)
        chains.push_back({{"length", number_json(chain.length)}, {"flat_length", number_json(chain.flat_length)}});
    object["chains"] = chains;
    return object;
}

Accuracy accuracy_of(const PlanReader& from) {
    Accuracy accuracy;
    for (const auto& [key, member] : accuracy_numbers) accuracy.*member = number_of(from, key);
    for (const auto& [key, member] : accuracy_counts) accuracy.*member = from.whole(key, 0, most_counted);
    for (const auto& [key, member] : accuracy_places) accuracy.*member = place_of(from, key);
    accuracy.chains = from.each<ChainAccuracy>("chains", [](const PlanReader& chain) {
        return ChainAccuracy{number_of(chain, "length"), number_of(chain, "flat_length")};
    });
    return accuracy;
}

Json findings_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& finding : findings)
        list.push_back({{"code", finding.code},
                        {"message", finding.message},
                        {"at", place_json(finding.at)},
                        {"value", number_json(finding.value)},
                        {"limit", number_json(finding.limit)},
                        {"chain", finding.chain},
                        {"tiles", finding.tiles}});
    return list;
}

std::vector<Finding> findings_of(const PlanReader& from, const char* key) {
    return from.each<Finding>(key, [](const PlanReader& finding) {
        return Finding{finding.text("code"),        finding.text("message"),
                       place_of(finding, "at"),     number_of(finding, "value"),
                       number_of(finding, "limit"), finding.whole("chain", -1, most_counted),
                       texts_of(finding, "tiles")};
    });
}

Json verdict_json(const Verdict& verdict) {
    return {{"judged", verdict.judged},
            {"findings", findings_json(verdict.findings)},
            {"waived", findings_json(verdict.waived)}};
}

Verdict verdict_of(const PlanReader& from) {
    return {from.flag("judged"), findings_of(from, "findings"), findings_of(from, "waived")};
}

Json trial_json(const Trial& trial) {
    return {{"triangles", trial.triangles},
            {"accuracy", accuracy_json(trial.accuracy)},
            {"verdict", verdict_json(trial.verdict)}};
}

Trial trial_of(const PlanReader& from) {
    return {from.whole("triangles", 0, most_counted), accuracy_of(from.at("accuracy")), verdict_of(from.at("verdict"))};
}

Json proposal_json(const SplitProposal& proposal) {
    Json line = Json::array();
    for (const Vec3& point : proposal.line) line.push_back(place_json(point));
    return {{"direction", proposal.direction},
            {"line", line},
            {"halves", {trial_json(proposal.halves[0]), trial_json(proposal.halves[1])}},
            {"tried", proposal.tried},
            {"findings_before", proposal.findings_before}};
}

SplitProposal proposal_of(const PlanReader& from) {
    SplitProposal proposal;
    proposal.direction = from.text("direction");
    for (const json& point : from.list("line")) proposal.line.push_back(place_from(from, point, "line"));
    if (from.list("halves").size() != 2) from.refuse("halves has not two entries");
    for (std::size_t i = 0; i < 2; ++i) proposal.halves[i] = trial_of(from.in("halves", i));
    proposal.tried = from.whole("tried", 0, most_counted);
    proposal.findings_before = from.whole("findings_before", 0, most_counted);
    return proposal;
}

Json summary_json(const SolveSummary& summary) {
    return {{"termination", name(summary.termination)},
            {"iterations", summary.iterations},
            {"factorizations", summary.factorizations},
            {"reason", summary.reason}};
}

SolveSummary summary_of(const PlanReader& from) {
    const std::string word = from.text("termination");
    for (const Termination each : terminations)
        if (word == name(each))
            return {each, from.whole("iterations", 0, most_counted), from.whole("factorizations", 0, most_counted),
                    from.text("reason")};
    from.refuse("termination is \"" + word + "\"");
}

Json flattening_json(const Flattening& flattening) {
    Json object = {{"summary", summary_json(flattening.summary)}, {"note", flattening.note}};
    if (const auto& certificate = flattening.certificate)
        object["certificate"] = {{"force_residual", number_json(certificate->force_residual)},
                                 {"length_residual", number_json(certificate->length_residual)},
                                 {"strict_minimum", certificate->strict_minimum}};
    Json tension = Json::array();
    for (const double each : flattening.seam_tension) tension.push_back(number_json(each));
    object["seam_tension"] = tension;
    return object;
}

/// `into` must have its positions.
void read_flattening(const PlanReader& from, Flattening& into) {
    into.summary = summary_of(from.at("summary"));
    into.note = from.text("note");
    if (from.has("certificate")) {
        const PlanReader certificate = from.at("certificate");
        into.certificate = Certificate{number_of(certificate, "force_residual"),
                                       number_of(certificate, "length_residual"), certificate.flag("strict_minimum")};
    }
    const json& tension = from.list("seam_tension");
    into.seam_tension.resize(static_cast<Eigen::Index>(tension.size()));
    for (std::size_t i = 0; i < tension.size(); ++i)
        into.seam_tension[static_cast<Eigen::Index>(i)] = number_from(from, tension[i], "seam_tension");
}

Json remeshed_json(const Remeshed& remeshed) {
    Json object = {{"reason", remeshed.reason}, {"triangles_before", remeshed.triangles_before}};
    for (const auto& [key, member] : remeshed_numbers) object[key] = number_json(remeshed.*member);
    return object;
}

Remeshed remeshed_of(const PlanReader& from) {
    Remeshed remeshed;
    remeshed.reason = from.text("reason");
    remeshed.triangles_before = from.whole("triangles_before", 0, most_counted);
    for (const auto& [key, member] : remeshed_numbers) remeshed.*member = number_of(from, key);
    return remeshed;
}

Json deviation_json(const Deviation& off) {
    return {number_json(off.rms), number_json(off.max), number_json(off.moved_rms), number_json(off.moved_max)};
}

CompensationRound round_of(const PlanReader& from) {
    const json& off = from.list("off");
    if (off.size() != 4) from.refuse("off has not four numbers");
    const auto number = [&](std::size_t i) { return number_from(from, off[i], "off"); };
    return {from.text("step"),
            {number(0), number(1), number(2), number(3)},
            number_of(from, "height"),
            number_of(from, "volume"),
            number_of(from, "relaxation"),
            from.flag("is_best")};
}

}  // namespace

Json outcome_json(const FlatTile& tile, bool reproducible) {
    Json object = {{"method", tile.method},
                   {"flattening", flattening_json(tile.flattening)},
                   {"bounds",
                    {{"isoperimetric", number_json(tile.bounds.isoperimetric)},
                     {"stretch_ratio", number_json(tile.bounds.stretch_ratio)},
                     {"centre", place_json(tile.bounds.centre)},
                     {"radius", number_json(tile.bounds.radius)}}},
                   {"accuracy", accuracy_json(tile.accuracy)},
                   {"verdict", verdict_json(tile.verdict)},
                   {"equal_to", tile.equal_to},
                   {"mirrored", tile.mirrored},
                   {"attributes", tile.tile.attributes}};
    if (!reproducible && std::isfinite(tile.seconds)) object["seconds"] = tile.seconds;
    if (tile.tile.remeshed) object["remeshed"] = remeshed_json(*tile.tile.remeshed);
    if (tile.proposal) object["proposal"] = proposal_json(*tile.proposal);
    return object;
}

void read_outcome(const PlanReader& from, std::size_t tiles, FlatTile& into) {
    into.method = from.text("method");
    read_flattening(from.at("flattening"), into.flattening);
    const PlanReader bounds = from.at("bounds");
    into.bounds = {number_of(bounds, "isoperimetric"), number_of(bounds, "stretch_ratio"), place_of(bounds, "centre"),
                   number_of(bounds, "radius")};
    into.accuracy = accuracy_of(from.at("accuracy"));
    if (into.accuracy.chains.size() != into.tile.chains.size()) from.refuse("accuracy and tile differ in their chains");
    into.verdict = verdict_of(from.at("verdict"));
    into.equal_to = from.whole("equal_to", -1, static_cast<double>(tiles) - 1);
    into.mirrored = from.flag("mirrored");
    const PlanReader attributes = from.at("attributes");
    for (const auto& [key, value] : attributes.value().items())
        into.tile.attributes[key] = attributes.text(key.c_str());
    into.seconds = from.has("seconds") ? from.number("seconds") : std::numeric_limits<double>::quiet_NaN();
    if (from.has("remeshed")) into.tile.remeshed = remeshed_of(from.at("remeshed"));
    if (from.has("proposal")) into.proposal = proposal_of(from.at("proposal"));
}

Json plan_outcome_json(const CutPlan& plan) {
    Json merges = Json::array(), rounds = Json::array();
    for (const MergeProposal& merge : plan.merges)
        merges.push_back({{"tile_a", merge.tile_a},
                          {"tile_b", merge.tile_b},
                          {"seam", merge.seam},
                          {"merged", trial_json(merge.merged)}});
    for (const CompensationRound& round : plan.rounds)
        rounds.push_back({{"step", round.step},
                          {"off", deviation_json(round.off)},
                          {"height", number_json(round.height)},
                          {"volume", number_json(round.volume)},
                          {"relaxation", number_json(round.relaxation)},
                          {"is_best", round.is_best}});
    return {{"sha256", plan.input_sha256},
            {"remarks", plan.remarks},
            {"warnings", plan.warnings},
            {"fabric", Json::parse(write_fabric(plan.fabric))},
            {"findings", findings_json(plan.findings)},
            {"merges", merges},
            {"rounds", rounds}};
}

void read_plan_outcome(const PlanReader& from, CutPlan& into) {
    into.input_sha256 = from.text("sha256");
    into.remarks = texts_of(from, "remarks");
    into.warnings = texts_of(from, "warnings");
    std::istringstream fabric(from.at("fabric").value().dump());
    into.fabric = read_fabric(fabric, from.place() + ", fabric");
    into.findings = findings_of(from, "findings");
    const double tiles = static_cast<double>(into.tiles.size()), seams = static_cast<double>(into.seams.size());
    into.merges = from.each<MergeProposal>("merges", [&](const PlanReader& merge) {
        return MergeProposal{merge.whole("tile_a", 0, tiles - 1), merge.whole("tile_b", 0, tiles - 1),
                             merge.whole("seam", 0, seams - 1), trial_of(merge.at("merged"))};
    });
    into.rounds = from.each<CompensationRound>("rounds", round_of);
}

}  // namespace ripstop
