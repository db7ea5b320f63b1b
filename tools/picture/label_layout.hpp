#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "picture/sketch.hpp"

namespace quadrille {

/// What labels keep off: the picture in cells of a few pixels.
class TakenCells {
 public:
  TakenCells(int width, int height);

  void mark(const Strokes& strokes);
  void mark(const Eigen::Vector2d& center, double radius);
  void mark(const Eigen::AlignedBox2d& box);
  /// True if no cell of a box, which lies within the picture, is taken.
  bool is_free(const Eigen::AlignedBox2d& box) const;

 private:
  int width_, height_, columns_, rows_;
  std::vector<char> taken_;
};

/// A label that wants a place beside an object.
struct WantedLabel {
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  /// Points of the object's rim, to one of which its leader line runs.
  std::vector<Eigen::Vector2d> rim;
};

struct LabelPlace {
  Eigen::AlignedBox2d box;
  /// Where the leader line ends.
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();

  /// Where it leaves the label.
  Eigen::Vector2d start() const { return anchor.cwiseMax(box.min()).cwiseMin(box.max()); }
};

/// Places labels one after the other, each as near to its object as it can: off all lines, off
/// other labels and their leader lines, and, if there is room, off what surfaces cover.
/// @param lines   rims and grasps; never covered
/// @param bodies  what surfaces cover; covered only by labels that would have no place else
/// @return a place each; nullopt for a label that there is no room for
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<WantedLabel>& wanted,
                                                    const Eigen::Vector2d& picture,
                                                    TakenCells lines, TakenCells bodies);

}  // namespace quadrille
