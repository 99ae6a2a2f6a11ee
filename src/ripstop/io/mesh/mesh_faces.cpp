#include "ripstop/io/mesh/mesh_faces.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/mesh/fan.h"

namespace ripstop {
namespace {

/// Removes repeated corners and spikes from a face.
void drop_repeated(std::vector<RecordedCorner>& round) {
    std::size_t end = 0;  // of the part that is kept
    const auto vertex = [&round](std::size_t i) { return round[i].vertex; };
    for (std::size_t i = 0; i < round.size(); ++i) {
        const RecordedCorner corner = round[i];
        if (end > 0 && vertex(end - 1) == corner.vertex) continue;
        if (end > 1 && vertex(end - 2) == corner.vertex)
            --end;
        else
            round[end++] = corner;
    }
    std::size_t begin = 0;  // of the part that is kept
    while (end - begin > 1) {
        if (vertex(end - 1) == vertex(begin) || (end - begin > 2 && vertex(end - 2) == vertex(begin)))
            --end;
        else if (end - begin > 2 && vertex(end - 1) == vertex(begin + 1))
            ++begin;
        else
            break;
    }
    round.resize(end);
    round.erase(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// The corner from which a face is fanned, and the fault if it cannot be fanned.
struct Fan {
    std::size_t apex = 0;
    std::string fault = {};
};

/// Fans one face after the other and reuses its buffers.
class Fanner {
  public:
    explicit Fanner(const MeshRecords& file) : file_(file) {}

    Fan fan(const RecordedFace& face) {
        if (face.count == 3) return {};
        take_places(face);
        if (names_one_twice(face)) return {0, fault_text(face, "uses one of them twice")};
        if (polygon_.size() < 4) return {corner_.front()};
        const int apex = fan_corner(polygon_);
        if (apex >= 0) return {corner_[at(apex)]};
        if (has_area()) return {0, fault_text(face, "folds over itself when it is fanned into triangles")};
        return {};
    }

  private:
    /// Takes the corners of a face; of neighbours in the same place only the first.
    void take_places(const RecordedFace& face) {
        polygon_.clear();
        corner_.clear();
        for (std::size_t k = 0; k < static_cast<std::size_t>(face.count); ++k) {
            const Vec3& point = file_.vertices[at(file_.corners[face.first + k].vertex)];
            if (!polygon_.empty() && point == polygon_.back()) continue;
            polygon_.push_back(point);
            corner_.push_back(k);
        }
        while (polygon_.size() > 1 && polygon_.back() == polygon_.front()) {
            polygon_.pop_back();
            corner_.pop_back();
        }
    }

    bool names_one_twice(const RecordedFace& face) {
        vertices_.clear();
        for (std::size_t k = 0; k < static_cast<std::size_t>(face.count); ++k)
            vertices_.push_back(file_.corners[face.first + k].vertex);
        std::sort(vertices_.begin(), vertices_.end());
        return std::adjacent_find(vertices_.begin(), vertices_.end()) != vertices_.end();
    }

    /// True if any triangle of the fan has area. The triangles of a bow tie have area, although their signed sum
    /// has none.
    bool has_area() const {
        for (std::size_t k = 1; k + 1 < polygon_.size(); ++k) {
            const Vec3 b = polygon_[k] - polygon_[0], c = polygon_[k + 1] - polygon_[0];
            if (b.cross(c).norm() > 1e-14 * std::max(b.squaredNorm(), c.squaredNorm())) return true;
        }
        return false;
    }

    static std::string fault_text(const RecordedFace& face, const char* what) {
        return "a face with " + std::to_string(face.count) + " corners " + what +
               ", expected a plain polygon; triangulate it in the CAD";
    }

    const MeshRecords& file_;
    std::vector<Vec3> polygon_;
    std::vector<std::size_t> corner_;
    std::vector<int> vertices_;
};

}  // namespace

void mend_faces(MeshRecords& file) {
    std::vector<RecordedCorner> corners, round;
    corners.reserve(file.corners.size());
    std::size_t kept = 0;
    long left_out = 0, first_left_out = 0;
    for (std::size_t f = 0; f < file.faces.size(); ++f) {
        RecordedFace face = file.faces[f];
        const auto begin = file.corners.begin() + static_cast<std::ptrdiff_t>(face.first);
        round.assign(begin, begin + face.count);
        drop_repeated(round);
        if (round.size() < 3) {
            if (left_out++ == 0) first_left_out = face.place;
            continue;
        }
        face.first = corners.size();
        face.count = static_cast<int>(round.size());
        corners.insert(corners.end(), round.begin(), round.end());
        if (f < file.warps.size()) file.warps[kept] = file.warps[f];
        file.faces[kept++] = face;
    }
    file.faces.resize(kept);
    if (!file.warps.empty()) file.warps.resize(kept, Vec3::Zero());
    file.corners = std::move(corners);
    if (left_out > 0)
        file.remarks.push_back(std::to_string(left_out) + (left_out == 1 ? " face" : " faces") +
                               " with fewer than three different corners left out, the first in " +
                               (file.binary ? "byte " : "line ") + std::to_string(first_left_out));
}

TriangleList triangulated(const MeshRecords& file) {
    TriangleList list;
    list.corners.reserve(3 * file.faces.size());
    list.faces.reserve(file.faces.size());
    Fanner fanner(file);
    for (std::size_t f = 0; f < file.faces.size(); ++f) {
        const RecordedFace& face = file.faces[f];
        const auto count = static_cast<std::size_t>(face.count);
        Fan fan = fanner.fan(face);
        if (!fan.fault.empty()) list.faults[f] = std::move(fan.fault);
        for (std::size_t k = 1; k + 1 < count; ++k) {
            for (const std::size_t step : {std::size_t{0}, k, k + 1})
                list.corners.push_back(face.first + (fan.apex + step) % count);
            list.faces.push_back(f);
        }
    }
    return list;
}

}  // namespace ripstop
