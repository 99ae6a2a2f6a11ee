#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "ripstop/assembly/faults/check_envelope.h"
#include "support/envelopes.h"
#include "support/shapes.h"

/// A balloon whose tiles a test moves, and what `check_envelope` says of it.
namespace ripstop::checked_balloon {

inline EnvelopeDesign small_balloon() {
    EnvelopeDesign design;
    design.gores = 12;
    design.panels = 6;
    design.volume = 600;
    design.edge_length = 0.3;
    return design;
}

/// The balloon with conforming meshes, and with each tile meshed independently.
inline std::vector<std::vector<NamedMesh>> both_balloons() {
    return {design_natural(small_balloon()), testing::meshed_apart(small_balloon(), 4, 2)};
}

inline constexpr std::size_t middle = 3 * 6 + 2;  // gore 4, panel 3: neighbours on all four sides

inline EnvelopeCheck check(const std::vector<NamedMesh>& meshes) {
    return check_envelope(testing::tiles_of(meshes));
}

/// The codes of the issues, each with the first tile it names.
inline std::vector<std::string> named(const EnvelopeCheck& check) {
    std::vector<std::string> codes;
    for (const EnvelopeIssue& issue : check.issues)
        codes.push_back(issue.code + " " + (issue.tiles.empty() ? std::string("-") : issue.tiles.front()));
    return codes;
}

/// The codes of the notes, each with the first tile it names.
inline std::vector<std::string> meant(const EnvelopeCheck& check) {
    EnvelopeCheck as_issues;
    as_issues.issues = check.meant;
    return named(as_issues);
}

inline void move(TriangleMesh& mesh, const Vec3& by) {
    mesh.positions.rowwise() += by.transpose();
}

inline Vec3 middle_of(const TriangleMesh& mesh) {
    return mesh.positions.colwise().mean().transpose();
}

inline void scale_about(TriangleMesh& mesh, const Vec3& centre, double factor) {
    mesh.positions = ((mesh.positions.rowwise() - centre.transpose()) * factor).rowwise() + centre.transpose();
}

/// A strip from x0 to x1, 3 m wide, whose cross-section is a sine of height `rise`.
inline NamedMesh strip(const std::string& name, double x0, double x1, double rise) {
    TriangleMesh mesh = testing::rectangle(x1 - x0, 3, 8, 1);
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
        const Vec3 p = mesh.positions.row(v);
        mesh.positions.row(v) = Vec3(x0 + p.x(), rise * std::sin(std::numbers::pi * p.x() / (x1 - x0)), p.y());
    }
    return {name, mesh, {}};
}

}  // namespace ripstop::checked_balloon
