#include "ripstop/design/tools/panel_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

// A point counts as odd, so that the next row is even and the fan on it symmetric.
int parity(int seam) {
    return seam == 0 ? 1 : seam % 2;
}

int nearest_of_parity(double wish, int odd) {
    return 2 * static_cast<int>(std::lround((wish - odd) / 2)) + odd;
}

/// A strip between two rows, triangulated from the middle to the right, each triangle together with its mirror image.
struct LaidStrip {
    int lower_start, upper_start;  ///< index of the first vertex of each row
    int lower, upper;              ///< number of edges of each row
    bool lower_seam, upper_seam;
    std::vector<std::array<int, 3>>& triangles;

    struct Corner {
        bool up;
        int index;
    };

    int vertex(Corner c, bool mirror) const {
        const int count = c.up ? upper : lower;
        return (c.up ? upper_start : lower_start) + (mirror ? count - c.index : c.index);
    }
    void add(Corner a, Corner b, Corner c) {
        triangles.push_back({vertex(a, false), vertex(b, false), vertex(c, false)});
    }
    void add_pair(Corner a, Corner b, Corner c) {
        add(a, b, c);
        triangles.push_back({vertex(a, true), vertex(c, true), vertex(b, true)});
    }

    /// Whether the next triangle uses an edge of the lower row. It takes the shorter new edge, except that a seam's
    /// row must end before the row inside, or the corner would be cut off.
    bool advance_lower(int i, int j) const {
        if (j == upper) return true;
        if (i == lower) return false;
        if (lower_seam && j + 1 == upper) return true;
        if (upper_seam && i + 1 == lower) return false;
        const long n = lower;
        const long m = upper;
        const long lower_reach = std::abs((2 * (i + 1) - n) * m - (2 * j - m) * n);
        const long upper_reach = std::abs((2 * (j + 1) - m) * n - (2 * i - n) * m);
        return lower_reach != upper_reach ? lower_reach < upper_reach : n > m;
    }

    void fill() {
        int i = (lower + 1) / 2;
        int j = (upper + 1) / 2;
        if (lower % 2 == 1) add({false, i - 1}, {false, i}, {true, j});
        if (upper % 2 == 1) add({false, i}, {true, j}, {true, j - 1});
        while (i < lower || j < upper) {
            if (advance_lower(i, j)) {
                add_pair({false, i}, {false, i + 1}, {true, j});
                ++i;
            } else {
                add_pair({false, i}, {true, j + 1}, {true, j});
                ++j;
            }
        }
    }
};

}  // namespace

bool parity_fits(int first, int last, int strips) {
    return (parity(first) + parity(last) + strips) % 2 == 0;
}

RowColumns stagger(const std::vector<RowWish>& wishes, int first, int last) {
    const int strips = static_cast<int>(wishes.size()) - 1;
    RowColumns columns{first};
    for (int k = 1; k < strips; ++k) {
        const RowWish& wish = wishes[at(k)];
        int least = std::max(2, wish.least);
        if (k == 1) least = std::max(least, first + 1);
        if (k == strips - 1) least = std::max(least, last + 1);
        const int odd = (parity(first) + k) % 2;
        int count = nearest_of_parity(wish.across, odd);
        while (count < least) count += 2;
        columns.push_back(count);
    }
    columns.push_back(last);
    return columns;
}

Triangles triangulate_rows(const RowColumns& columns) {
    std::vector<std::array<int, 3>> triangles;
    int start = 0;
    for (std::size_t k = 0; k + 1 < columns.size(); ++k) {
        const int next = start + columns[k] + 1;
        LaidStrip{start, next, columns[k], columns[k + 1], k == 0, k + 2 == columns.size(), triangles}.fill();
        start = next;
    }
    Triangles result(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) result(static_cast<Eigen::Index>(t), k) = triangles[t][at(k)];
    return result;
}

}  // namespace ripstop
