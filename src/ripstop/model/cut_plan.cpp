#include "ripstop/model/cut_plan.h"

#include <algorithm>

namespace ripstop {

bool CutPlan::manufacturable() const {
    return findings.empty() &&
           std::all_of(tiles.begin(), tiles.end(), [](const FlatTile& tile) { return tile.verdict.manufacturable(); });
}

double CutPlan::area() const {
    double sum = 0;
    for (const FlatTile& tile : tiles) sum += tile.accuracy.area;
    return sum;
}

}  // namespace ripstop
