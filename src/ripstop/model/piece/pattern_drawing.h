#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// A line of a drawing, straight from point to point. A closed one does not repeat its first point.
struct DrawnPath {
    std::string layer;
    int group = -1;  ///< in `PatternDrawing::groups`; -1: none
    Points2 points;  ///< #P x 2; curves are sampled, as the reader of the format says
    bool is_closed = false;
    std::string entity = {};   ///< what it is called in the file: `POLYLINE`, `path`
    long line = 0;             ///< of the file, where it begins
    double low = 0, high = 0;  ///< between which heights it is drawn, where the file has any
};

/// A point that stands for a notch, a corner or a hole.
struct DrawnPoint {
    std::string layer;
    int group = -1;
    Vec2 at = Vec2::Zero();
    double height = 0;  ///< its z: the depth of a notch
    double width = 0;   ///< its thickness: the width of a notch
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

/// What belongs together: an inserted block, a group of an SVG.
struct DrawingGroup {
    std::string name;
    std::string layer;   ///< on which the block is inserted
    int insertions = 1;  ///< 0: a block that is defined and never drawn; its content is not in the drawing
    long line = 0;
};

/// What is drawn and not understood, counted a kind, layer and reason.
struct UnreadEntity {
    std::string kind, layer;
    int count = 1;
    long line = 0;            ///< of the first
    std::string reason = {};  ///< how it goes on after `1 image on layer art`; empty: by its kind
    bool may_be_cut = false;  ///< a line that somebody cuts may be in it
    bool is_carried =
        false;  ///< its line is in `paths`; what is left out is something else of it, its dashes or its filter
    std::optional<Vec2> at = {};  ///< of the first, where it is known
};

/// A place where a file says what its numbers are.
struct StatedUnit {
    std::string where;  ///< `$INSUNITS`, `the text "Units: METRIC"`, …
    LengthUnit unit;
};

/// A pattern file of anyone's, in the file's own numbers with y up.
struct PatternDrawing {
    std::string format;        ///< `DXF AC1009`, `SVG`
    std::string comment = {};  ///< of the first line
    std::vector<StatedUnit> units = {};
    std::vector<std::string> declared_layers = {};
    std::vector<DrawingGroup> groups = {};
    std::vector<DrawnPath> paths = {};
    std::vector<DrawnPoint> points = {};
    std::vector<DrawnText> texts = {};
    std::vector<UnreadEntity> unread = {};

    /// Counts it with those of its kind and layer; after a hundred of them with the last.
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
