#include "support/program.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "ripstop/io/mesh/obj.h"
#include "support/shapes.h"

namespace ripstop::testing {

namespace fs = std::filesystem;

const std::string& tested_program() {
    static const char* const other = std::getenv("RIPSTOP_TESTED_PROGRAM");
    static const std::string program = other == nullptr ? RIPSTOP_PROGRAM : other;
    return program;
}

ProgramRun Workshop::ripstop(const std::string& arguments) const {
    const std::string out = output_.path("out"), err = output_.path("err");
    const CommandResult result = run_command("cd '" + path("") + "' && '" + tested_program() + "' " + arguments +
                                             " >'" + out + "' 2>'" + err + "' </dev/null; echo $?");
    return {result.output.empty() ? -1 : std::stoi(result.output), content(out), content(err)};
}

void Workshop::write_tiles(const std::string& file, const std::vector<NamedMesh>& tiles, double scale) const {
    std::vector<NamedMesh> scaled_tiles = tiles;
    for (NamedMesh& tile : scaled_tiles) tile.mesh.positions *= scale;
    std::ofstream out(path(file), std::ios::binary);
    write_obj(out, scaled_tiles);
}

std::map<std::string, std::string> Workshop::files(const std::string& folder) const {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder)))
        if (entry.is_regular_file())
            result[fs::relative(entry.path(), path(folder)).string()] = content(entry.path().string());
    return result;
}

std::vector<std::string> Workshop::names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(path(""))) result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

NamedMesh flat_tile(const std::string& name) {
    return {name, rectangle(2, 1, 8, 4), {}};
}
NamedMesh curved_tile(const std::string& name) {
    return {name, lune(std::numbers::pi / 2, 6, 12), {}};
}
NamedMesh bent_tile(const std::string& name) {
    return {name, cylinder(1, 1.2, 1, 6, 5), {}};
}

}  // namespace ripstop::testing
