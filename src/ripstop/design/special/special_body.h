#pragma once

#include <utility>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/design/special/special_levels.h"

namespace ripstop {

/// A curve on the body and its kind: a `crease` between the faces a < b, or seam `b` of primitive `a`. Sector seam b
/// precedes sector b, ring seam b precedes ring b, both counted from 0. The mouth has neither.
struct BodyCurve {
    enum Kind { crease, sector, ring, mouth } kind = crease;
    int a = 0, b = 0;

    bool operator==(const BodyCurve&) const = default;
};

/// The part of the body that a piece of its surface belongs to, counted from 0.
struct BodyCell {
    int face = -1;  ///< -1: not known yet
    int sector = 0, ring = 0;
    bool below = false;  ///< below the mouth

    bool operator==(const BodyCell&) const = default;
};

/// The union of primitives as level functions, negative inside. Each primitive is the intersection of its faces: one,
/// or for a cone the side, the base and the top. Its level is the maximum of theirs. Levels are zero exactly on the
/// surface and have a gradient of about one near it; that of an ellipsoid with radii r is k (k - 1) / q, k = |x / r|,
/// q = |x / r^2|.
///
/// Without fillets the level of the body is the least level d_i. With a fillet of radius R it is
///
///     R - sqrt(sum_i max(R - d_i, 0)^2)    (where some d_i < R, else the least)
///
/// which is circular where two surfaces meet at a right angle and leaves the surface unchanged farther than R from
/// the other.
class SpecialBody {
  public:
    /// With `rounding` > 0 the edges of cones are rounded by about that radius [m].
    explicit SpecialBody(const SpecialShape& shape, double rounding = 0);

    struct Face {
        int primitive;
        int part;  ///< 0: the only face, or a cone's side; 1: its base; 2: its top
    };
    const SpecialShape& shape() const { return shape_; }
    const std::vector<Face>& faces() const { return faces_; }
    int primitive_number(int face) const { return faces_[at(face)].primitive; }
    const std::vector<int>& faces_of(int primitive) const { return faces_of_[at(primitive)]; }

    Level face_level(int face, const Vec3& x) const;
    Level solid_level(int primitive, const Vec3& x) const;
    /// The level of the body with `face` as the visible one of its primitive: smooth across that face's borders.
    Level surface_level(int face, const Vec3& x) const;
    double level(const Vec3& x) const { return surface_level(owner(x), x).value; }
    /// The face nearest to the point: of the primitive with the least level the face with the greatest.
    int owner(const Vec3& x) const;
    int face_shown(int primitive, const Vec3& x) const;

    Level curve_level(const BodyCurve& curve, const Vec3& x) const;
    /// Whether the point lies on the curve's side of the axis, if the curve lies in a half-plane.
    bool reaches(const BodyCurve& curve, const Vec3& x) const;
    std::vector<BodyCurve> sector_curves(int primitive) const;
    std::vector<BodyCurve> ring_curves(int primitive) const;
    /// The curve between two different cells; the one nearest to `near` if there are several.
    BodyCurve curve_between(const BodyCell& one, const BodyCell& other, const Vec3& near) const;

    /// The sector or ring that contains a triangle of `primitive`. Requires that no seam crosses it.
    int sector_of(int primitive, const Vec3 (&corners)[3]) const;
    int ring_of(int primitive, const Vec3 (&corners)[3]) const;

    /// The poles of a primitive: where its axis meets its own surface and sector seams, or a cone's side, converge.
    std::vector<Vec3> poles(int primitive) const;
    /// Lowest and highest corner of a box that contains the body.
    std::pair<Vec3, Vec3> box() const;

  private:
    /// A lower bound on the level of a primitive at a point outside its bounding ball, to skip distant primitives.
    double least_level(int primitive, const Vec3& x) const;
    Vec3 local(int primitive, const Vec3& x) const;
    double tube_angle(int primitive, const Vec3& local) const;

    SpecialShape shape_;
    double rounding_;
    std::vector<Eigen::Matrix3d> frames_;  ///< rows: local x, y, z
    std::vector<LevelBall> balls_;
    std::vector<Face> faces_;
    std::vector<std::vector<int>> faces_of_;
    std::vector<std::vector<double>> ring_heights_;
};

}  // namespace ripstop
