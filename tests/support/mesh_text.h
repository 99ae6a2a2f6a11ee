#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/binary.h"
#include "ripstop/model/tile/cad_model.h"
#include "support/refusal.h"

namespace ripstop::testing {

using MeshReader = CadModel (*)(std::istream& in, const std::string& name);

inline CadModel read_bytes_with(MeshReader read, const std::string& bytes, const std::string& name) {
    std::istringstream in(bytes);
    return read(in, name);
}

/// The message with which a reader refuses the bytes.
inline std::string refusal_of(MeshReader read, const std::string& bytes, const std::string& name) {
    return refusal([&] { read_bytes_with(read, bytes, name); });
}

inline std::vector<std::string> names_of(const std::vector<NamedMesh>& surfaces) {
    std::vector<std::string> names;
    for (const NamedMesh& surface : surfaces) names.push_back(surface.name);
    return names;
}

inline std::vector<int> corners_of(const NamedMesh& surface) {
    return {surface.mesh.triangles.data(), surface.mesh.triangles.data() + surface.mesh.triangles.size()};
}

/// The bytes of numbers of one type, least significant first, or last if `big`.
template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers, bool big = false) {
    std::string bytes;
    for (const Number number : numbers) {
        append_little_endian<Number>(bytes, number);
        if (big) std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(sizeof(Number)), bytes.end());
    }
    return bytes;
}

}  // namespace ripstop::testing
