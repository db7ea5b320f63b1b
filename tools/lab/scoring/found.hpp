#pragma once

#include <array>
#include <optional>

#include "lab/scoring/superquadric.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::scoring {

/// A finding of a contender.
struct Found {
  Quadric Q_C;
  double score = 0.0;
  /// The surface if it is a superquadric; Q_C then means nothing.
  std::optional<Superquadric> superquadric = std::nullopt;

  /// The surface consists of the zeros of this value.
  double value(const Eigen::Vector3d& p_C) const;
  Eigen::Vector3d gradient(const Eigen::Vector3d& p_C) const;
  /// Returns the values of t at which the line o + t d crosses the surface, for a unit d; not
  /// finite if it does not.
  std::array<double, 2> crossings(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const;
  /// Returns true if the surface has numbers that make it one.
  bool is_surface() const;
};

}  // namespace quadrille::scoring
