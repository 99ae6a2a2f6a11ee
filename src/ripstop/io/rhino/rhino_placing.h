#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "ripstop/io/rhino/rhino_object.h"

namespace ripstop {

/// An object in the place where it is seen: as it stands, or as part of a block that is placed there.
struct RhinoPlaced {
    const RhinoObject* object;
    Eigen::Affine3d place;  ///< from the file's coordinates of the object to those of the model
    std::vector<const RhinoObject*> instances = {};  ///< the blocks it is part of, the outermost first
    std::string path = {};                           ///< their names: `Gore 3`, `Gore 3/crown`; empty without
    std::vector<Eigen::Affine3d> around = {};  ///< where each of them stands: what the blocks outside of it do to it
    /// The outermost of them that holds this surface alone and has a user text `tile`, and the names of those outside
    /// of it.
    const RhinoObject* named_by = nullptr;
    std::string named_in = {};
};

/// Blocks that cannot be followed, and why.
struct RhinoLostBlock {
    RhinoPlaced block;
    std::string reason;
};

struct RhinoPlacing {
    std::vector<RhinoPlaced> placed;
    std::vector<RhinoLostBlock> lost = {};
    std::map<std::string, int> on_hidden_layer = {};  ///< how many objects are left out, by the path of their layer
    int hidden = 0;                                   ///< objects left out that are hidden themselves
    int on_pages = 0;                                 ///< and that lie on a layout
    std::vector<std::string> unused_tile_texts =
        {};  ///< blocks with a name whose user text `tile` names none of several
};

/// Follows every block of the model to the objects it is made of. An instance is called by its name, else by its user
/// text `tile`, else by its definition with a number: `gore_01`, counted among those without a name beside it.
///
/// `tables` and `objects` must outlive the result. A block placed by no invertible affine map is lost. Throws
/// InputError for a block that holds itself, blocks more than 50 deep, and more placed objects than 1000 and a quarter
/// of the file's bytes.
RhinoPlacing place_rhino_objects(const RhinoTables& tables, const std::vector<RhinoObject>& objects,
                                 const RhinoArchive& archive);

/// What an object or an instance is called in messages: its kind and name, `Mesh "G01P01"`, else its id.
std::string rhino_called(const RhinoObject& object);

/// A number with leading zeros, as wide as the last one's: `03` of 12, `003` of 120.
std::string numbered(std::size_t number, std::size_t last);

}  // namespace ripstop
