#include <fcntl.h>
#include <gmsh.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <unordered_map>

#include "contained.h"
#include "meshing.h"

namespace ripstop::cad {
namespace {

constexpr int samples_across = 16;
constexpr rlim_t most_seconds = 12;

/// The edge length at a place on a curve or surface of the model.
struct Sample {
    Vec3 at;
    double size;
};
using Samples = std::vector<Sample>;

double size_at(const Samples& samples, const Vec3& p, double otherwise) {
    double nearest = -1, size = otherwise;
    for (const Sample& sample : samples) {
        const double distance = (sample.at - p).squaredNorm();
        if (nearest >= 0 && distance >= nearest) continue;
        nearest = distance;
        size = sample.size;
    }
    return size;
}

Samples samples_of(int dimension, int tag, const EdgeSizes& sizes, double finer) {
    std::vector<double> low, high, parameters, points, curvatures;
    gmsh::model::getParametrizationBounds(dimension, tag, low, high);
    for (int i = 0; i <= samples_across; ++i)
        for (int j = 0; j <= (dimension == 2 ? samples_across : 0); ++j) {
            // Avoids the ends, where poles have infinite curvature.
            parameters.push_back(low[0] + (high[0] - low[0]) * (i + 0.5) / (samples_across + 1));
            if (dimension == 2) parameters.push_back(low[1] + (high[1] - low[1]) * (j + 0.5) / (samples_across + 1));
        }
    gmsh::model::getValue(dimension, tag, parameters, points);
    gmsh::model::getCurvature(dimension, tag, parameters, curvatures);
    Samples samples;
    for (std::size_t i = 0; i < curvatures.size(); ++i)
        samples.push_back({Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]),
                           std::min(sizes.longest, finer * sizes.at(std::abs(curvatures[i])))});
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end(),
                                                   [](const Sample& a, const Sample& b) { return a.size < b.size; });
    if (dimension == 2 && !samples.empty() && most->size - least->size < 1e-9 * most->size) samples.resize(1);
    return samples;
}

class SizeField {
  public:
    /// `tags` are those of the faces, in the order of `sizes.finer`.
    SizeField(const EdgeSizes& sizes, const std::vector<int>& tags) : sizes_(sizes) {
        gmsh::vectorpair entities;
        for (std::size_t i = 0; i < tags.size(); ++i)
            if (tags[i] > 0) faces_[tags[i]] = samples_of(2, tags[i], sizes, sizes.finer.empty() ? 1 : sizes.finer[i]);
        gmsh::model::getEntities(entities, 1);
        for (const auto& [dimension, tag] : entities) add_curve(tag);
    }

    double at(int dimension, int tag, const Vec3& p) const {
        const auto& known = dimension == 2 ? faces_ : curves_;
        const auto found = known.find(tag);
        return found == known.end() ? sizes_.longest : size_at(found->second, p, sizes_.longest);
    }

  private:
    /// A curve is divided for its own curvature and that of the faces it bounds.
    void add_curve(int tag) {
        Samples samples = samples_of(1, tag, sizes_, 1);
        std::vector<int> up, down;
        gmsh::model::getAdjacencies(1, tag, up, down);
        for (Sample& sample : samples)
            for (const int face : up)
                sample.size = std::min(sample.size, size_at(faces_[face], sample.at, sizes_.longest));
        curves_[tag] = std::move(samples);
    }

    const EdgeSizes& sizes_;
    std::map<int, Samples> faces_, curves_;
};

Meshes taken(const std::vector<int>& tags) {
    Meshes result;
    std::vector<std::size_t> node_tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(node_tags, coordinates, parameters, -1, -1, false, false);
    std::unordered_map<std::size_t, int> number;
    result.positions.resize(static_cast<Eigen::Index>(node_tags.size()), 3);
    for (std::size_t i = 0; i < node_tags.size(); ++i) {
        number[node_tags[i]] = static_cast<int>(i);
        for (std::size_t k = 0; k < 3; ++k)
            result.positions(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = coordinates[3 * i + k];
    }
    for (const int tag : tags) {
        std::vector<std::size_t> elements, corners;
        constexpr int triangle = 2;
        if (tag > 0) gmsh::model::mesh::getElementsByType(triangle, elements, corners, tag);
        Triangles triangles(static_cast<Eigen::Index>(elements.size()), 3);
        for (std::size_t i = 0; i < corners.size(); ++i)
            triangles(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = number.at(corners[i]);
        result.faces.push_back(std::move(triangles));
    }
    return result;
}

std::vector<int> imported(const std::vector<TopoDS_Face>& faces) {
    std::vector<int> tags;
    for (const TopoDS_Face& face : faces) {
        gmsh::vectorpair made;
        if (!face.IsNull()) gmsh::model::occ::importShapesNativePointer(&face, made);
        tags.push_back(made.size() == 1 && made[0].first == 2 ? made[0].second : -1);
    }
    gmsh::model::occ::synchronize();
    return tags;
}

/// gmsh has one global state per process.
struct Session {
    Session() { gmsh::initialize(0, nullptr, false); }
    ~Session() { gmsh::finalize(); }
};

void set_options(const EdgeSizes& sizes) {
    const auto set = [](const char* name, double value) { gmsh::option::setNumber(name, value); };
    set("General.Terminal", 0);
    set("Mesh.Algorithm", 6);  // frontal: gives the best shaped triangles
    set("Mesh.MeshSizeFromPoints", 0);
    set("Mesh.MeshSizeExtendFromBoundary", 0);
    set("Mesh.MeshSizeMin", sizes.shortest * std::min(1.0, finest(sizes)));
    set("Mesh.MeshSizeMax", sizes.longest);
    set("General.NumThreads", 1);
    set("Mesh.RandomFactor", 1e-9);
}

/// Ends this process if gmsh asks for more sizes than a mesh of `triangles` needs.
class Watch {
  public:
    Watch(const std::vector<int>& tags, double triangles, const Told& told)
        : left_(asks_a_triangle * triangles + free_asks), told_(told) {
        for (std::size_t i = 0; i < tags.size(); ++i) number_[tags[i]] = i;
    }
    void ask(int dimension, int tag) {
        if (--left_ < 0) ::_exit(EXIT_FAILURE);
        const auto found = number_.find(tag);
        if (dimension != 2 || tag == last_ || found == number_.end()) return;
        last_ = tag;
        told_(found->second);
    }

  private:
    static constexpr double asks_a_triangle = 60, free_asks = 1e5;
    double left_;
    const Told& told_;
    std::map<int, std::size_t> number_;
    int last_ = -1;
};

std::optional<Meshes> meshed_here(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles,
                                  const Told& told) {
    const Session session;
    try {
        set_options(sizes);
        const std::vector<int> tags = imported(faces);
        const SizeField field(sizes, tags);
        Watch watch(tags, triangles, told);
        gmsh::model::mesh::setSizeCallback([&](int dimension, int tag, double x, double y, double z) {
            watch.ask(dimension, tag);
            return field.at(dimension, tag, {x, y, z});
        });
        gmsh::model::mesh::generate(2);
        Meshes meshes = taken(tags);
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (!faces[i].IsNull() && meshes.faces[i].rows() == 0) return {};
        return meshes;
    } catch (const std::string&) {  // gmsh reports errors this way
        return {};
    } catch (const std::exception&) {
        return {};
    }
}

/// Writes binary: the numbers of rows of the positions and of each face, then their contents.
void write(const Meshes& meshes, int descriptor) {
    std::FILE* out = ::fdopen(descriptor, "wb");
    if (out == nullptr) ::_exit(EXIT_FAILURE);
    const auto put = [out](const auto& array) {
        const Eigen::Index rows = array.rows();
        std::fwrite(&rows, sizeof rows, 1, out);
        std::fwrite(array.data(), sizeof(*array.data()), static_cast<std::size_t>(array.size()), out);
    };
    put(meshes.positions);
    for (const Triangles& triangles : meshes.faces) put(triangles);
    if (std::fclose(out) != 0) ::_exit(EXIT_FAILURE);
}

std::optional<Meshes> read(std::FILE* in, std::size_t faces) {
    bool whole = true;
    const auto take = [&](auto& array) {
        Eigen::Index rows = 0;
        whole = whole && std::fread(&rows, sizeof rows, 1, in) == 1;
        if (!whole) return;
        array.resize(rows, 3);
        const std::size_t size = static_cast<std::size_t>(array.size());
        whole = std::fread(array.data(), sizeof(*array.data()), size, in) == size;
    };
    Meshes meshes;
    meshes.faces.resize(faces);
    take(meshes.positions);
    for (Triangles& triangles : meshes.faces) take(triangles);
    if (!whole) return {};
    return meshes;
}

}  // namespace

std::optional<Meshes> meshed_by_gmsh(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles,
                                     const Told& told) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    const pid_t parent = ::getpid(), child = ::fork();
    if (child == 0) {
        end_with(parent);
        const rlimit seconds{most_seconds, most_seconds};
        ::setrlimit(RLIMIT_CPU, &seconds);  // limits what the count does not cover
        ::close(ends[0]);
        const std::optional<Meshes> meshes = meshed_here(faces, sizes, triangles, told);
        if (!meshes) ::_exit(EXIT_FAILURE);
        write(*meshes, ends[1]);
        ::_exit(EXIT_SUCCESS);
    }
    ::close(ends[1]);
    std::FILE* in = child > 0 ? ::fdopen(ends[0], "rb") : nullptr;
    std::optional<Meshes> meshes;
    if (in != nullptr) {
        meshes = read(in, faces.size());
        std::fclose(in);
    } else {
        ::close(ends[0]);
    }
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    return meshes;
}

}  // namespace ripstop::cad
