#include "ripstop/io/json/sewing_json.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/json/outcome_json.h"
#include "ripstop/io/json/plan_reader.h"
#include "ripstop/io/json/project_flight.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;
using nlohmann::json;

Json type_json(const SeamType& type) {
    return {{"name", type.name}, {"allowance_m", type.allowance}, {"rows", type.rows}, {"tape", type.tape}};
}

Json numbers_json(const Eigen::VectorXd& numbers) {
    return std::vector<double>(numbers.begin(), numbers.end());
}

Json tile_json(const Tile& tile, const std::string& file, bool edges_on_curve, int fabric) {
    Json chains = Json::array();
    for (const Chain& chain : tile.chains)
        chains.push_back({{"first", chain.vertices.front()}, {"finish", type_json(chain.finish)}});
    Json object = {{"name", tile.name},
                   {"file", file},
                   {"fabric", fabric},
                   {"warp", {tile.grain.direction.x(), tile.grain.direction.y(), tile.grain.direction.z()}},
                   {"warp_source", tile.grain.source},
                   {"edges_on_curve", edges_on_curve},
                   {"chains", chains}};
    if (tile.curve_lengths.size() > 0) object["curve_lengths_m"] = numbers_json(tile.curve_lengths);
    const Compensation& longer = tile.compensation;
    if (longer.any())
        object["compensation"] = {{"warp", longer.warp},
                                  {"weft", longer.weft},
                                  {"chains", longer.chains},
                                  {"for_flight", longer.strain.rows() > 0}};
    if (tile.grain.field.rows() > 0) {
        object["warp_field"] = Json::array();
        for (Eigen::Index t = 0; t < tile.grain.field.rows(); ++t)
            object["warp_field"].push_back({tile.grain.field(t, 0), tile.grain.field(t, 1), tile.grain.field(t, 2)});
    }
    return object;
}

Json side_json(const SeamSide& side) {
    Json edges = Json::array(), lengths = Json::array();
    for (const SeamPart& part : side.parts) {
        edges.push_back(part.edge);
        lengths.push_back(part.length);
    }
    Json object = {{"tile", side.tile}, {"chain", side.chain}, {"edges", edges}, {"lengths_m", lengths}};
    if (side.allowance) object["allowance_m"] = *side.allowance;
    return object;
}

constexpr double most_vertices = 1e8;
constexpr const char* sewing_schema = "1.1";

SeamType type_of(const PlanReader& reader) {
    return {reader.text("name"), reader.number("allowance_m"), reader.whole("rows", 0, 100), reader.flag("tape")};
}

void read_tile(const PlanReader& reader, const std::vector<Fabric>& fabrics, Sewing& into) {
    FlatTile flat;
    Tile& tile = flat.tile;
    tile.name = reader.text("name");
    tile.fabric = fabrics[at(reader.whole("fabric", 0, static_cast<double>(fabrics.size()) - 1))];
    tile.grain = {reader.point("warp"), reader.text("warp_source")};
    flat.flattening.edges_on_curve = reader.flag("edges_on_curve");
    into.corners.emplace_back();
    for (std::size_t c = 0; c < reader.list("chains").size(); ++c) {
        const PlanReader chain = reader.in("chains", c);
        into.corners.back().push_back(chain.whole("first", 0, most_vertices));
        tile.chains.push_back({{}, type_of(chain.at("finish"))});
    }
    if (tile.chains.empty()) reader.refuse("chains is empty");
    if (reader.has("curve_lengths_m")) {
        const std::vector<double> lengths = reader.numbers("curve_lengths_m");
        tile.curve_lengths = Eigen::Map<const Eigen::VectorXd>(lengths.data(), std::ssize(lengths));
    }
    if (reader.has("compensation")) {
        const PlanReader longer = reader.at("compensation");
        tile.compensation = {longer.number("warp"), longer.number("weft"), longer.numbers("chains")};
        if (longer.flag("for_flight")) into.plan.is_compensated = true;
    }
    if (reader.has("warp_field")) {
        const json& rows = reader.list("warp_field");
        tile.grain.field.resize(static_cast<Eigen::Index>(rows.size()), 3);
        for (std::size_t t = 0; t < rows.size(); ++t)
            tile.grain.field.row(static_cast<Eigen::Index>(t)) = point_of(rows[t], reader.place() + ", warp_field");
    }
    into.plan.tiles.push_back(std::move(flat));
    into.files.push_back(reader.text("file"));
}

SeamSide side_of(const PlanReader& reader, std::size_t tiles) {
    SeamSide side;
    side.tile = reader.whole("tile", 0, static_cast<double>(tiles) - 1);
    side.chain = reader.whole("chain", 0, most_vertices);
    const std::vector<int> edges = reader.wholes("edges", 0, most_vertices);
    const std::vector<double> lengths = reader.numbers("lengths_m");
    if (edges.empty() || edges.size() != lengths.size()) reader.refuse("edges and lengths_m differ in number");
    for (std::size_t i = 0; i < edges.size(); ++i) side.parts.push_back({edges[i], lengths[i]});
    if (reader.has("allowance_m")) side.allowance = reader.number("allowance_m");
    return side;
}

/// The seam must come before this one in the list, and must join two sheets.
SewnInto read_sewn_into(const PlanReader& reader, const std::vector<Seam>& before) {
    const SewnInto into{reader.whole("seam", 0, static_cast<double>(before.size()) - 1), reader.number("from_m"),
                        reader.flag("backwards")};
    if (before[at(into.seam)].into) reader.refuse("lies in a seam that lies in another itself");
    return into;
}

}  // namespace

std::string sewing_json(const CutPlan& plan, const std::vector<std::string>& files, bool reproducible) {
    const std::vector<Fabric> fabrics = plan.fabrics();
    Json cloths = Json::array(), tiles = Json::array(), seams = Json::array();
    for (const Fabric& fabric : fabrics) cloths.push_back(Json::parse(write_fabric(fabric)));
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        const auto fabric = std::find(fabrics.begin(), fabrics.end(), plan.fabric_of(tile.tile));
        tiles.push_back(
            tile_json(tile.tile, files[i], tile.flattening.edges_on_curve, static_cast<int>(fabric - fabrics.begin())));
        tiles.back()["outcome"] = outcome_json(tile, reproducible);
    }
    for (const Seam& seam : plan.seams) {
        seams.push_back({{"id", seam.id},
                         {"length_m", seam.length},
                         {"uncertainty_m", seam.uncertainty},
                         {"gap_m", seam.gap},
                         {"type", type_json(seam.type)},
                         {"a", side_json(seam.a)},
                         {"b", side_json(seam.b)}});
        if (seam.into)
            seams.back()["sewn_into"] = {
                {"seam", seam.into->seam}, {"from_m", seam.into->from}, {"backwards", seam.into->backwards}};
    }
    Json object = {{"schema", sewing_schema},
                   {"input", plan.input_file},
                   {"fabrics", cloths},
                   {"tolerances",
                    {{"area", plan.tolerances.area},
                     {"length", plan.tolerances.length},
                     {"strain", plan.tolerances.strain},
                     {"shear_rad", plan.tolerances.shear},
                     {"strain_for_all", plan.tolerances.strain_for_all},
                     {"shear_for_all", plan.tolerances.shear_for_all}}},
                   {"tiles", tiles},
                   {"seams", seams},
                   {"tape_factors", plan.tape_factors},
                   {"unit", plan.unit},
                   {"outcome", plan_outcome_json(plan)}};
    if (plan.flight) object["flight"] = flight_json(*plan.flight);
    return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Sewing read_sewing(std::istream& in, const std::string& name) {
    const json object = read_json_object(in, name);
    const PlanReader reader(object, name);
    if (reader.text("schema") != sewing_schema) reader.refuse("was written by a different version");
    Sewing sewing;
    sewing.plan.input_file = reader.text("input");
    if (reader.has("unit")) sewing.plan.unit = reader.text("unit");
    std::vector<Fabric> fabrics;
    for (const json& fabric : reader.list("fabrics")) {
        std::istringstream text(fabric.dump());
        fabrics.push_back(read_fabric(text, name + ", fabrics"));
    }
    if (fabrics.empty()) reader.refuse("fabrics is empty");
    sewing.plan.fabric = fabrics.front();
    const PlanReader tolerances = reader.at("tolerances");
    sewing.plan.tolerances = {tolerances.number("area"),         tolerances.number("length"),
                              tolerances.number("strain"),       tolerances.number("shear_rad"),
                              tolerances.flag("strain_for_all"), tolerances.flag("shear_for_all")};
    for (std::size_t i = 0; i < reader.list("tiles").size(); ++i) read_tile(reader.in("tiles", i), fabrics, sewing);
    for (std::size_t i = 0; i < reader.list("seams").size(); ++i) {
        const PlanReader each = reader.in("seams", i);
        Seam seam{each.text("id"), side_of(each.at("a"), sewing.plan.tiles.size()),
                  side_of(each.at("b"), sewing.plan.tiles.size())};
        seam.length = each.number("length_m");
        seam.uncertainty = each.number("uncertainty_m");
        seam.gap = each.number("gap_m");
        seam.type = type_of(each.at("type"));
        if (each.has("sewn_into")) seam.into = read_sewn_into(each.at("sewn_into"), sewing.plan.seams);
        sewing.plan.seams.push_back(std::move(seam));
    }
    for (std::size_t i = 0; i < sewing.plan.tiles.size(); ++i)
        read_outcome(reader.in("tiles", i).at("outcome"), i, sewing.plan.tiles[i]);
    read_plan_outcome(reader.at("outcome"), sewing.plan);
    sewing.plan.tape_factors = reader.numbers("tape_factors");
    if (reader.has("flight"))
        sewing.plan.flight = read_flight(reader.value().at("flight"), 1, reader.place() + ", flight");
    if (!sewing.plan.tape_factors.empty() && sewing.plan.tape_factors.size() != sewing.plan.seams.size())
        reader.refuse("tape_factors differ in number from the seams");
    return sewing;
}

}  // namespace ripstop
