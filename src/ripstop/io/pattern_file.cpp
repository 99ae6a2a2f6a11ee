#include "ripstop/io/pattern_file.h"

#include "ripstop/base/error.h"
#include "ripstop/base/text/lower_case.h"
#include "ripstop/io/dxf/dxf_read.h"
#include "ripstop/io/svg/svg_read.h"
#include "ripstop/io/text/input_file.h"

namespace ripstop {

PatternDrawing read_pattern_file(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().string());
    if (std::error_code unknown; std::filesystem::is_directory(path, unknown))
        throw InputError(path.string() + ": is a folder, expected a file; name the file in it");
    if (extension != ".dxf" && extension != ".svg")
        throw InputError(path.string() + ": not a pattern file, expected .dxf or .svg; export it as one");
    std::ifstream in = open_input(path);
    return extension == ".dxf" ? read_dxf(in, path.string()) : read_svg(in, path.string());
}

}  // namespace ripstop
