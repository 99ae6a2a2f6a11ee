#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "ripstop/base/error.h"
#include "ripstop/io/cad/converted.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const ripstop::ConvertedModel model = ripstop::read_converted(in, "fuzz.converted");
        for (const auto tiles : {ripstop::TilesAs::faces, ripstop::TilesAs::objects})
            ripstop::as_surfaces(model, tiles, "fuzz");
    } catch (const ripstop::InputError&) {
    }
    return 0;
}
