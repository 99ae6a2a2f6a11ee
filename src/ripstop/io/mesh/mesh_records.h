#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A corner of a face, as indices from 0 into the file's vertices and texture coordinates.
struct RecordedCorner {
    int vertex;
    int texture;  ///< -1: none
};

struct RecordedFace {
    std::size_t first;  ///< index of its first corner
    int count;
    int surface;
    int material;  ///< -1: none
    long place;    ///< its line number, or its byte offset in a binary file
};

/// The records of a mesh file, before surfaces are made. Lengths are in the file's own unit.
struct MeshRecords {
    std::string name;     ///< of the file; every message begins with it
    std::string stem;     ///< names surfaces that have no name
    bool binary = false;  ///< whether places are byte offsets instead of line numbers
    int first_index = 0;  ///< the index that the file gives its first vertex
    std::vector<Vec3> vertices = {};
    std::vector<Vec2> textures = {};
    std::vector<RecordedCorner> corners = {};
    std::vector<RecordedFace> faces = {};
    std::vector<Vec3> warps = {};  ///< one for each face, zero if the face has none; or empty
    std::vector<std::string> surfaces = {};
    std::vector<std::string> materials = {};
    bool apart = false;             ///< whether each connected part becomes its own surface
    bool single_precision = false;  ///< whether the file stores coordinates in single precision
    std::vector<std::string> remarks = {};

    /// `NAME:LINE: `, or `NAME: byte N: ` for a binary file.
    std::string at(long place) const;
    /// Throws InputError `NAME:LINE: what`, or `NAME: byte N: what` for a binary file.
    [[noreturn]] void refuse(long place, const std::string& what) const;
    /// Throws InputError for an index without a vertex. `given` is the index as the file writes it.
    [[noreturn]] void refuse_index(long place, long given, std::size_t count, const char* what = "vertex") const;

    /// The number that a word spells or a binary file holds. Throws InputError unless it is finite and below 1e12.
    double coordinate(std::string_view word, long place) const;
    double coordinate(double value, long place) const;
};

/// Adds the surfaces of a file, and its remarks, to a model. A surface has the vertices its faces use, in the
/// file's order; nothing is welded.
///
/// The faces with one `surface` number form one surface. If the file keeps its parts `apart`, each connected part
/// forms one: `NAME` if there is only one part, else `NAME_01`, `NAME_02`, …, skipping names that are taken.
/// Surfaces are ordered by their numbers, and parts by their first faces.
///
/// Polygons are fanned (`fan_corner`). `drawn` is set if every corner has a texture coordinate and each vertex has
/// only one. `warp` is set if the faces have one. The attribute `material` is set if all faces of a surface have
/// the same.
///
/// A face may repeat a corner, as exporters do to write a triangle as a quad, and may run back along itself; both
/// are removed. Faces with fewer than three different corners are left out with a remark. A polygon that cannot be
/// fanned, because it folds or visits a corner twice, becomes the `fault` of its surface and does not affect the
/// others.
///
/// Throws InputError for an index beyond the vertices, for a surface of which only some faces have a warp, and for
/// a file without faces. Linear in time and memory.
void make_surfaces(MeshRecords records, CadModel& model);

/// The file's name without its folder and without `extension` (in lower case, with its dot).
std::string stem_of(const std::string& name, std::string_view extension);

}  // namespace ripstop
