#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// A polyline of a drawing. A closed one does not repeat its first point.
struct DrawnPath {
    std::string layer;
    int group = -1;  ///< index in `PatternDrawing::groups`; -1: none
    Points2 points;  ///< #P x 2; curves are sampled as documented by the reader of the format
    bool is_closed = false;
    std::string entity = {};   ///< entity type in the file: `POLYLINE`, `path`
    long line = 0;             ///< line number in the file where it begins
    double low = 0, high = 0;  ///< lowest and highest z of its points, if the file has any
};

/// A point that marks a notch, a corner or a hole.
struct DrawnPoint {
    std::string layer;
    int group = -1;
    Vec2 at = Vec2::Zero();
    double height = 0;  ///< z coordinate: the depth of a notch
    double width = 0;   ///< thickness: the width of a notch
    double angle = 0;   ///< [degrees], counter-clockwise
};

/// A text of a drawing.
struct DrawnText {
    std::string layer;
    int group = -1;
    std::string text;
    Vec2 at = Vec2::Zero();
    double height = 0;
    double turn = 0;  ///< [degrees], counter-clockwise
};

/// A group of objects: an inserted block or a group of an SVG.
struct DrawingGroup {
    std::string name;
    std::string layer;   ///< layer on which the block is inserted
    int insertions = 1;  ///< 0: a block that is defined but never inserted; its content is not in the drawing
    long line = 0;
};

/// Objects that are drawn but not understood, counted by kind, layer and reason.
struct UnreadEntity {
    std::string kind, layer;
    int count = 1;
    long line = 0;            ///< line number of the first one
    std::string reason = {};  ///< text to follow `1 image on layer art`; empty: the default for its kind
    bool may_be_cut = false;  ///< it may contain a line that somebody cuts
    bool is_carried =
        false;  ///< its line is in `paths`; only other properties of it are lost, such as dashes or a filter
    std::optional<Vec2> at = {};  ///< place of the first one, if known
};

/// A place in a file that states the unit of its numbers.
struct StatedUnit {
    std::string where;  ///< `$INSUNITS`, `the text "Units: METRIC"`, …
    LengthUnit unit;
};

/// The content of a pattern file from any program, in the file's own numbers with y up.
struct PatternDrawing {
    std::string format;        ///< `DXF AC1009`, `SVG`
    std::string comment = {};  ///< text of the first comment
    std::vector<StatedUnit> units = {};
    std::vector<std::string> declared_layers = {};
    std::vector<DrawingGroup> groups = {};
    std::vector<DrawnPath> paths = {};
    std::vector<DrawnPoint> points = {};
    std::vector<DrawnText> texts = {};
    std::vector<UnreadEntity> unread = {};

    /// Counts an unread object with others of its kind, layer and reason. After a hundred such groups all further
    /// ones count with the last.
    void leave_unread(const UnreadEntity& entity) {
        constexpr std::size_t most = 100;
        for (UnreadEntity& other : unread)
            if (other.kind == entity.kind && other.layer == entity.layer && other.reason == entity.reason) {
                ++other.count;
                return;
            }
        if (unread.size() < most) {
            unread.push_back(entity);
            return;
        }
        ++unread.back().count;
        unread.back().may_be_cut = unread.back().may_be_cut || entity.may_be_cut;
        unread.back().is_carried = unread.back().is_carried && entity.is_carried;
    }
    void leave_unread(const std::string& kind, const std::string& layer, long line) {
        leave_unread({kind, layer, 1, line});
    }
};

}  // namespace ripstop
