/// Measures reading a million triangles in each format; look at the processor time.
#include <benchmark/benchmark.h>

#include <sstream>

#include "ripstop/io/mesh/binary.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

void read_all(benchmark::State& state, const MeshFormat& format, const std::string& bytes) {
    int triangles = 0;
    for (auto _ : state) {
        std::istringstream in(bytes);
        const CadModel model = format.read(in, "large");
        triangles = model.surfaces.at(0).mesh.triangle_count();
    }
    state.counters["triangles"] = triangles;
    state.counters["MB"] = static_cast<double>(bytes.size()) / 1e6;
}

std::string binary_stl(const TriangleMesh& mesh) {
    std::string bytes(80, ' ');
    append_little_endian<std::uint32_t>(bytes, static_cast<std::uint32_t>(mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        bytes.append(12, '\0');
        for (int k = 0; k < 3; ++k)
            for (const double x : mesh.corner(t, k)) append_little_endian<float>(bytes, static_cast<float>(x));
        bytes.append(2, '\0');
    }
    return bytes;
}

[[maybe_unused]] const bool registered = [] {
    for (const MeshFormat& format : mesh_formats()) {
        if (format.write == nullptr) continue;
        const auto add = [&format](const std::string& name, bool binary) {
            benchmark::RegisterBenchmark(name.c_str(),
                                         [&format, binary](benchmark::State& state) {
                                             const TriangleMesh mesh = testing::saddle(1, 3, 708);
                                             std::ostringstream out;
                                             if (!binary) format.write(out, {{"large", mesh}});
                                             read_all(state, format, binary ? binary_stl(mesh) : out.str());
                                         })
                ->Unit(benchmark::kSecond)
                ->Iterations(1);
        };
        add(std::string("read a million triangles/") + format.extension, false);
        if (std::string_view(format.extension) == ".stl") add("read a million triangles/.stl binary", true);
    }
    return true;
}();

}  // namespace
}  // namespace ripstop
