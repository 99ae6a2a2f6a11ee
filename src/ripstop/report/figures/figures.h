#pragma once

#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// `value` without the noise of binary arithmetic: rounded to 12 significant digits, so that 7 % is 7 and not
/// 7.000000000000001, and 0 below 1e-12 in size, which no unit of the report can mean. What is not finite stays so.
double clean(double value);

/// The worst length error of a tile's chains, with its sign; 0 without chains, not a number if one's is.
double worst_chain_error(const Accuracy& accuracy);

/// The codes of the findings, each once, in their order: `chain, flipped`; `not judged` where nobody judged; empty
/// where the tile can be made.
std::string failing_codes(const Verdict& verdict);

/// Has each vertex a finite place on the cloth? Only then is there something to draw.
bool is_drawable(const FlatTile& tile);

/// A file name stem for each name: ASCII letters, digits, `.`, `_`, `-`, all else `_`; no leading point or dash, at
/// most 80 characters, never empty, and unique even where upper and lower case are one (then `_2`, `_3` … in order).
/// None is `seams`, the picture of the seams, nor a device of Windows: `con.a` gives `con_.a`.
std::vector<std::string> file_stems(const std::vector<std::string>& names);
std::vector<std::string> file_stems(const CutPlan& plan);

/// How many decimals `value` in percent or degrees is shown with: `-0.012`; a dash where it is not finite.
std::string shown(double value, int decimals, bool with_sign = false);

}  // namespace ripstop
