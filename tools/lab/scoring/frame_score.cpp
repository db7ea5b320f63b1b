#include <cmath>

#include "lab/scoring/score.hpp"

namespace quadrille::scoring {
namespace {

double ratio(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : std::nan("");
}

}  // namespace

FrameScore& FrameScore::operator+=(const FrameScore& other) {
  wanted += other.wanted, found += other.found, wrong += other.wrong;
  planes_wanted += other.planes_wanted, planes_found += other.planes_found;
  planes_right += other.planes_right, planes_wrong += other.planes_wrong;
  widths_right += other.widths_right;
  width_errors.insert(width_errors.end(), other.width_errors.begin(), other.width_errors.end());
  distances.insert(distances.end(), other.distances.begin(), other.distances.end());
  return *this;
}

double FrameScore::recall() const { return ratio(found, wanted); }

double FrameScore::precision() const { return ratio(found, found + wrong); }

double FrameScore::right_width() const {
  return ratio(widths_right, static_cast<int>(width_errors.size()));
}

double FrameScore::plane_recall() const { return ratio(planes_found, planes_wanted); }

double FrameScore::plane_precision() const {
  return ratio(planes_right, planes_right + planes_wrong);
}

}  // namespace quadrille::scoring
