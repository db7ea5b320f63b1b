#pragma once

#include <algorithm>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "support/choices.hpp"
#include "support/exact_detection.hpp"
#include "support/small_scene.hpp"

namespace quadrille::test {

/// A number of a detection becomes a hostile one.
inline void spoil_one(Choices& choices, Detection* d) {
  const double value = choices.hostile();
  const auto axis = static_cast<Eigen::Index>(choices.below(4));
  switch (choices.below(9)) {
    case 0:
      d->X_CQ.translation()[axis % 3] = value;
      return;
    case 1:
      d->X_CQ.linear()(axis % 3, static_cast<Eigen::Index>(choices.below(3))) = value;
      return;
    case 2:
      (choices.one_in(2) ? d->extent_Q.min() : d->extent_Q.max())[axis % 3] = value;
      return;
    case 3:
    case 4:
      if (d->dimensions.empty()) return;
      (choices.one_in(2) ? d->dimensions.front().std : d->dimensions.front().value) = value;
      std::rotate(d->dimensions.begin(), d->dimensions.begin() + 1, d->dimensions.end());
      return;
    case 5: {
      Eigen::Matrix4d Q = d->Q_C.matrix();
      const auto row = static_cast<Eigen::Index>(choices.below(4));
      Q(axis, row) = Q(row, axis) = value;
      d->Q_C = Quadric(Q);
      return;
    }
    case 6:
      d->type = static_cast<QuadricType>(choices.below(kQuadricTypeCount));
      return;
    case 7:
      d->id = choices.pick(
          std::array{0, -1, 1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()});
      return;
    default:
      (choices.one_in(2) ? d->rms : d->score) = value;
  }
}

/// A detection of any type where a body may stand.
inline Detection any_detection(Choices& choices, int id) {
  static constexpr std::array kNames = {
      "radius",       "a",        "b",       "c",          "length",
      "focal",        "focal_a",  "focal_b", "half_angle", "half_angle_a",
      "half_angle_b", "distance", "width",   "height",     "angle"};
  Detection d;
  d.id = id;
  d.type = static_cast<QuadricType>(choices.below(kQuadricTypeCount));
  d.X_CQ =
      facing({choices.between(0.2, -0.2), choices.between(0.2, -0.2), choices.between(0.7, 1.2)});
  const double size = choices.between(0.01, 0.1);
  for (const char* name : kNames) d.dimensions.push_back({name, size, 0.001});
  d.extent_Q = {Eigen::Vector3d::Constant(-size), Eigen::Vector3d::Constant(size)};
  d.Q_C = Quadric(diagonal(1, 1, 1, -size * size)).transformed(d.X_CQ).normalized();
  d.rms = 0.001;
  d.score = 1.0;
  return d;
}

/// Adds to what was found, takes from it, and spoils numbers.
inline void spoil(Choices& choices, std::vector<Detection>* detections) {
  const std::size_t changes = choices.below(8);
  for (std::size_t k = 0; k < changes; ++k) {
    const std::size_t which = detections->empty() ? 0 : choices.below(detections->size());
    switch (choices.below(4)) {
      case 0:
        detections->push_back(any_detection(choices, static_cast<int>(50 + k)));
        break;
      case 1:
        if (!detections->empty()) detections->push_back((*detections)[which]);
        break;
      default:
        if (!detections->empty()) spoil_one(choices, &(*detections)[which]);
    }
  }
}

}  // namespace quadrille::test
