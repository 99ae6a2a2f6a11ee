#include "options/guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ripstop::cli {
namespace {

/// The edit distance with transpositions: the number of letters to insert, remove, change or swap with their
/// neighbour.
std::size_t distance(const std::string& one, const std::string& other) {
    std::vector<std::size_t> before, last, row(other.size() + 1);
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 0; i < one.size(); ++i) {
        before = std::exchange(last, row);
        row[0] = i + 1;
        for (std::size_t k = 0; k < other.size(); ++k) {
            row[k + 1] = std::min({last[k + 1] + 1, row[k] + 1, last[k] + (one[i] != other[k])});
            if (i > 0 && k > 0 && one[i] == other[k - 1] && one[i - 1] == other[k])
                row[k + 1] = std::min(row[k + 1], before[k - 1] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::string guess(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    if (word.size() < 3) return best;
    std::size_t least = 1 + word.size() / 4;
    for (const std::string& each : known)
        if (const std::size_t off = distance(word, each); off <= least) {
            if (off < least || best.empty()) best = each;
            least = off;
        }
    return best.empty() || least == 0 ? best : fmt::format("; did you mean {}?", best);
}

}  // namespace ripstop::cli
