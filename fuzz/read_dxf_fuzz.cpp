#include "pattern_reader.h"
#include "ripstop/io/dxf/dxf_read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return ripstop::fuzzing::check_pattern_reader(ripstop::read_dxf, data, size);
}
