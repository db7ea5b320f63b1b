#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/word.hpp"

namespace quadrille {

/// The paper's 10-vector q = (A B C D E F G H I J).
using Vector10d = Eigen::Matrix<double, 10, 1>;

/// A quadric f(x) = [x 1] Q [x 1]ᵀ = Ax² + By² + Cz² + 2Dxy + 2Exz + 2Fyz + 2Gx + 2Hy + 2Iz + J
/// (paper, eq. 1 to 3). It is known only up to scale; the user chooses the sign of the gradient.
class Quadric {
 public:
  Quadric() = default;
  /// @param Q  4x4 symmetric
  explicit Quadric(const Eigen::Matrix4d& Q) : Q_(Q) {}
  /// @param q  the paper's 10-vector
  QUADRILLE_EXPORT explicit Quadric(const Vector10d& q);

  /// 4x4 symmetric matrix Q.
  const Eigen::Matrix4d& matrix() const { return Q_; }
  /// The 10-vector q.
  QUADRILLE_EXPORT Vector10d coefficients() const;
  /// Returns this surface with |q| = 1 and the sign unchanged; if q is zero, returns it as it is.
  QUADRILLE_EXPORT Quadric normalized() const;
  /// Returns this surface with the opposite gradient.
  Quadric flipped() const { return Quadric(Eigen::Matrix4d(-Q_)); }

  /// The algebraic distance f(x).
  QUADRILLE_EXPORT double value(const Eigen::Vector3d& x) const;
  /// The gradient ∇f(x).
  QUADRILLE_EXPORT Eigen::Vector3d gradient(const Eigen::Vector3d& x) const;
  /// The signed first-order distance f(x) / |∇f(x)| [m]; infinite where the gradient vanishes.
  QUADRILLE_EXPORT double distance(const Eigen::Vector3d& x) const;

  /// Returns the values of t at which the line o + t d crosses the quadric, the smaller magnitude
  /// first; a value is not finite if the line has no such crossing. A line that only touches the
  /// quadric or lies within it does not cross it.
  QUADRILLE_EXPORT std::array<double, 2> crossings(const Eigen::Vector3d& o,
                                                   const Eigen::Vector3d& d) const;

  /// Returns the quadric moved by a rigid motion, which holds X·x for each x of this one: Q_B =
  /// X_BA⁻ᵀ Q_A X_BA⁻¹.
  QUADRILLE_EXPORT Quadric transformed(const Eigen::Isometry3d& X_BA) const;
  /// Returns the quadric mapped by an invertible projective map of homogeneous points, x_B ~ P_BA
  /// x_A.
  /// @throws std::invalid_argument if P_BA is singular or not finite
  QUADRILLE_EXPORT Quadric transformed(const Eigen::Projective3d& P_BA) const;

  /// The dual quadric Q*, the locus of the planes Π with Πᵀ Q* Π = 0 that touch this one (paper,
  /// definition 2). It is the adjugate of Q, which is ~ Q⁻¹ if Q has full rank and exists always:
  /// it has rank 1 for cones and cylinders, and is zero for pairs of planes.
  QUADRILLE_EXPORT Eigen::Matrix4d dual() const;

 private:
  Eigen::Matrix4d Q_ = Eigen::Matrix4d::Zero();
};

/// The 17 real and imaginary affine types of quadrics; the rotational special cases (sphere,
/// circular cylinder, circular cone) and the single plane have names of their own.
enum class QuadricType {
  kSphere,
  kEllipsoid,
  kCylinder,
  kEllipticCylinder,
  kCone,
  kEllipticCone,
  kEllipticParaboloid,
  kHyperbolicParaboloid,
  kHyperboloidOneSheet,
  kHyperboloidTwoSheets,
  kHyperbolicCylinder,
  kParabolicCylinder,
  kPlane,
  kParallelPlanes,
  kIntersectingPlanes,
  kCoincidentPlanes,
  kImaginaryEllipsoid,
  kImaginaryCone,
  kImaginaryEllipticCylinder,
  kImaginaryParallelPlanes,
  kImaginaryIntersectingPlanes,
};

inline constexpr int kQuadricTypeCount = 21;

/// All types, in the order of the enumeration.
QUADRILLE_EXPORT std::array<QuadricType, kQuadricTypeCount> all_quadric_types();

/// The name used in JSON, messages and options, such as "elliptic_cylinder".
QUADRILLE_EXPORT std::string_view to_string(QuadricType type);

/// The type with the given name; nullopt if there is none.
QUADRILLE_EXPORT std::optional<QuadricType> quadric_type_from_string(std::string_view name);

/// True for a plane and for pairs of planes.
QUADRILLE_EXPORT bool is_flat(QuadricType type);

/// True for the types whose real points are none, a single point or a single line.
QUADRILLE_EXPORT bool is_imaginary(QuadricType type);

/// Natural logarithm of how frequent objects of this type are, relative to the common, circular
/// types. Saddles, hyperboloids of two sheets, and parabolic and hyperbolic cylinders are rare, but
/// noisy other shapes and rounded edges of boxes pass for them.
QUADRILLE_EXPORT double log_prior(QuadricType type);

/// Sets of quadrics to which a fit can be restricted, simplest first.
enum class Family {
  kPlane,             ///< 3 degrees of freedom
  kSphere,            ///< 4 degrees of freedom
  kCylinder,          ///< 5; circular
  kCone,              ///< 6; circular
  kParaboloid,        ///< 6; of revolution
  kRevolution,        ///< 7; any quadric of revolution, x² + y² + c z² + 2 i z + j = 0
  kEllipticCylinder,  ///< 7; any central cylinder over a conic
  kParabolic,         ///< 8; any elliptic or hyperbolic paraboloid
  kGeneral,           ///< 9; any quadric
};

inline constexpr int kFamilyCount = 9;

constexpr auto words_of(Family) {
  return std::to_array<Word<Family>>({{"plane", Family::kPlane},
                                      {"sphere", Family::kSphere},
                                      {"cylinder", Family::kCylinder},
                                      {"cone", Family::kCone},
                                      {"paraboloid", Family::kParaboloid},
                                      {"revolution", Family::kRevolution},
                                      {"elliptic_cylinder", Family::kEllipticCylinder},
                                      {"parabolic", Family::kParabolic},
                                      {"general", Family::kGeneral}});
}

/// A quadric in its own frame: its type, pose and size.
struct CanonicalForm {
  QuadricType type = QuadricType::kPlane;
  /// Pose of the canonical frame Q in the frame of the quadric. The origin is the centre of
  /// surfaces that have one, the apex of a cone, or the vertex of a paraboloid. The z axis is the
  /// axis of revolution, the axis of a cylinder, cone or hyperboloid, the direction in which a
  /// paraboloid opens, or a plane's normal; otherwise a ≥ b (≥ c) along x, y (, z).
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  /// Names and values in the order of Detection::dimensions, without lengths along axes, which a
  /// quadric does not have. Lengths are in the unit of the coordinates, angles in radians.
  std::vector<std::pair<std::string, double>> dimensions;
};

/// True if a dimension of that name is an angle and not a length.
QUADRILLE_EXPORT bool is_angle(const std::string& dimension);

/// Finds type, pose and dimensions from the eigenvalues of Q and of its upper left 3x3 block. It
/// tells apart all 17 types and the circular special cases.
///
/// It is most accurate in coordinates in which the surface has about unit size.
/// @param tolerance  relative size below which an eigenvalue, a constant or a difference of
///   semi-axes counts as zero
/// @throws std::invalid_argument if Q is zero, not finite, or a constant
QUADRILLE_EXPORT CanonicalForm canonical_form(const Quadric& Q, double tolerance = 1e-9);

/// Makes the quadric of a canonical form, the inverse of canonical_form() up to scale.
/// @throws std::invalid_argument for imaginary types, which have no dimensions
QUADRILLE_EXPORT Quadric from_canonical(const CanonicalForm& form);

}  // namespace quadrille
