#include "pattern_reader.h"
#include "ripstop/io/svg/svg_read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return ripstop::fuzzing::check_pattern_reader(ripstop::read_svg, data, size);
}
