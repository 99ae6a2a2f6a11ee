#include "ripstop/tile/seam_sheets.h"

#include <algorithm>

#include "ripstop/base/union_find.h"

namespace ripstop {

std::vector<std::vector<SeamSheet>> sheets_of_seams(const std::vector<Seam>& seams) {
    std::vector<std::vector<SeamSheet>> sheets(seams.size());
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const Seam& seam = seams[s];
        if (seam.into) {
            sheets[at(seam.into->seam)].push_back(
                {&seam, &seam.a, seam.into->from, seam.into->from + seam.length, seam.into->backwards});
            continue;
        }
        sheets[s].push_back({&seam, &seam.a, 0, seam.length, false});
        sheets[s].push_back({&seam, &seam.b, 0, seam.length, true});
    }
    return sheets;
}

std::vector<SeamPart> parts_between(const SeamSheet& sheet, double from, double to) {
    const double smallest = 1e-9 * (sheet.to - sheet.from);  // a shorter remainder is rounding
    std::vector<SeamPart> parts;
    double at = 0;  // arc length along the parts
    const double low = sheet.backwards ? sheet.to - to : from - sheet.from;
    const double high = sheet.backwards ? sheet.to - from : to - sheet.from;
    for (const SeamPart& part : sheet.side->parts) {
        const double shared = std::min(high, at + part.length) - std::max(low, at);
        const bool is_whole = shared >= part.length - smallest;
        if (shared > smallest) parts.push_back({part.edge, is_whole ? part.length : shared});
        at += part.length;
    }
    return parts;
}

std::vector<char> find_inner_sheets(int tiles, const std::vector<Seam>& seams) {
    UnionFind groups(at(tiles));
    for (const Seam& seam : seams)
        if (!seam.into) groups.join(seam.a.tile, seam.b.tile);
    std::vector<double> hangs(at(tiles), 0), carries(at(tiles), 0);  // lengths [m]
    for (const Seam& seam : seams) {
        if (!seam.into) continue;
        const std::size_t sheet = at(groups.root(seam.a.tile)), skin = at(groups.root(seam.b.tile));
        if (sheet == skin) continue;
        hangs[sheet] += seam.length;
        carries[skin] += seam.length;
    }
    std::vector<char> is_inner;
    for (int t = 0; t < tiles; ++t) {
        const std::size_t sheet = at(groups.root(t));
        is_inner.push_back(hangs[sheet] > 0 && hangs[sheet] >= carries[sheet]);
    }
    return is_inner;
}

}  // namespace ripstop
