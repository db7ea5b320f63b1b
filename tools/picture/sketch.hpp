#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/image.hpp"

namespace quadrille {

/// A straight line segment, in pixels of the picture.
struct Segment {
  Eigen::Vector2d from, to;
};

/// Lines of the same style.
struct Strokes {
  std::vector<Segment> segments;
  double width = 1.0;
  Color color = Color::Ones();
  float alpha = 1.0f;
};

struct Disc {
  Eigen::Vector2d center;
  double radius = 1.0;
  Color color = Color::Ones();
};

/// A drawing over the cloud: all strokes first, then all discs.
struct Sketch {
  std::vector<Strokes> strokes;
  std::vector<Disc> discs;

  void add(const Sketch& other) {
    strokes.insert(strokes.end(), other.strokes.begin(), other.strokes.end());
    discs.insert(discs.end(), other.discs.begin(), other.discs.end());
  }
};

}  // namespace quadrille
