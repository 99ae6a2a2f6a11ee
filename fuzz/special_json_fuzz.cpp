#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "require.h"
#include "ripstop/base/error.h"
#include "ripstop/io/json/special_json.h"

using namespace ripstop;
using fuzzing::require;

/// Any bytes give a special shape whose lengths and counts can be meshed, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    SpecialShape shape;
    try {
        shape = read_special_shape(in, "fuzz.json");
    } catch (const InputError&) {
        return 0;
    }
    require(shape.edge_length > 0 && shape.joint_radius >= 0);
    require(!shape.mouth || std::isfinite(*shape.mouth));
    require(!shape.primitives.empty());
    for (const SpecialPrimitive& primitive : shape.primitives) {
        require(!primitive.name.empty() && primitive.centre.allFinite() && primitive.axis.norm() > 0);
        require(primitive.smallest_radius() > 0 && primitive.sectors >= 1 && primitive.rings >= 1);
    }
    return 0;
}
