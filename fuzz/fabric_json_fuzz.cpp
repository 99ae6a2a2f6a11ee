#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"

using namespace ripstop;

/// Any bytes give a valid fabric or an InputError. A valid fabric stays valid when written and read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    Fabric fabric;
    try {
        fabric = read_fabric(in, "fuzz.json");
    } catch (const InputError&) {
        return 0;
    }
    require_valid(fabric, "fuzz.json");
    std::istringstream written(write_fabric(fabric));
    if (read_fabric(written, "written.json").name != fabric.name) std::abort();
    return 0;
}
