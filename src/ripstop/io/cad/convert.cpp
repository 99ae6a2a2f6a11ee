#include "ripstop/io/cad/convert.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "ripstop/base/error.h"
#include "ripstop/base/system/child_process.h"
#include "ripstop/base/system/program_folder.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/input_file.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr std::array<CadFormat, 6> cad_format_table = {{{".step", "STEP"},
                                                        {".stp", "STEP"},
                                                        {".iges", "IGES"},
                                                        {".igs", "IGES"},
                                                        {".brep", "Open CASCADE BREP"},
                                                        {".brp", "Open CASCADE BREP"}}};

constexpr const char* say_where =
    "build it with gmsh and Open CASCADE (make setup, then make), or name it in RIPSTOP_CAD";

/// A temporary file without a name, which child processes can open too. The system deletes it when the last
/// process that has it open ends, even after a crash.
class Between {
  public:
    Between() {
        std::string pattern = (fs::temp_directory_path() / "ripstop-XXXXXX").string();
        descriptor_ = ::mkstemp(pattern.data());
        if (descriptor_ < 0) throw InputError(pattern + ": no file can be made there; is there room on the disk?");
        ::unlink(pattern.c_str());
    }
    ~Between() { ::close(descriptor_); }
    Between(const Between&) = delete;
    Between& operator=(const Between&) = delete;
    /// A path that this process and its children can open.
    fs::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_ = -1;
};

/// The first of `places` that exists; empty if none does.
fs::path first_file(const std::vector<fs::path>& places) {
    std::error_code unknown;
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, unknown)) return place;
    return {};
}

fs::path programs_folder(const MeshingOptions& options) {
    return options.programs.empty() ? program_folder() : options.programs;
}

fs::path find_mesher(const MeshingOptions& options) {
    if (!options.mesher.empty()) return options.mesher;
    return first_file({programs_folder(options) / "ripstop-cad"});
}

/// The data folder of an install prefix; a build folder has one beside the programs.
fs::path find_rhino_script(const MeshingOptions& options) {
    const fs::path programs = programs_folder(options), script = fs::path("rhino") / "convert.mjs";
    return first_file({programs / RIPSTOP_DATA_FROM_BIN / script, programs / "share/ripstop" / script});
}

/// The child's error message: the last line it wrote, without its own name and without the file names it was
/// given.
std::string reason_in(const std::string& complaints, const std::string& program,
                      const std::vector<std::string>& arguments) {
    const std::string_view text = std::string_view(complaints).substr(0, complaints.find_last_not_of("\r\n ") + 1);
    std::string_view line = text.substr(text.rfind('\n') + 1);
    if (line.starts_with(program)) line.remove_prefix(program.size());
    for (const std::string& argument : arguments)
        if (line.starts_with(argument + ": ")) line.remove_prefix(argument.size() + 2);
    return readable_name(line.substr(0, 400));
}

/// Parses the converters' progress lines: `progress 12 160 face` means face 12 of 160.
TakesLine progress_lines(const Progress& progress) {
    return [&progress](const std::string& line) {
        std::istringstream words(line);
        std::string first, what;
        double done = 0, all = 0;
        if (!(words >> first >> done >> all >> what) || first != "progress" || !(all > 0)) return false;
        if (progress) progress(done / all, what + " " + format_shortest(done) + " of " + format_shortest(all));
        return true;
    };
}

/// Runs a program to its end. `name` is what messages call it. Throws InputError if it fails.
void require_run(const std::vector<std::string>& arguments, const std::string& name, const fs::path& file,
                 const MeshingOptions& options) {
    const double timeout = options.timeout;
    const ChildEnd end = run_child(arguments, timeout, progress_lines(options.progress));
    const std::string begin = file.string() + ": ";
    switch (end.how) {
        case ChildEnd::How::not_started:
            throw InputError(begin + name + " (" + arguments[0] + ") cannot be started: " + std::strerror(end.code));
        case ChildEnd::How::timed_out:
            throw InputError(begin + name + " did not end within " + format_shortest(timeout) +
                             " s; ask for a coarser mesh with --chord or --edge, or mesh the surfaces in the CAD");
        case ChildEnd::How::killed:
            throw InputError(begin + name + " crashed on it (signal " + std::to_string(end.code) +
                             "); repair the surfaces in the CAD, or export them as meshes");
        case ChildEnd::How::exited:
            break;
    }
    if (end.code == 0) return;
    const std::string reason = reason_in(end.complaints, name + ": ", arguments);
    if (end.code == 3 && !reason.empty()) throw InputError(begin + reason);
    throw InputError(begin + name + " failed on it" + (reason.empty() ? "" : " (" + reason + ")") +
                     "; repair the surfaces in the CAD, or export them as meshes");
}

void run_mesher(const fs::path& mesher, const fs::path& input, const fs::path& output, const MeshingOptions& options,
                const fs::path& file) {
    const auto length = [](double metres) { return format_fixed(metres, 12) + "m"; };
    std::vector<std::string> arguments{mesher.string(), "--tolerance", length(options.sewing_tolerance)};
    if (options.chord_error) arguments.insert(arguments.end(), {"--chord", length(*options.chord_error)});
    if (options.edge_length) arguments.insert(arguments.end(), {"--edge", length(*options.edge_length)});
    if (options.metres_per_unit)
        arguments.insert(arguments.end(), {"--metres-per-unit", format_fixed(*options.metres_per_unit, 12)});
    arguments.insert(arguments.end(), {"--", fs::absolute(input).string(), output.string()});
    require_run(arguments, "ripstop-cad", file, options);
}

ConvertedModel answer(const fs::path& output, const fs::path& file, const std::string& program) {
    std::ifstream in(output, std::ios::binary);
    if (!in || in.peek() == std::ifstream::traits_type::eof())
        throw InputError(file.string() + ": " + program + " gave no answer; does it belong to this version?");
    return read_converted(in, file.string() + ": the answer of " + program);
}

}  // namespace

void require_sound(const MeshingOptions& options) {
    const auto require_positive = [](double length, const char* what) {
        if (!(length > 0 && length < 1e6))
            throw InputError(std::string(what) + " is " + format_shortest(length) + " m, expected a length above 0");
    };
    if (options.chord_error) require_positive(*options.chord_error, "--chord");
    if (options.edge_length) require_positive(*options.edge_length, "--edge");
    if (options.metres_per_unit) require_positive(*options.metres_per_unit, "the unit");
    require_positive(options.sewing_tolerance, "the sewing tolerance");
}

std::span<const CadFormat> cad_formats() {
    return cad_format_table;
}

CadModel convert_cad(const fs::path& file, const MeshingOptions& options) {
    require_sound(options);
    open_input(file);
    const fs::path mesher = find_mesher(options);
    if (mesher.empty())
        throw InputError(file.string() + ": the program ripstop-cad, which meshes CAD files, is not installed; " +
                         say_where);
    const Between meshes;
    run_mesher(mesher, file, meshes.path(), options, file);
    return as_surfaces(answer(meshes.path(), file, "ripstop-cad"), options.tiles, file.stem().string());
}

ConvertedModel convert_rhino(const fs::path& file, const MeshingOptions& options) {
    require_sound(options);
    open_input(file);
    const fs::path script = find_rhino_script(options);
    if (script.empty())
        throw InputError(file.string() +
                         ": the converter of Rhino's surfaces is not installed; run make setup, or mesh the "
                         "surfaces in Rhino (Mesh) and save again");
    const Between nurbs, meshes;
    require_run({"node", script.string(), fs::absolute(file).string(), nurbs.path().string()}, "rhino3dm", file,
                options);
    const fs::path mesher = find_mesher(options);
    if (!mesher.empty()) {
        run_mesher(mesher, nurbs.path(), meshes.path(), options, file);
        return answer(meshes.path(), file, "ripstop-cad");
    }
    ConvertedModel model = answer(nurbs.path(), file, "rhino3dm");
    double chord_error = 0;
    for (ConvertedObject& object : model.objects) {
        const std::size_t all = object.faces.size();
        std::erase_if(object.faces, [](const ConvertedFace& face) { return face.mesh.triangle_count() == 0; });
        for (const ConvertedFace& face : object.faces) chord_error = std::max(chord_error, face.chord_error);
        if (object.faces.size() < all)
            model.unread.push_back(
                {object.name, object.type,
                 std::to_string(all - object.faces.size()) + " of its " + std::to_string(all) +
                     " faces have no mesh stored with them; save in a shaded view or mesh them in Rhino "
                     "(Mesh), or install ripstop-cad",
                 object.attributes});
    }
    if (!model.objects.empty())
        model.remarks.push_back("the surfaces are the meshes that Rhino stored for display, off by up to about " +
                                format_fixed(chord_error * model.unit.value_or(LengthUnit{}).metres / millimetre, 2) +
                                " mm; install ripstop-cad to mesh them more finely");
    return model;
}

}  // namespace ripstop
