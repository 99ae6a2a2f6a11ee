#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <set>
#include <string>

#include "drawing.h"

/// What a STEP file states besides its shapes.
namespace ripstop::cad {

/// Removes the entries of a kind that the kernel does not know from every list of the model. The kernel leaves a
/// null entry there, on which its reader with names crashes. A remark says how many there are, and of which kinds.
void close_holes(const Interface_InterfaceModel& model, Drawing& drawing);

/// Lists the parts that are in other files of `folder` (document references of AP203 and AP214) if these files are
/// missing or `reader` did not read them; all of them, without a reader with names. `seen` holds the files that
/// were already requested.
void name_missing_parts(const Handle(XSControl_WorkSession) & session, const STEPCAFControl_Reader* reader,
                        const std::filesystem::path& folder, std::set<std::string>& seen, Drawing& drawing);

/// Throws InputError if a point is so far off that processing its shape may take for ever.
void require_points(const Interface_InterfaceModel& model, const std::string& file);

}  // namespace ripstop::cad
