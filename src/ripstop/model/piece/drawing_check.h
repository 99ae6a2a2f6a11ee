#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// Something that is wrong with a pattern file, or worth knowing.
struct DrawingIssue {
    std::string code;     ///< `unit`, `open`, `gap`, … (docs/validate.schema.json)
    std::string message;  ///< one sentence: which piece, where, how much
    bool is_wrong = true;
    std::optional<Vec2> at = {};  ///< [m]
};

/// A closed line that pieces are cut or sewn along.
struct DrawingContour {
    std::string piece;  ///< the piece's name as far as the file tells, else where it is
    std::string layer;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< [m]
    double area = 0;                                  ///< [m2]
    double perimeter = 0;                             ///< [m]
    int parts = 1;                                    ///< lines it is made of
    bool is_cut = true;                               ///< else sewn, or drawn
};

/// A layer of a pattern file and how many things of each kind lie on it.
struct DrawingLayer {
    std::string name;
    int lines = 0, points = 0, texts = 0;
};

/// What was found of a pattern file.
struct DrawingCheck {
    std::string format;
    std::string convention;  ///< `named layers (CUT, SEW, …)`, `numbered layers (AAMA, ASTM)`, `none known`
    std::optional<LengthUnit> unit = {};  ///< none: taken as millimetres
    std::string unit_from = {};           ///< where it is stated
    std::optional<double> square = {};    ///< side of the reference square as drawn [m]
    int blocks = 0;                       ///< inserted
    int open_lines = 0;                   ///< on layers of contours, without those that begin at a contour (slits)
    std::vector<DrawingLayer> layers = {};
    std::vector<DrawingContour> contours = {};
    std::vector<DrawingIssue> issues = {};

    bool sound() const {
        return std::none_of(issues.begin(), issues.end(), [](const DrawingIssue& issue) { return issue.is_wrong; });
    }
};

}  // namespace ripstop
