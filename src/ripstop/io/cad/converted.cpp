#include "ripstop/io/cad/converted.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <istream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"

namespace ripstop {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie in memory");

constexpr double largest_converted = 1e12;

json counts_of(const ConvertedFace& face) {
    return {{"name", face.name}, {"vertices", face.mesh.vertex_count()}, {"triangles", face.mesh.triangle_count()},
            {"area", face.area}, {"chord_error", face.chord_error},      {"attributes", face.attributes}};
}

json header_of(const ConvertedModel& model) {
    json header = {{"ripstop_converted", 1},   {"layers", model.layers},  {"remarks", model.remarks},
                   {"objects", json::array()}, {"curves", json::array()}, {"unread", json::array()}};
    if (model.unit) header["unit"] = {{"name", model.unit->name}, {"metres", model.unit->metres}};
    for (const ConvertedObject& object : model.objects) {
        json faces = json::array();
        for (const ConvertedFace& face : object.faces) faces.push_back(counts_of(face));
        header["objects"].push_back(
            {{"name", object.name}, {"type", object.type}, {"attributes", object.attributes}, {"faces", faces}});
    }
    for (const NamedCurve& curve : model.curves) {
        json points = json::array();
        for (int i = 0; i < curve.points.rows(); ++i)
            points.push_back({curve.points(i, 0), curve.points(i, 1), curve.points(i, 2)});
        header["curves"].push_back({{"name", curve.name}, {"points", points}, {"attributes", curve.attributes}});
    }
    for (const UnreadObject& object : model.unread)
        header["unread"].push_back({{"name", object.name},
                                    {"type", object.type},
                                    {"reason", object.reason},
                                    {"attributes", object.attributes}});
    return header;
}

/// Reads the arrays after the header, one after the other.
class Arrays {
  public:
    Arrays(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    template <class Array>
    void take(Array& array, std::int64_t rows, const char* what) {
        const std::size_t size = sizeof(typename Array::Scalar) * 3;
        if (rows < 0 || static_cast<std::uint64_t>(rows) > rest_.size() / size ||
            rows > std::numeric_limits<int>::max() / 3)
            throw InputError(name_ + ": " + std::to_string(rows) + " " + what + " announced, but only " +
                             std::to_string(rest_.size()) + " bytes are left");
        array.resize(rows, 3);
        if (rows > 0) std::memcpy(array.data(), rest_.data(), size * static_cast<std::size_t>(rows));
        rest_.remove_prefix(size * static_cast<std::size_t>(rows));
    }
    std::size_t left() const { return rest_.size(); }

  private:
    std::string_view rest_;
    const std::string& name_;
};

void require_sound(const TriangleMesh& mesh, const std::string& name) {
    if (!(mesh.positions.array().abs() < largest_converted).all())
        throw InputError(name + ": a coordinate is not a finite number below 1e12");
    if (mesh.triangle_count() > 0 &&
        (mesh.triangles.minCoeff() < 0 || mesh.triangles.maxCoeff() >= mesh.vertex_count()))
        throw InputError(name + ": a triangle refers to a vertex that does not exist");
}

ConvertedFace face_of(const json& entry, Arrays& arrays, const std::string& name) {
    ConvertedFace face;
    face.name = entry.value("name", "");
    face.area = entry.value("area", 0.0);
    face.chord_error = entry.value("chord_error", 0.0);
    face.attributes = entry.value("attributes", Attributes{});
    arrays.take(face.mesh.positions, entry.value("vertices", std::int64_t{0}), "vertices");
    arrays.take(face.mesh.triangles, entry.value("triangles", std::int64_t{0}), "triangles");
    require_sound(face.mesh, name);
    return face;
}

NamedCurve curve_of(const json& entry, const std::string& name) {
    const auto points = entry.at("points").get<std::vector<std::array<double, 3>>>();
    if (points.size() < 2) throw InputError(name + ": a curve has fewer than two points");
    NamedCurve curve{entry.value("name", ""), Points3(static_cast<Eigen::Index>(points.size()), 3),
                     entry.value("attributes", Attributes{})};
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 3; ++k) curve.points(static_cast<Eigen::Index>(i), k) = points[i][at(k)];
    if (!(curve.points.array().abs() < largest_converted).all())
        throw InputError(name + ": a curve has a coordinate that is not a finite number below 1e12");
    return curve;
}

ConvertedModel model_of(const json& header, Arrays arrays, const std::string& name) {
    if (header.value("ripstop_converted", 0) != 1) throw InputError(name + ": not a model converted by this version");
    ConvertedModel model;
    model.layers = header.value("layers", std::vector<std::string>{});
    model.remarks = header.value("remarks", std::vector<std::string>{});
    if (header.contains("unit")) {
        model.unit = LengthUnit{header["unit"].value("name", ""), header["unit"].value("metres", 0.0)};
        if (!(model.unit->metres > 0)) throw InputError(name + ": its unit has no length");
    }
    for (const json& entry : header.at("objects")) {
        ConvertedObject object{
            entry.value("name", ""), entry.value("type", ""), entry.value("attributes", Attributes{}), {}};
        for (const json& face : entry.at("faces")) object.faces.push_back(face_of(face, arrays, name));
        model.objects.push_back(std::move(object));
    }
    for (const json& entry : header.value("curves", json::array())) model.curves.push_back(curve_of(entry, name));
    for (const json& entry : header.value("unread", json::array()))
        model.unread.push_back({entry.value("name", ""), entry.value("type", ""), entry.value("reason", ""),
                                entry.value("attributes", Attributes{})});
    if (arrays.left() != 0) throw InputError(name + ": bytes are left over after its last face");
    return model;
}

}  // namespace

void write_converted(std::ostream& out, const ConvertedModel& model) {
    out << header_of(model).dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    const auto write = [&out](const auto& array) {
        out.write(reinterpret_cast<const char*>(array.data()),
                  static_cast<std::streamsize>(sizeof(*array.data()) * static_cast<std::size_t>(array.size())));
    };
    for (const ConvertedObject& object : model.objects)
        for (const ConvertedFace& face : object.faces) {
            write(face.mesh.positions);
            write(face.mesh.triangles);
        }
}

ConvertedModel read_converted(std::istream& in, const std::string& name) {
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    try {
        const std::string_view text(bytes);
        const std::string_view arrays = text.substr(std::min(end + 1, bytes.size()));
        return model_of(json::parse(text.substr(0, end)), Arrays(arrays, name), name);
    } catch (const json::exception&) {
        throw InputError(name + ": not a converted model: its first line is not the JSON expected");
    }
}

}  // namespace ripstop
