#pragma once

#include <optional>

#include "boxes/direction_index.hpp"

namespace quadrille {

/// Indexes the points of a cloud by their directions when that is first asked for, since it looks
/// at all of them.
class DirectionsOnDemand {
 public:
  /// @param cloud  its points must outlive this object
  /// @param view   what find_view() returns for the cloud; null if that is not known
  DirectionsOnDemand(const CloudView& cloud, const PinholeView* view)
      : cloud_(cloud), view_(view) {}

  const DirectionIndex& index() {
    if (!index_) {
      if (view_) {
        index_.emplace(cloud_, *view_);
      } else {
        index_.emplace(cloud_);
      }
    }
    return *index_;
  }

 private:
  CloudView cloud_;
  const PinholeView* view_;
  std::optional<DirectionIndex> index_;
};

}  // namespace quadrille
