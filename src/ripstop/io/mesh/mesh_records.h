#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A corner of a face: indices from 0 into the file's vertices and its texture coordinates.
struct RecordedCorner {
    int vertex;
    int texture;  ///< -1: none
};

struct RecordedFace {
    std::size_t first;  ///< of its corners
    int count;
    int surface;
    int material;  ///< -1: none
    long place;    ///< its line, or its byte in a binary file
};

/// What a mesh file says, before any surface is made of it. Lengths in its own unit.
struct MeshRecords {
    std::string name;     ///< of the file; begins every message
    std::string stem;     ///< names surfaces without a name of their own
    bool binary = false;  ///< places are bytes, not lines
    int first_index = 0;  ///< what the file calls its first vertex
    std::vector<Vec3> vertices = {};
    std::vector<Vec2> textures = {};
    std::vector<RecordedCorner> corners = {};
    std::vector<RecordedFace> faces = {};
    std::vector<Vec3> warps = {};  ///< of each face, zero: not given; or empty
    std::vector<std::string> surfaces = {};
    std::vector<std::string> materials = {};
    bool apart = false;             ///< whether each connected part of a surface is one of its own
    bool single_precision = false;  ///< how coordinates are stored
    std::vector<std::string> remarks = {};

    /// `NAME:LINE: `, or `NAME: byte N: ` of a binary file.
    std::string at(long place) const;
    /// Throws InputError `NAME:LINE: what`, or `NAME: byte N: what` of a binary file.
    [[noreturn]] void refuse(long place, const std::string& what) const;
    /// The same for an index of which there is no vertex, as the file writes it.
    [[noreturn]] void refuse_index(long place, long given, std::size_t count, const char* what = "vertex") const;

    /// The finite number below 1e12 that a word spells, or that stands in a binary file. Throws InputError.
    double coordinate(std::string_view word, long place) const;
    double coordinate(double value, long place) const;
};

/// Adds the surfaces of a file to a model, with its remarks: each with the vertices its faces use, in the file's order;
/// nothing is welded. The faces of one `surface` make one, or, where the file has its parts `apart`, each connected
/// part of them: `NAME` where there is one, else `NAME_01`, `NAME_02`, … but for names that are taken. Surfaces come in
/// the order of their numbers, parts of their first faces. Polygons are fanned (`fan_corner`). `drawn` is filled where
/// every corner has a texture coordinate and each vertex one alone; `warp` where the faces have one; the attribute
/// `material` where all faces of a surface have the same.
///
/// A face may name a corner several times in a row, as exporters write a triangle as a quad, and go back the way it
/// came; what is left of it counts. Faces with fewer than three different corners are left out, with a remark. A
/// polygon that cannot be fanned, since it folds or comes by a corner twice, is the `fault` of its surface alone.
///
/// Throws InputError for an index beyond the vertices, for a warp on some faces of a surface only, and where there is
/// no face. Linear in time and memory.
void make_surfaces(MeshRecords records, CadModel& model);

/// The file's name without folder and without `extension` (with its dot, in lower case).
std::string stem_of(const std::string& name, std::string_view extension);

}  // namespace ripstop
