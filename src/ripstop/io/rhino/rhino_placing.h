#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "ripstop/io/rhino/rhino_object.h"

namespace ripstop {

/// An object where it is seen: on its own, or as part of a placed block.
struct RhinoPlaced {
    const RhinoObject* object;
    Eigen::Affine3d place;  ///< from the object's coordinates in the file to those of the model
    std::vector<const RhinoObject*> instances = {};  ///< the blocks around it, outermost first
    std::string path = {};                           ///< their names: `Gore 3`, `Gore 3/crown`; empty if there are none
    std::vector<Eigen::Affine3d> around = {};        ///< the placement of each block by the blocks outside of it
    /// The outermost instance that holds only this surface and has a user text `tile`, and the names of the
    /// instances around it.
    const RhinoObject* named_by = nullptr;
    std::string named_in = {};
};

/// A block that cannot be resolved, and why.
struct RhinoLostBlock {
    RhinoPlaced block;
    std::string reason;
};

struct RhinoPlacing {
    std::vector<RhinoPlaced> placed;
    std::vector<RhinoLostBlock> lost = {};
    std::map<std::string, int> on_hidden_layer = {};  ///< number of objects left out, by the path of their layer
    int hidden = 0;                                   ///< number of objects left out because they are hidden themselves
    int on_pages = 0;                                 ///< number of objects left out because they are on a layout
    std::vector<std::string> unused_tile_texts =
        {};  ///< named blocks that hold several surfaces, so that their user text `tile` names none of them
};

/// Resolves every block of the model to its objects. An instance is called by its name, else by its user text
/// `tile`, else by its definition with a number, `gore_01`, that counts the nameless instances of its level.
///
/// `tables` and `objects` must outlive the result. A block whose transformation is not affine and invertible is
/// lost. Throws InputError for a block that contains itself, for blocks nested more than 50 deep, and for more
/// placed objects than 1000 plus a quarter of the file's bytes.
RhinoPlacing place_rhino_objects(const RhinoTables& tables, const std::vector<RhinoObject>& objects,
                                 const RhinoArchive& archive);

/// What messages call an object or an instance: its type and name, `Mesh "G01P01"`, or its id if it has no name.
std::string rhino_called(const RhinoObject& object);

}  // namespace ripstop
