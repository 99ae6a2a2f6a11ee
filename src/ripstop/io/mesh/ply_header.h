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
    std::optional<PlyType> count = {};  ///< a list: how its length is written
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;  ///< as the header says: not to be trusted
    std::vector<PlyProperty> properties = {};
};

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyForm form = PlyForm::ascii;
    std::vector<PlyElement> elements = {};
    std::map<std::int64_t, std::string> names = {};  ///< of tiles, by their numbers
    std::optional<LengthUnit> unit = {};
    std::vector<std::string> remarks = {};
    std::size_t size = 0;  ///< where the body begins [bytes]
    long lines = 0;
};

/// The header of a PLY file, up to and with `end_header`. Throws InputError `NAME:LINE: …` for what is no header.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace ripstop
