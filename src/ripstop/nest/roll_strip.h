#pragma once

#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/nest/laid_shape.h"

namespace ripstop {

/// A shape whose lower left corner lies on a row of the roll. Its position along the roll follows from the order.
struct LaidItem {
    int shape = 0;
    int row = 0;
};

/// A laid item with the position of its lower left corner along the roll [m].
struct PlacedItem : LaidItem {
    double x = 0;
};

/// The joins of the cloth: after each of the lengths, then repeatedly after the last. Without lengths there are
/// none.
struct Joins {
    std::vector<double> lengths;  ///< [m], positive

    /// The first join beyond `x`; infinity if there is none. O(#lengths).
    double after(double x) const;
    /// The last join up to `x`; minus infinity if there is none.
    double before(double x) const;
};

/// The strip of cloth that pieces are laid on. An order of items determines a marker: each item in turn moves as
/// far to the start as it can without overlapping one of the `reach` items before it, without containing a join,
/// and beyond the ends of all older items.
struct Strip {
    double start = 0;  ///< nothing lies before it [m]
    double gap = 0;    ///< [m]
    int reach = 16;
    Joins joins;
    std::vector<LaidShape> shapes;
    std::vector<int> first_shape;  ///< index of each kind's first shape, plus the end; a kind's are adjacent

    const LaidShape& shape(const LaidItem& item) const { return shapes[at(item.shape)]; }
    double end(const PlacedItem& item) const { return item.x + shape(item).size.x(); }

    /// The first x not below `from` and outside of all `taken` intervals (sorted by their lower ends), from which
    /// `length` contains no join.
    double first_free(const std::vector<Interval>& taken, double from, double length) const;
};

}  // namespace ripstop
