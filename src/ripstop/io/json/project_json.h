#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/project/project.h"

namespace ripstop {

/// Reads a project from JSON: docs/project.md explains it, docs/project.schema.json describes it,
/// docs/project.example.json shows every key. All keys are optional except a tile's `name` and what makes a seam
/// type or rule meaningful.
///
/// `unit` is the unit of the points of `flight`, if the file's unit is known; else the project's unit, else
/// metres.
///
/// Throws InputError with the file and the place in it for an unknown key, a value of the wrong type, an unknown
/// unit, seam type or issue code, a tolerance that is not positive, a warp without direction, a compensation
/// outside -50 to 100 %, an allowance outside 0 to 1 m, a surface that is named twice or by a pattern, and a
/// duplicate name.
Project read_project(std::istream& in, const std::string& name, const std::string& unit = "");

}  // namespace ripstop
