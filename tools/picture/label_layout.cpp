#include "picture/label_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {
namespace {

constexpr double kCell = 4.0;
/// Step between the places that are tried, and the best length of a leader line [pixels].
constexpr double kTry = 8.0, kBestLength = 18.0;
/// Cost of leader line that crosses a surface or another line, relative to that of excess length.
constexpr double kCrossing = 2.0;
constexpr std::size_t kRimPoints = 48;

/// Returns a few points of a rim, evenly spread.
std::vector<Eigen::Vector2d> thin_out(const std::vector<Eigen::Vector2d>& rim) {
  std::vector<Eigen::Vector2d> few;
  const std::size_t step = rim.size() / kRimPoints + 1;
  for (std::size_t i = 0; i < rim.size(); i += step) few.push_back(rim[i]);
  return few;
}

LabelPlace lead_to_rim(const Eigen::AlignedBox2d& box, const std::vector<Eigen::Vector2d>& rim) {
  LabelPlace best{box, rim.front()};
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : rim) {
    const double square = box.squaredExteriorDistance(p);
    if (square >= least) continue;
    least = square;
    best.anchor = p;
  }
  return best;
}

/// Returns the cost of a place [pixels].
double cost_of(const LabelPlace& place, const TakenCells& lines, const TakenCells& bodies) {
  const Eigen::Vector2d way = place.anchor - place.start();
  const double length = way.norm();
  double crossed = 0.0;
  // The end is left out, because it lies on the object's own rim.
  for (double s = kCell; s < length - 2.0 * kCell; s += kCell) {
    const Eigen::Vector2d p = place.start() + s / length * way;
    const Eigen::AlignedBox2d at(p, p);
    if (!lines.is_free(at) || !bodies.is_free(at)) crossed += kCell;
  }
  return std::abs(length - kBestLength) + kCrossing * crossed;
}

std::optional<LabelPlace> find_place(const WantedLabel& label, const Eigen::Vector2d& picture,
                                     const TakenCells& lines, const TakenCells& bodies,
                                     bool may_cover_bodies) {
  const std::vector<Eigen::Vector2d> rim = thin_out(label.rim);
  std::optional<LabelPlace> best;
  double least = std::numeric_limits<double>::infinity();
  for (double top = 2.0; top + label.size.y() <= picture.y() - 2.0; top += kTry) {
    for (double left = 2.0; left + label.size.x() <= picture.x() - 2.0; left += kTry) {
      const Eigen::Vector2d corner(left, top);
      const Eigen::AlignedBox2d box(corner, corner + label.size);
      if (!lines.is_free(box) || (!may_cover_bodies && !bodies.is_free(box))) continue;
      const LabelPlace place = lead_to_rim(box, rim);
      const double length = (place.anchor - place.start()).norm();
      if (std::abs(length - kBestLength) >= least) continue;
      const double cost = cost_of(place, lines, bodies);
      if (cost >= least) continue;
      least = cost;
      best = place;
    }
  }
  return best;
}

}  // namespace

TakenCells::TakenCells(int width, int height)
    : width_(width),
      height_(height),
      columns_(static_cast<int>(width / kCell) + 1),
      rows_(static_cast<int>(height / kCell) + 1),
      taken_(static_cast<std::size_t>(columns_) * rows_, 0) {}

void TakenCells::mark(const Strokes& strokes) {
  for (const Segment& segment : strokes.segments) {
    if (!segment.from.allFinite() || !segment.to.allFinite()) continue;
    const Eigen::Vector2d way = segment.to - segment.from;
    const int steps = static_cast<int>(std::min(way.norm() / kCell, 1e5)) + 1;
    for (int n = 0; n <= steps; ++n) {
      mark(segment.from + double(n) / steps * way, 0.5 * strokes.width);
    }
  }
}

void TakenCells::mark(const Eigen::Vector2d& center, double radius) {
  mark({center.array() - radius, center.array() + radius});
}

void TakenCells::mark(const Eigen::AlignedBox2d& box) {
  if (!(box.max().minCoeff() >= 0.0) || box.min().x() > width_ || box.min().y() > height_) return;
  const auto cell = [](double v, int count) {
    return static_cast<int>(std::clamp(v / kCell, 0.0, count - 1.0));
  };
  for (int row = cell(box.min().y(), rows_); row <= cell(box.max().y(), rows_); ++row) {
    for (int column = cell(box.min().x(), columns_); column <= cell(box.max().x(), columns_);
         ++column) {
      taken_[static_cast<std::size_t>(row) * columns_ + column] = 1;
    }
  }
}

bool TakenCells::is_free(const Eigen::AlignedBox2d& box) const {
  const int left = std::max(0, static_cast<int>(box.min().x() / kCell));
  const int right = std::min(columns_ - 1, static_cast<int>(box.max().x() / kCell));
  const int bottom = std::min(rows_ - 1, static_cast<int>(box.max().y() / kCell));
  for (int row = std::max(0, static_cast<int>(box.min().y() / kCell)); row <= bottom; ++row) {
    const char* cells = &taken_[static_cast<std::size_t>(row) * columns_];
    if (std::any_of(cells + left, cells + right + 1, [](char taken) { return taken != 0; })) {
      return false;
    }
  }
  return true;
}

std::vector<std::optional<LabelPlace>> place_labels(const std::vector<WantedLabel>& wanted,
                                                    const Eigen::Vector2d& picture,
                                                    TakenCells lines, TakenCells bodies) {
  std::vector<std::optional<LabelPlace>> places;
  for (const WantedLabel& label : wanted) {
    std::optional<LabelPlace> place;
    for (const bool may_cover_bodies : {false, true}) {
      if (place || label.rim.empty()) break;
      place = find_place(label, picture, lines, bodies, may_cover_bodies);
    }
    if (place) {
      lines.mark(place->box);
      lines.mark(Strokes{{{place->start(), place->anchor}}, 2.0});
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace quadrille
