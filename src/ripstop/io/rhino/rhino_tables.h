#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/io/rhino/rhino_archive.h"

namespace ripstop {

struct RhinoLayer {
    int index = 0;  ///< by which objects name it
    RhinoId id{}, parent{};
    std::string name;
    std::string path;     ///< with the layers above: `a::b`
    bool visible = true;  ///< it and every layer above
};

/// What a block is made of.
struct RhinoDefinition {
    RhinoId id{};
    std::string name;
    std::vector<RhinoId> objects;
    bool linked = false;  ///< to another file: the objects are not in this one
};

/// An instance of a class as it stands in an archive: its data, and what others hung on to it, by class.
struct RhinoClass {
    RhinoId id{};
    RhinoBytes data;
    std::map<RhinoId, RhinoBytes> user_data = {};
};

/// The tables of an archive, in the file's order.
struct RhinoTables {
    std::optional<LengthUnit> unit = {};  ///< none where the file says none
    std::vector<RhinoLayer> layers = {};
    std::map<int, std::string> groups = {};
    std::vector<RhinoDefinition> definitions = {};
    std::vector<RhinoBytes> objects = {};  ///< one record each
    unsigned writer = 0;                   ///< the version of openNURBS that wrote the file; 0: not said
};

/// Walks an archive of Rhino 2 to 8. Throws InputError where it is cut short or damaged.
RhinoTables read_rhino_tables(const RhinoArchive& archive);

/// The next class in `bytes`, and the user data in what follows a class or an object's attributes.
RhinoClass read_rhino_class(RhinoBytes& bytes);
void read_rhino_user_data(RhinoBytes bytes, std::map<RhinoId, RhinoBytes>& user_data);

}  // namespace ripstop
