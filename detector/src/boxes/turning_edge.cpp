#include "boxes/turning_edge.hpp"

#include <algorithm>
#include <cstddef>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

// Neighbouring points of a surface that turns away lie this many pitches apart at the most.
constexpr double kMaxStep = 4.0;

}  // namespace

TurningEdge turning_edge(const Face& face, const Eigen::Vector3d& out_C,
                         const std::vector<SeenThrough>& around, Rows& rows) {
  std::vector<std::vector<const SeenThrough*>> beyond(rows.all().size());
  for (const SeenThrough& seen : around) {
    Row* const row = rows.at(seen.on_C);
    if (row == nullptr || row->empty() || !row->seen) continue;
    const double distance = out_C.dot(seen.on_C) - row->end;
    if (distance > 0.0 && distance < kAround && seen.height < 0.0) {
      beyond[static_cast<std::size_t>(row - rows.all().data())].push_back(&seen);
    }
  }
  std::vector<double> reaches, drops;
  for (std::size_t n = 0; n < beyond.size(); ++n) {
    const Row& row = rows.all()[n];
    if (row.empty() || !row.seen) continue;
    std::sort(beyond[n].begin(), beyond[n].end(), [&](const auto* a, const auto* b) {
      return out_C.dot(a->on_C) < out_C.dot(b->on_C);
    });
    Eigen::Vector3d last_C = row.last_C;
    double reach = 0.0, drop = 0.0;
    for (const SeenThrough* seen : beyond[n]) {
      if ((seen->p_C - last_C).norm() > kMaxStep * face.pitch) break;
      last_C = seen->p_C;
      const double at = out_C.dot(seen->p_C) - row.end;
      if (at > reach) {
        reach = at;
        drop = -seen->height;
      }
    }
    reaches.push_back(reach);
    drops.push_back(drop);
  }
  if (reaches.empty()) return {};
  return {median(reaches), median(drops)};
}

}  // namespace quadrille
