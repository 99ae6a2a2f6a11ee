/// ripstop export: the pieces of a cut plan as other cut files, without solving again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "dxf_options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"
#include "ripstop/report/cut_files.h"
#include "ripstop/report/whole_directory.h"

namespace ripstop::cli {
namespace {

struct Arguments {
    std::filesystem::path plan, output;
    std::vector<std::string> formats{"dxf"};
    std::vector<std::string> tiles;
    PieceFileOptions files;
    bool force = false, quiet = false;
};

void keep_named(PieceSet& set, const std::vector<std::string>& globs) {
    const auto is_left_out = [&globs](const PatternPiece& piece) {
        return std::none_of(globs.begin(), globs.end(),
                            [&piece](const std::string& glob) { return glob_match(glob, piece.name); });
    };
    if (!globs.empty()) std::erase_if(set.pieces, is_left_out);
    if (set.pieces.empty()) throw InputError("no piece is called as --tile says; the names stand in tiles.csv");
}

/// After what is in it: dialects beside each other, as formats.
std::string default_name(const Arguments& given) {
    const PieceFileOptions usual;
    std::string axis = given.files.grain_axis.empty() ? "" : "-grain-" + given.files.grain_axis;
    if (given.files.dialect != usual.dialect && given.formats == std::vector<std::string>{"dxf"})
        return given.files.dialect + axis;
    return fmt::format("{}{}{}", fmt::join(given.formats, "-"),
                       given.files.dialect == usual.dialect ? "" : "-" + given.files.dialect, axis);
}

ExitCode run(Arguments given) {
    const PieceFileOptions files = dxf_options(given.files);
    if (given.output.empty()) given.output = given.plan / ("cut-" + default_name(given));
    for (const std::string& format : given.formats) piece_format_named(format);
    PieceSet set = read_pieces_of(given.plan);
    keep_named(set, given.tiles);
    write_whole_directory(given.output, given.force, {"envelope.*", "tiles"}, [&](const std::filesystem::path& folder) {
        write_cut_files(folder, set, given.formats, files);
    });
    if (!given.quiet) fmt::print("{} pieces: {}\n", set.pieces.size(), given.output.string());
    return manufacturable;
}

}  // namespace

void add_export(CLI::App& app) {
    auto given = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("export", "The pieces of a cut plan as other cut files, without solving again");
    command->add_option("plan", given->plan, "A folder that `ripstop flatten` wrote")->required();
    command->add_option("-o,--output", given->output, "The folder to write; else one in the plan's");
    std::string known;
    for (const PieceFormat& format : piece_formats())
        known += fmt::format("\n{:<6}{}", format.name, format.description);
    command->add_option("--format", given->formats, "What to write, several with commas:" + known)->delimiter(',');
    add_dxf_options(*command, given->files, "--dialect");
    command->add_option("--tile", given->tiles, "Only pieces of these names; * and ? stand for anything");
    command->add_flag("--force", given->force, "Replace the folder where it is not empty");
    command->add_flag("--quiet", given->quiet, "Say nothing where all is well");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
