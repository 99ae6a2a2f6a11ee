#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/targets.h"

/// `fuzz-replay TARGET FOLDER` runs a fuzz target over every file of a folder, so that its corpus also guards builds
/// without libFuzzer. Fails if the folder has no files. The target itself ends the program if its property is violated.
int main(int count, char** arguments) {
    if (count != 3) return 2;
    const auto* const target = std::ranges::find(fuzz_targets, std::string_view(arguments[1]), &FuzzTarget::name);
    if (target == std::end(fuzz_targets)) return 2;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[2])) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        std::cout << file.filename().string() << std::endl;
        std::ifstream in(file, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        target->run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    return files.empty() ? 1 : 0;
}
