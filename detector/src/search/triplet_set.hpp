#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

namespace quadrille {

/// Triplets of samples that were bases before, in any order (paper, section 5: "we also hash the
/// triplets such that any basis is seen only once").
class TripletSet {
 public:
  /// Adds three indices.
  /// @return false if the set had them
  bool insert(std::array<int, 3> triplet);

  std::size_t size() const { return triplets_.size(); }
  /// How many insertions the set refused.
  std::size_t repeats() const { return repeats_; }

 private:
  struct Hash {
    std::size_t operator()(const std::array<int, 3>& triplet) const;
  };
  std::unordered_set<std::array<int, 3>, Hash> triplets_;
  std::size_t repeats_ = 0;
};

}  // namespace quadrille
