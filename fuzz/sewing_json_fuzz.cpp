/// flat/sewing.json: any bytes are read, or refused with a sentence.
#include <cstdint>
#include <sstream>
#include <string>

#include "ripstop/base/error.h"
#include "ripstop/io/json/sewing_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    try {
        ripstop::read_sewing(in, "fuzz");
    } catch (const ripstop::InputError&) {
    }
    return 0;
}
