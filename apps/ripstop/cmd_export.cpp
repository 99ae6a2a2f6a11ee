/// ripstop export: the pieces of a cut plan as other cut files, without solving again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "format_options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"
#include "ripstop/report/cut_files.h"
#include "ripstop/report/whole_directory.h"

namespace ripstop::cli {
namespace {

struct Arguments {
    std::filesystem::path plan, output;
    FormatArguments files{{"dxf"}};
    std::vector<std::string> tiles;
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

/// After what is in it: dialects and papers beside each other, as formats.
std::string default_name(const FormatArguments& given) {
    const PieceFileOptions usual, &files = given.files;
    std::vector<std::string> words = given.formats;
    if (files.dialect != usual.dialect) {
        if (words == std::vector<std::string>{"dxf"}) words.clear();
        words.push_back(files.dialect);
    }
    if (!files.grain_axis.empty()) words.push_back("grain-" + files.grain_axis);
    if (files.paper != usual.paper) words.push_back(files.paper);
    return fmt::format("{}", fmt::join(words, "-"));
}

ExitCode run(Arguments given) {
    const PieceFileOptions files = file_options(given.files);
    if (given.output.empty()) given.output = given.plan / ("cut-" + default_name(given.files));
    PieceSet set = read_pieces_of(given.plan);
    keep_named(set, given.tiles);
    write_whole_directory(given.output, given.force, {"envelope.*", "tiles"}, [&](const std::filesystem::path& folder) {
        write_cut_files(folder, set, given.files.formats, files);
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
    add_format_options(*command, given->files, "--dialect");
    command->add_option("--tile", given->tiles, "Only pieces of these names; * and ? stand for anything");
    command->add_flag("--force", given->force, "Replace the folder where it is not empty");
    command->add_flag("--quiet", given->quiet, "Say nothing where all is well");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
