#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// A fault of a pattern file, or a remark on it.
struct DrawingIssue {
    std::string code;     ///< `unit`, `open`, `gap`, … (docs/validate.schema.json)
    std::string message;  ///< one sentence: which piece, where and how much
    bool is_wrong = true;
    std::optional<Vec2> at = {};  ///< [m]
};

/// A closed line that pieces are cut or sewn along.
struct DrawingContour {
    std::string piece;  ///< the piece's name if the file tells it, otherwise its location
    std::string layer;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< [m]
    double area = 0;                                  ///< [m2]
    double perimeter = 0;                             ///< [m]
    int parts = 1;                                    ///< number of lines it was joined from
    bool is_cut = true;                               ///< false: sewn or only drawn
};

/// A layer of a pattern file and the number of objects of each kind on it.
struct DrawingLayer {
    std::string name;
    int lines = 0, points = 0, texts = 0;
};

/// The findings on a pattern file.
struct DrawingCheck {
    std::string format;
    std::string convention;  ///< `named layers (CUT, SEW, …)`, `numbered layers (AAMA, ASTM)`, `none known`
    std::optional<LengthUnit> unit = {};  ///< empty: millimetres are assumed
    std::string unit_from = {};           ///< where the file states it
    std::optional<double> square = {};    ///< side of the reference square as drawn [m], if there is one
    int blocks = 0;                       ///< blocks inserted
    int open_lines = 0;  ///< open lines on contour layers, except slits (lines that begin at a contour)
    std::vector<DrawingLayer> layers = {};
    std::vector<DrawingContour> contours = {};
    std::vector<DrawingIssue> issues = {};

    bool sound() const {
        return std::none_of(issues.begin(), issues.end(), [](const DrawingIssue& issue) { return issue.is_wrong; });
    }
};

}  // namespace ripstop
