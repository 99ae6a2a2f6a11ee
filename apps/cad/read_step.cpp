#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_Face.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>

#include "drawing.h"
#include "ripstop/base/error.h"
#include "step_parts.h"

namespace ripstop::cad {
namespace {

constexpr int deepest_assembly = 64;
constexpr const char* without_names =
    "Open CASCADE crashes on this file when it reads names, so the file was read without names, layers and colours";

std::string utf8(const TCollection_ExtendedString& text) {
    std::string bytes(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
    char* data = bytes.data();
    text.ToUTF8CString(data);
    bytes.resize(bytes.find('\0'));
    return bytes;
}

/// IGES pads its short names with blanks.
std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::string name_of(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
    const std::string text = trimmed(utf8(name->Get()));
    return text == "NONE" ? "" : text;  // STEP writes a missing name this way
}

/// Walks the contents of a document: from assemblies to products, and from each product to its solids, shells and
/// free faces.
class Walk {
  public:
    Walk(const Handle(TDocStd_Document) & document, Drawing& drawing)
        : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
          colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
          layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())),
          drawing_(drawing) {
        TDF_LabelSequence labels;
        layers_->GetLayerLabels(labels);
        for (const TDF_Label& label : labels) {
            TCollection_ExtendedString layer;
            if (layers_->GetLayer(label, layer)) drawing_.rest.layers.push_back(utf8(layer));
        }
        shapes_->GetFreeShapes(labels);
        for (const TDF_Label& label : labels) visit(label, {}, "", {}, 0);
    }

  private:
    void visit(const TDF_Label& label, const TopLoc_Location& place, const std::string& name, Attributes attributes,
               int depth) {
        if (depth > deepest_assembly) throw InputError("assemblies nested deeper than 64; is one part of itself?");
        add(attributes, label, shapes_->GetShape(label));
        TDF_Label product;
        if (shapes_->GetReferredShape(label, product)) {
            const std::string own = name_of(product);
            visit(product, place * shapes_->GetLocation(label), own.empty() ? name_of(label) : own, attributes,
                  depth + 1);
            return;
        }
        if (shapes_->IsAssembly(label)) {
            TDF_LabelSequence components;
            shapes_->GetComponents(label, components);
            for (const TDF_Label& component : components) visit(component, place, "", attributes, depth + 1);
            return;
        }
        add_product(label, place, name.empty() ? name_of(label) : name, attributes);
    }

    void add_product(const TDF_Label& label, const TopLoc_Location& place, const std::string& name,
                     const Attributes& attributes) {
        const TopoDS_Shape shape = shapes_->GetShape(label);
        if (shape.IsNull()) return;
        require_coordinates(shape, name.empty() ? "a shape without a name" : name);
        const std::vector<Part> parts = parts_of(shape);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            DrawnObject object{name, parts[i].type, attributes};
            if (parts.size() > 1) {
                TDF_Label own;
                shapes_->FindSubShape(label, parts[i].shape, own);
                object.name = name_of(own);
                if (object.name.empty() && !name.empty())
                    object.name = name + (i < 9 ? "_0" : "_") + std::to_string(i + 1);
                add(object.attributes, own, parts[i].shape);
            }
            for (const TopoDS_Face& face : faces_of(parts[i].shape)) object.faces.push_back(drawn(label, face, place));
            drawing_.objects.push_back(std::move(object));
        }
        if (parts.empty()) add_wires(shape.Moved(place), name, attributes, drawing_);
    }

    DrawnFace drawn(const TDF_Label& product, const TopoDS_Face& face, const TopLoc_Location& place) {
        DrawnFace result{.shape = TopoDS_Face(face)};
        result.shape.Move(place);
        TDF_Label own;
        if (shapes_->FindSubShape(product, face, own)) result.name = name_of(own);
        add(result.attributes, own, face);
        return result;
    }

    void add(Attributes& attributes, const TDF_Label& label, const TopoDS_Shape& shape) {
        Handle(TColStd_HSequenceOfExtendedString) names = new TColStd_HSequenceOfExtendedString;
        if (((!label.IsNull() && layers_->GetLayers(label, names)) || layers_->GetLayers(shape, names)) &&
            !names->IsEmpty())
            attributes["layer"] = utf8(names->First());
        Quantity_Color colour;
        if (colours_->GetColor(shape, XCAFDoc_ColorSurf, colour) || colours_->GetColor(shape, XCAFDoc_ColorGen, colour))
            attributes["colour"] = Quantity_Color::ColorToHex(colour).ToCString();
    }

    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    Handle(XCAFDoc_LayerTool) layers_;
    Drawing& drawing_;
};

Handle(TDocStd_Document) new_document() {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    return document;
}

/// The unit with this name in STEP. For other names, the numbers stay in the kernel's millimetres.
LengthUnit unit_called(std::string name, Drawing& drawing) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    if (name == "INCH" || name == "IN") return {"in", 0.0254};
    if (name == "FOOT" || name == "FT" || name == "FEET") return {"ft", 0.3048};
    if (name == "METRE" || name == "METER" || name == "M") return {"m", 1};
    if (name == "CENTIMETRE" || name == "CENTIMETER" || name == "CM") return {"cm", 0.01};
    if (name != "MILLIMETRE" && name != "MILLIMETER" && name != "MM")
        drawing.rest.remarks.push_back("the file's unit is " + name + "; its numbers were converted to mm");
    return {"mm", 0.001};
}

void set_unit(Drawing& drawing, const LengthUnit& unit) {
    drawing.rest.unit = unit;
    drawing.millimetres = unit.metres / 0.001;
}

void take_step_unit(STEPControl_Reader& reader, Drawing& drawing) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    if (lengths.IsEmpty()) return;
    set_unit(drawing, unit_called(lengths.First().ToCString(), drawing));
    for (const TCollection_AsciiString& other : lengths)
        if (other != lengths.First()) {
            drawing.rest.remarks.push_back("the file's parts have several units; all were converted to " +
                                           drawing.rest.unit->name);
            break;
        }
}

/// Lists what the kernel could not turn into a shape.
void add_failures(const Handle(XSControl_WorkSession) & session, Drawing& drawing, bool roots_only) {
    const Handle(Interface_InterfaceModel) model = session->Model();
    const Handle(Transfer_TransientProcess) done = session->TransferReader()->TransientProcess();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(Standard_Transient) entity = model->Value(i);
        const Handle(StepShape_Face) face = Handle(StepShape_Face)::DownCast(entity);
        const Handle(IGESData_IGESEntity) iges = Handle(IGESData_IGESEntity)::DownCast(entity);
        const bool surface = !iges.IsNull() && (iges->TypeNumber() == 144 || iges->TypeNumber() == 143 ||
                                                iges->TypeNumber() == 510 || iges->TypeNumber() == 186);
        if ((roots_only && !surface) || (!roots_only && face.IsNull())) continue;
        const Handle(Transfer_Binder) binder = done->Find(entity);
        if (!binder.IsNull() && !TransferBRep::ShapeResult(binder).IsNull()) continue;
        const std::string place = model->StringLabel(entity)->ToCString();
        std::string name = !face.IsNull() && !face->Name().IsNull() ? face->Name()->ToCString() : "";
        if (!iges.IsNull() && iges->HasShortLabel()) name = trimmed(iges->NameValue()->ToCString());
        drawing.rest.unread.push_back(
            {name.empty() ? place : name,
             face.IsNull() ? "IGES surface" : "STEP face",
             "its surface or its edges (" + place + " of the file) are faulty; repair it in the CAD and export again",
             {}});
    }
}

}  // namespace

Drawing read_step(const std::filesystem::path& file, Reading reading) {
    require_whole_step(file);
    Drawing drawing;
    STEPCAFControl_Reader named;
    named.SetNameMode(true);
    named.SetColorMode(true);
    named.SetLayerMode(true);
    STEPControl_Reader& reader = named.ChangeReader();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
    // The kernel looks for the files of parts beside this file, but only if its path is absolute.
    const std::filesystem::path whole = std::filesystem::absolute(file);
    if (named.ReadFile(whole.c_str()) != IFSelect_RetDone)
        throw InputError(file.string() + ": not a whole STEP file (ISO 10303-21); export it again");
    const Handle(XSControl_WorkSession) session = named.Reader().WS();
    require_points(*session->Model(), file.string());
    close_holes(*session->Model(), drawing);
    take_step_unit(reader, drawing);
    std::set<std::string> seen;
    if (reading == Reading::plain) {
        reader.TransferRoots();
        add_shape(reader.OneShape(), file.string(), drawing);
        drawing.rest.remarks.push_back(without_names);
        name_missing_parts(session, nullptr, whole.parent_path(), seen, drawing);
    } else {
        Handle(TDocStd_Document) document = new_document();
        if (named.Transfer(document)) Walk(document, drawing);
        name_missing_parts(session, &named, whole.parent_path(), seen, drawing);
    }
    add_failures(session, drawing, false);
    return drawing;
}

Drawing read_iges(const std::filesystem::path& file, Reading reading) {
    require_whole_iges(file);
    Drawing drawing;
    IGESCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    reader.SetLayerMode(true);
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
        throw InputError(file.string() + ": not a whole IGES file; export it again, or export STEP");
    const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
    const Handle(TCollection_HAsciiString) name = global.UnitName();
    set_unit(drawing, unit_called(name.IsNull() ? "" : name->ToCString(), drawing));
    if (reading == Reading::plain) {
        reader.TransferRoots();
        add_shape(reader.OneShape(), file.string(), drawing);
        drawing.rest.remarks.push_back(without_names);
    } else {
        Handle(TDocStd_Document) document = new_document();
        if (reader.Transfer(document)) Walk(document, drawing);
    }
    add_failures(reader.WS(), drawing, true);
    return drawing;
}

}  // namespace ripstop::cad
