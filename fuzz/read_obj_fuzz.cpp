#include "mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return ripstop::fuzzing::check_reader(".obj", data, size);
}
