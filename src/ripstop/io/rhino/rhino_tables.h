#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/io/rhino/rhino_archive.h"

namespace ripstop {

struct RhinoLayer {
    int index = 0;  ///< how objects refer to it
    RhinoId id{}, parent{};
    std::string name;
    std::string path;     ///< its ancestors and its name: `a::b`
    bool visible = true;  ///< whether it and every ancestor are visible
};

/// The contents of a block.
struct RhinoDefinition {
    RhinoId id{};
    std::string name;
    std::vector<RhinoId> objects;
    bool linked = false;  ///< whether it refers to another file, so that this one lacks the objects
};

/// An instance of a class in an archive: its data, and the user data attached to it, by class.
struct RhinoClass {
    RhinoId id{};
    RhinoBytes data;
    std::map<RhinoId, RhinoBytes> user_data = {};
};

/// The tables of an archive, each in the file's order.
struct RhinoTables {
    std::optional<LengthUnit> unit = {};  ///< empty if the file states none
    std::vector<RhinoLayer> layers = {};
    std::map<int, std::string> groups = {};
    std::vector<RhinoDefinition> definitions = {};
    std::vector<RhinoBytes> objects = {};  ///< one record for each object
    unsigned writer = 0;                   ///< version of openNURBS that wrote the file; 0: not stated
};

/// Reads the tables of an archive of Rhino 2 to 8. Throws InputError if it is cut short or damaged.
RhinoTables read_rhino_tables(const RhinoArchive& archive);

/// Reads the next class in `bytes`, and the user data that follows a class or an object's attributes.
RhinoClass read_rhino_class(RhinoBytes& bytes);
void read_rhino_user_data(RhinoBytes bytes, std::map<RhinoId, RhinoBytes>& user_data);

}  // namespace ripstop
