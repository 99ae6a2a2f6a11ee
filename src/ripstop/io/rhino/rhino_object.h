#pragma once

#include <string>
#include <vector>

#include "ripstop/io/rhino/rhino_tables.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// An object of an archive and what the designer said about it.
struct RhinoObject {
    std::uint32_t type = 0;  ///< openNURBS's bit for the object's type: `rhino_type_name`
    RhinoClass geometry;
    RhinoId id{};
    std::string name = {};
    int layer = 0;  ///< the `index` of its RhinoLayer
    std::vector<int> groups = {};
    bool hidden = false;
    bool in_definition = false;  ///< whether it is part of a block definition and no object of the model
    bool on_page = false;        ///< whether it is on a layout and not in the model
    Attributes text = {};        ///< user text of the object's attributes, then of its geometry; the former wins
};

RhinoObject read_rhino_object(RhinoBytes record);

/// `Brep`, `SubD`, `Point`, …; `Object` for an unknown type.
std::string rhino_type_name(std::uint32_t type);

inline constexpr std::uint32_t rhino_point_cloud = 0x2, rhino_curve = 0x4, rhino_surface = 0x8, rhino_brep = 0x10,
                               rhino_subd = 0x40000, rhino_extrusion = 0x40000000;

inline constexpr RhinoId rhino_mesh_class = rhino_id("4ED7D4E4-E947-11d3-BFE5-0010830122F0");
inline constexpr RhinoId rhino_reference_class = rhino_id("F9CFB638-B9D4-4340-87E3-C56E7865D96A");

}  // namespace ripstop
