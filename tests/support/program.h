#pragma once

#include <map>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "support/outside.h"

namespace ripstop::testing {

/// The program that the tests run: the built one, or that of the environment variable RIPSTOP_TESTED_PROGRAM.
const std::string& tested_program();

/// The result of a run of the built program.
struct ProgramRun {
    int code = -1;
    std::string out, err;  ///< stdout and stderr; neither is a terminal
};

/// Runs the built program in its own folder; file names in arguments are relative to it.
class Workshop {
  public:
    /// Runs the program; a shell reads `arguments`.
    ProgramRun ripstop(const std::string& arguments) const;

    /// Writes an OBJ with these tiles; `scale` is the number of its units per metre.
    void write_tiles(const std::string& file, const std::vector<NamedMesh>& tiles, double scale = 1) const;
    void write(const std::string& file, const std::string& text) const { write_text(path(file), text); }

    std::string path(const std::string& name) const { return scratch_.path(name); }
    std::string read(const std::string& file) const { return content(path(file)); }
    /// The files below `folder` with their contents, by their relative names.
    std::map<std::string, std::string> files(const std::string& folder) const;
    /// The entries of the workshop itself, sorted.
    std::vector<std::string> names() const;

  private:
    ScratchDirectory scratch_, output_{"output"};
};

NamedMesh flat_tile(const std::string& name = "plane");     ///< 2 m x 1 m along x and y
NamedMesh curved_tile(const std::string& name = "sphere");  ///< a 90 degree lune of the unit sphere: cannot be made
NamedMesh bent_tile(const std::string& name = "cylinder");  ///< 1.2 m x 1 m, developable

}  // namespace ripstop::testing
