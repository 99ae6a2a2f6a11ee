#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/base/text/units.h"

namespace ripstop {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);  ///< in a binary file [bytes]

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count = {};  ///< the type of a list's length; empty if it is not a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;  ///< as the header states it; do not trust it
    std::vector<PlyProperty> properties = {};
};

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyForm form = PlyForm::ascii;
    std::vector<PlyElement> elements = {};
    std::map<std::int64_t, std::string> names = {};  ///< names of tiles, by number
    std::optional<LengthUnit> unit = {};
    std::vector<std::string> remarks = {};
    std::size_t size = 0;  ///< offset of the body [bytes]
    long lines = 0;
};

/// Parses the header of a PLY file, up to and including `end_header`. Throws InputError `NAME:LINE: …` if it is
/// malformed.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace ripstop
