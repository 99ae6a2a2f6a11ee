/// ripstop lift: carries lines drawn on flat pieces back to the tiles in space, as curves.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "commands/commands.h"
#include "help/tell.h"
#include "options/options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/glob.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/mesh/obj.h"
#include "ripstop/io/pattern_file.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "ripstop/pipeline/drawing/lift_drawing.h"
#include "ripstop/plan_folder/cut_files.h"

namespace ripstop::cli {
namespace {

struct LiftArguments {
    std::filesystem::path plan, drawing, output;
    std::vector<std::string> layers;
    std::string unit = "m";
    bool force = false;
};

NamedMesh flat_tile(const std::filesystem::path& plan, const PatternPiece& piece) {
    const std::filesystem::path file = plan / "flat" / (piece.file + ".obj");
    CadModel model = read_model(file);
    if (model.surfaces.size() != 1 || !model.surfaces[0].drawn)
        throw InputError(file.string() + ": holds no tile with flat positions; flatten the envelope again");
    return std::move(model.surfaces[0]);
}

bool is_wanted(const LiftArguments& given, const std::string& layer) {
    return given.layers.empty() || std::any_of(given.layers.begin(), given.layers.end(),
                                               [&](const std::string& glob) { return glob_match(glob, layer); });
}

/// One sentence for each thing drawn on the wanted layers that cannot be lifted.
std::vector<std::string> left_out(const LiftArguments& given, const PatternDrawing& drawing, double metres_per_unit) {
    std::vector<std::string> texts;
    for (const UnreadEntity& entity : drawing.unread)
        if (!entity.is_carried && is_wanted(given, entity.layer)) texts.push_back(unread_text(entity, metres_per_unit));
    return texts;
}

/// Reports that no piece was found, or that some cut lines match no piece.
void tell_strangers(const LiftArguments& given, const LiftedLines& lifted) {
    constexpr std::size_t most = 6;
    const std::vector<std::string>& all = lifted.strangers;
    const std::vector<std::string> first(all.begin(), all.begin() + static_cast<long>(std::min(most, all.size())));
    const std::string text = fmt::format("{}{}", fmt::join(first, ", "), all.size() > most ? ", …" : "");
    if (lifted.pieces == 0)
        throw InputError(
            fmt::format("{}: contains none of the plan's pieces{}; expected their closed cut lines at true size, "
                        "neither rotated nor mirrored, with lines drawn on them; draw on a file of this plan's cut/",
                        given.drawing.string(), all.empty() ? "" : ", only " + text));
    if (!all.empty())
        tell(fmt::format("Warning: {} cut line{} no piece of the plan, and the lines drawn there are left out: {}\n",
                         all.size(), all.size() == 1 ? " matches" : "s match", text));
}

void keep_wanted(const LiftArguments& given, LiftedLines& lifted, const std::vector<std::string>& left_out) {
    std::set<std::string> layers;
    for (const NamedCurve& curve : lifted.curves) layers.insert(curve.attributes.at("layer"));
    std::erase_if(lifted.curves,
                  [&given](const NamedCurve& curve) { return !is_wanted(given, curve.attributes.at("layer")); });
    if (!lifted.curves.empty()) return;
    if (!left_out.empty())
        throw InputError(fmt::format("{}: nothing that is drawn on its pieces can be lifted: {}",
                                     given.drawing.string(), fmt::join(left_out, "; ")));
    if (layers.empty())
        throw InputError(
            fmt::format("{}: its pieces have only their own lines, such as the sew line; draw lines on them first",
                        given.drawing.string()));
    throw InputError(fmt::format("{}: no line on a layer called {}; there are lines on {}", given.drawing.string(),
                                 fmt::join(given.layers, ", "), fmt::join(layers, ", ")));
}

ExitCode run(const LiftArguments& given) {
    if (std::filesystem::exists(given.output) && !given.force)
        throw InputError(given.output.string() + ": exists; give another name, or --force to replace it");
    const PieceSet set = read_pieces_of(given.plan);
    const LengthUnit unit{given.unit, metres_per_unit(given.unit)};
    const PatternDrawing drawing = read_pattern_file(given.drawing);
    const double scale = check_drawing(drawing).unit.value_or(LengthUnit{"mm", millimetre}).metres;
    const auto tile = [&given](const PatternPiece& piece) { return flat_tile(given.plan, piece); };
    LiftedLines lifted = lift_drawing(drawing, scale, set, tile, given.drawing.stem().string());
    tell_strangers(given, lifted);
    const std::vector<std::string> unread = left_out(given, drawing, scale);
    keep_wanted(given, lifted, unread);
    for (const std::string& text : unread) tell("Warning: left out: " + text + "\n");
    for (NamedCurve& curve : lifted.curves) curve.points /= unit.metres;
    replace_file(given.output, [&lifted](std::ostream& out) { write_obj_curves(out, lifted.curves); });
    print("pieces found: {}, lines lifted: {}, in {}: {}\n", lifted.pieces, lifted.curves.size(), unit.name,
          given.output.string());
    return manufacturable;
}

}  // namespace

void add_lift(CLI::App& app) {
    auto given = std::make_shared<LiftArguments>();
    CLI::App* command = app.add_subcommand(
        "lift", "Carry lines drawn on flat pieces back to the tiles in space, as curves for the model");
    command->add_option("PLAN", given->plan, "A folder that `ripstop flatten` wrote")->type_name("DIR")->required();
    command->add_option("DRAWING", given->drawing, "A DXF or SVG of its pieces with lines drawn on them")
        ->type_name("FILE")
        ->required();
    command->add_option("-o,--output", given->output, "The OBJ to write: one polyline (l) per line")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--layer", given->layers,
                     "Only lines on layers of this name; * and ? stand for other letters; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--unit", given->unit, "Unit of the OBJ")
        ->capture_default_str()
        ->type_name("UNIT")
        ->check(known_unit());
    command->add_flag("--force", given->force, "Replace the file if it exists");
    command->footer(
        "Examples (after lines were drawn on the layer artwork, in Inkscape or a CAD program):\n"
        "  ripstop lift cut-plan cut-plan/cut/tiles/G01P05.svg --layer artwork -o artwork.obj\n"
        "  ripstop lift cut-plan cut-plan/cut/envelope.dxf --unit mm -o artwork.obj\n\n"
        "Exit codes: 0 written, 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
