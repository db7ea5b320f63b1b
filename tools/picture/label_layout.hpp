#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "picture/sketch.hpp"

namespace quadrille {

/// The cells of the picture, a few pixels wide, that labels must keep off.
class TakenCells {
 public:
  TakenCells(int width, int height);

  void mark(const Strokes& strokes);
  void mark(const Eigen::Vector2d& center, double radius);
  void mark(const Eigen::AlignedBox2d& box);
  /// Returns true if no cell of a box, which must lie within the picture, is taken.
  bool is_free(const Eigen::AlignedBox2d& box) const;

 private:
  int width_, height_, columns_, rows_;
  std::vector<char> taken_;
};

/// A label to be placed beside an object.
struct WantedLabel {
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  /// Points of the object's rim; the leader line runs to one of them.
  std::vector<Eigen::Vector2d> rim;
};

struct LabelPlace {
  Eigen::AlignedBox2d box;
  /// End of the leader line.
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();

  /// Returns where the leader line starts at the label.
  Eigen::Vector2d start() const { return anchor.cwiseMax(box.min()).cwiseMin(box.max()); }
};

/// Places labels one after the other, each as near to its object as possible. They keep off all
/// lines, off other labels and their leader lines, and, if there is room, off surfaces.
/// @param lines   rims and grasps; never covered
/// @param bodies  what surfaces cover; labels cover it only if there is no other place
/// @return a place for each label; nullopt if there is no room for it
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<WantedLabel>& wanted,
                                                    const Eigen::Vector2d& picture,
                                                    TakenCells lines, TakenCells bodies);

}  // namespace quadrille
