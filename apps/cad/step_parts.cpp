#include "step_parts.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_Representation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop::cad {
namespace {

/// Returns the number of holes.
int close_holes_in(StepRepr_Representation& representation) {
    const Handle(StepRepr_HArray1OfRepresentationItem) items = representation.Items();
    std::vector<Handle(StepRepr_RepresentationItem)> kept;
    for (int i = 1; i <= representation.NbItems(); ++i)
        if (!items->Value(i).IsNull()) kept.push_back(items->Value(i));
    const int holes = representation.NbItems() - static_cast<int>(kept.size());
    if (holes == 0) return 0;
    Handle(StepRepr_HArray1OfRepresentationItem) closed;
    if (!kept.empty()) closed = new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i) closed->SetValue(static_cast<int>(i) + 1, kept[i]);
    representation.SetItems(closed);
    return holes;
}

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
    return text.IsNull() ? "" : text->ToCString();
}

std::string product_of(const Handle(StepBasic_ProductDefinition) & definition) {
    if (definition.IsNull() || definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull())
        return "";
    const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
    const std::string name = text_of(product->Name());
    return name.empty() ? text_of(product->Id()) : name;
}

}  // namespace

void close_holes(const Interface_InterfaceModel& model, Drawing& drawing) {
    int holes = 0;
    std::map<std::string, int> unknown;
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const Handle(Standard_Transient) entity = model.Value(i);
        if (const auto representation = Handle(StepRepr_Representation)::DownCast(entity); !representation.IsNull())
            holes += close_holes_in(*representation);
        if (const auto other = Handle(StepData_UndefinedEntity)::DownCast(entity); !other.IsNull() && !other->IsSub())
            ++unknown[other->StepType()];
    }
    if (holes == 0) return;
    std::string kinds;
    for (const auto& [kind, count] : unknown)
        kinds += (kinds.empty() ? " (" : ", ") + std::to_string(count) + " " + kind;
    drawing.rest.remarks.push_back((holes == 1 ? "1 item" : std::to_string(holes) + " items") +
                                   " other than shapes left out, of types that Open CASCADE does not know" + kinds +
                                   (kinds.empty() ? "" : ")"));
}

void name_missing_parts(const Handle(XSControl_WorkSession) & session, const STEPCAFControl_Reader* reader,
                        const std::filesystem::path& folder, std::set<std::string>& seen, Drawing& drawing) {
    STEPConstruct_ExternRefs references(session);
    if (!references.LoadExternRefs()) return;
    for (int i = 1; i <= references.NbExternRefs(); ++i) {
        const std::string other = references.FileName(i) == nullptr ? "" : references.FileName(i);
        if (other.empty() || !seen.insert(other).second) continue;
        Handle(STEPCAFControl_ExternFile) read;
        if (reader != nullptr && reader->ExternFile(other.c_str(), read) && read->GetTransferStatus()) {
            name_missing_parts(read->GetWS(), reader, folder, seen, drawing);
            continue;
        }
        std::error_code unknown;
        const bool is_there = std::filesystem::exists(folder / other, unknown);
        const std::string product = product_of(references.ProdDef(i));
        drawing.rest.unread.push_back(
            {product.empty() ? other : product,
             "Part in another file",
             "it lies in the file " + other +
                 (is_there ? ", which could not be read; read that file by itself, or export all parts into one file"
                           : ", which is not beside this one; put it there, or export all parts into one file"),
             {}});
    }
}

void require_points(const Interface_InterfaceModel& model, const std::string& file) {
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const Handle(StepGeom_CartesianPoint) point = Handle(StepGeom_CartesianPoint)::DownCast(model.Value(i));
        for (int k = 1; !point.IsNull() && k <= point->NbCoordinates(); ++k)
            if (!(std::abs(point->CoordinatesValue(k)) < largest_coordinate))
                throw InputError(unbearable(file + ": " + model.StringLabel(point)->ToCString(),
                                            format_shortest(point->CoordinatesValue(k))));
    }
}

}  // namespace ripstop::cad
