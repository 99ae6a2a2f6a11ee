#pragma once

#include <vector>

#include "ripstop/nest/laid_shape.h"

namespace ripstop {

/// A shape with its lower left corner on a row of the roll; how far along it lies follows from the order.
struct LaidItem {
    int shape = 0;
    int row = 0;
};

/// The same with its lower left corner's place along the roll [m].
struct PlacedItem : LaidItem {
    double x = 0;
};

/// Where the cloth is joined: after each of the lengths, then again and again after the last. None: it never ends.
struct Joins {
    std::vector<double> lengths;  ///< [m], positive

    /// The first join beyond `x`; infinity where there is none. O(#lengths).
    double after(double x) const;
    /// The last join up to `x`; minus infinity where there is none.
    double before(double x) const;
};

/// What pieces are laid on. An order of items becomes a marker: each in turn goes as far to the start as it can without
/// overlapping one of the `reach` items before it, without a join in it, and beyond the ends of all older ones.
struct Strip {
    double start = 0;  ///< nothing lies before it [m]
    double gap = 0;    ///< [m]
    int reach = 16;
    Joins joins;
    std::vector<LaidShape> shapes;
    std::vector<int> first_shape;  ///< of each kind, and one more: a kind's shapes follow one another

    const LaidShape& shape(const LaidItem& item) const { return shapes[static_cast<std::size_t>(item.shape)]; }
    double end(const PlacedItem& item) const { return item.x + shape(item).size.x(); }

    /// The first x from `from` on, outside all of `taken` (sorted by their lower ends), from which `length` has no join
    /// in it.
    double first_free(const std::vector<Interval>& taken, double from, double length) const;
};

}  // namespace ripstop
