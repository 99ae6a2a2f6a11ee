#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <set>
#include <string>

#include "drawing.h"

/// What a STEP file says besides its shapes.
namespace ripstop::cad {

/// Takes from every list of the model what is of a kind the kernel does not know: it left a hole there, on which its
/// reader
/// with names breaks down. A remark says how many, and of which kinds the file holds such.
void close_holes(const Interface_InterfaceModel& model, Drawing& drawing);

/// Names the parts that lie in other files of `folder` (document references of AP203 and AP214) where these are not
/// there or
/// were not read by `reader`; without a reader with names, all of them. `seen`: the files that were asked for before.
void name_missing_parts(const Handle(XSControl_WorkSession) & session, const STEPCAFControl_Reader* reader,
                        const std::filesystem::path& folder, std::set<std::string>& seen, Drawing& drawing);

/// Throws InputError where a point lies so far off that shapes of it may take for ever.
void require_points(const Interface_InterfaceModel& model, const std::string& file);

}  // namespace ripstop::cad
