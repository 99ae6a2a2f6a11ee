#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `value` without rounding noise: rounded to 12 significant digits, so that 7 % is 7 and not 7.000000000000001.
/// Sizes below 1e-12, which mean nothing in any unit of the report, become 0. Values that are not finite are kept.
double clean(double value);

/// The largest length error of a tile's chains, with its sign; 0 without chains; NaN if one of them is NaN.
double worst_chain_error(const Accuracy& accuracy);

/// The codes of the findings, each once, in order: `chain, flipped`; `not judged` if there is no verdict; empty if
/// the tile can be made.
std::string failing_codes(const Verdict& verdict);

/// A file name stem for each name: ASCII letters, digits, `.`, `_`, `-`; other characters become `_`. A stem has
/// no leading dot or dash, has 1 to 80 characters, and is unique even if case is ignored (`_2`, `_3`, … in order).
/// None is `seams`, the picture of the seams, or a device of Windows: `con.a` gives `con_.a`.
std::vector<std::string> file_stems(const std::vector<std::string>& names);
std::vector<std::string> file_stems(const CutPlan& plan);

/// `value` (in percent or degrees) with this many decimals: `-0.012`; a dash if it is not finite.
std::string shown(double value, int decimals, bool with_sign = false);

}  // namespace ripstop
