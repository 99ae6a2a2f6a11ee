#include "options/piece_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/known.h"
#include "help/tell.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/pattern/cut/cut_check.h"

namespace ripstop::cli {
namespace {

double length_within(const std::string& text, const char* option, double least, double most) {
    const double length = parse_length(text, option);
    if (!(length >= least && length <= most))
        throw InputError(
            fmt::format("{} is {}, expected {:g} to {:g} mm", option, text, least / millimetre, most / millimetre));
    return length;
}

}  // namespace

void add_piece_options(CLI::App& command, PieceArguments& given) {
    command.add_option("--revision", given.revision, "Text on every piece (default: the start of the input's hash)")
        ->type_name("TEXT")
        ->group("Pieces");
    command
        .add_option("--corners", given.corners,
                    "How the cut line goes round a corner between two seams; hems are always folded back")
        ->capture_default_str()
        ->type_name("WORD")
        ->check(one_of({"mitre", "square", "fold"}))
        ->group("Pieces");
    command
        .add_option("--notch-spacing", given.notch_spacing,
                    "Distance between notches on a straight seam; down to a third of it on curves (default 750mm)")
        ->type_name("LENGTH")
        ->group("Pieces");
    command
        .add_option("--notch-depth", given.notch_depth, "Depth of a notch, at most 0.4 of the allowance (default 6mm)")
        ->type_name("LENGTH")
        ->group("Pieces");
    command
        .add_option("--simplify", given.simplify,
                    "Largest deviation of the sew line when points are left out (default 0.05mm)")
        ->type_name("LENGTH")
        ->group("Pieces");
    command
        .add_flag("--allowance-fit", given.allowance_fit,
                  "Narrow two allowances that do not fit between their edges; without this, such a piece is not "
                  "manufacturable")
        ->group("Pieces");
}

PieceOptions piece_options(const PieceArguments& given) {
    PieceOptions options;
    options.revision = given.revision;
    if (given.corners == "square") options.corners = CornerRule::square;
    if (given.corners == "fold") options.corners = CornerRule::fold;
    if (!given.notch_spacing.empty()) {
        options.notches.straight_spacing = length_within(given.notch_spacing, "--notch-spacing", 0.05, 100);
        options.notches.curved_spacing = options.notches.straight_spacing / 3;
    }
    if (!given.notch_depth.empty())
        options.notches.depth = length_within(given.notch_depth, "--notch-depth", 0.0005, 0.05);
    if (!given.simplify.empty()) options.chord_error = length_within(given.simplify, "--simplify", 1e-7, 0.01);
    return options;
}

ExitCode warn_of_cut_lines(const PieceSet& set, int threads) {
    const std::vector<std::string> faults = cut_line_faults(set.pieces, threads);
    for (const std::string& fault : faults) tell(fmt::format("Warning: {}\n", fault));
    return faults.empty() ? manufacturable : not_manufacturable;
}

}  // namespace ripstop::cli
