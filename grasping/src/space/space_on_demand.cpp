#include "space/space_on_demand.hpp"

#include <algorithm>
#include <utility>

#include "space/each_cube.hpp"

namespace quadrille {
namespace {

// The state of a voxel that is not free, and is clear if what it stands on is free or clear. No one
// outside of this file sees it.
constexpr Voxel kPending = static_cast<Voxel>(4);

/// Edge of an eighth of a block.
constexpr int kHalf = OccupancyGrid::kBlock / 2;

/// Returns the number of the eighth of a block that holds a voxel; see eighth_of_cube().
int eighth_with(const Eigen::Vector3i& voxel) {
  const Eigen::Vector3i half = voxel / kHalf;
  return half.x() % 2 + 2 * (half.y() % 2) + 4 * (half.z() % 2);
}

/// Threads look at voxels while others settle them.
std::atomic_ref<Voxel> shared(Voxel& state) { return std::atomic_ref<Voxel>(state); }

}  // namespace

OccupancyGrid::Source::Source(SpaceMapper mapper,
                              std::shared_ptr<const std::vector<DepthView>> views,
                              const Eigen::Vector3d& up_C, Evidence evidence)
    : mapper_(std::move(mapper)),
      views_(std::move(views)),
      up_C_(up_C),
      up_(up_C, mapper_.size()),
      evidence_(std::move(evidence)),
      decided_(mapper_.blocks()) {}

std::atomic<std::uint8_t>& OccupancyGrid::Source::decided(const Eigen::Vector3i& voxel) {
  return decided_[mapper_.block_index(voxel)];
}

Voxel OccupancyGrid::Source::at(const Eigen::Vector3i& voxel) {
  if (!(decided(voxel).load(std::memory_order_acquire) >> eighth_with(voxel) & 1u)) {
    const std::lock_guard lock(mutex_);
    decide(voxel);
  }
  const auto state = shared(mapper_.voxel(voxel.x(), voxel.y(), voxel.z()));
  const Voxel found = state.load(std::memory_order_relaxed);
  if (found != kPending) return found;
  const std::lock_guard lock(mutex_);
  settle(voxel);
  return state.load(std::memory_order_relaxed);
}

/// Marks the free voxels of the eighth of a block that holds a voxel, unless they are marked
/// already.
void OccupancyGrid::Source::decide(const Eigen::Vector3i& voxel) {
  std::atomic<std::uint8_t>& of_block = decided(voxel);
  const unsigned known = of_block.load(std::memory_order_relaxed);
  const int eighth = eighth_with(voxel);
  if (known >> eighth & 1u) return;
  const unsigned bit = 1u << eighth;
  const Eigen::Vector3i block = voxel / kBlock * kBlock;
  if (mapper_.wanted(block)) {
    for (const DepthView& view : *views_) {
      if (view.valid()) mapper_.mark_free(view, block, bit);
    }
    if (up_.known() && mapper_.is_beside(views_->front(), block)) {
      const Eigen::Vector3i low = voxel / kHalf * kHalf;
      each_cube(low, low.array() + kHalf, 1, [&](const Eigen::Vector3i& at) {
        Voxel& state = mapper_.voxel(at.x(), at.y(), at.z());
        if (state == Voxel::kUnknown) state = kPending;
      });
    }
  }
  of_block.store(static_cast<std::uint8_t>(known | bit), std::memory_order_release);
}

/// Finds out whether a pending voxel is clear, and with it those below that decide it.
void OccupancyGrid::Source::settle(Eigen::Vector3i voxel) {
  std::vector<Eigen::Vector3i> pending;
  bool clear = false;
  for (;;) {
    decide(voxel);
    const Voxel state =
        shared(mapper_.voxel(voxel.x(), voxel.y(), voxel.z())).load(std::memory_order_relaxed);
    if (state != kPending) {
      clear = state == Voxel::kFree || state == Voxel::kClear;
      break;
    }
    pending.push_back(voxel);
    const int layer = up_.number(voxel[up_.axis()]);
    if (layer == 0 || !may_be_clear(voxel)) break;
    voxel -= up_.step(layer);
    if ((voxel.array() < 0).any() || (voxel.array() >= mapper_.size().array()).any()) break;
  }
  for (const Eigen::Vector3i& at : pending) {
    shared(mapper_.voxel(at.x(), at.y(), at.z()))
        .store(clear ? Voxel::kClear : Voxel::kUnknown, std::memory_order_relaxed);
  }
}

/// Returns true if nothing was measured before or in a voxel.
bool OccupancyGrid::Source::may_be_clear(const Eigen::Vector3i& voxel) const {
  return !views_->front().meets_surface(mapper_.centre(voxel), 0.5 * mapper_.resolution());
}

const std::vector<Voxel>& OccupancyGrid::Source::all() {
  std::call_once(once_, [&] {
    // Others may ask for voxels meanwhile, so the rest is decided in a copy.
    std::unique_lock lock(mutex_);
    SpaceMapper rest = mapper_;
    std::vector<char> known;
    known.reserve(decided_.size());
    for (const auto& eighths : decided_) known.push_back(eighths == SpaceMapper::kAllEighths);
    lock.unlock();
    rest.replace(kPending, Voxel::kUnknown);
    for (const DepthView& view : *views_) {
      if (view.valid()) rest.mark_free(view, known);
    }
    all_ = std::move(rest).take_cleared(views_->front(), up_C_).states_;
  });
  return all_;
}

OccupancyGrid SpaceMapper::take_on_demand(std::shared_ptr<const std::vector<DepthView>> views,
                                          const Eigen::Vector3d& up_C,
                                          OccupancyGrid::Evidence evidence) && {
  OccupancyGrid grid = grid_;
  grid.source_ = std::make_shared<OccupancyGrid::Source>(std::move(*this), std::move(views), up_C,
                                                         std::move(evidence));
  return grid;
}

}  // namespace quadrille
