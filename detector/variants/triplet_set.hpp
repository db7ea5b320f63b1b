#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

namespace quadrille {

/// The triplets of samples, in any order, that were bases before (paper, section 5: "we also hash
/// the triplets such that any basis is seen only once").
class TripletSet {
 public:
  /// Adds a triplet of indices.
  /// @return false if the set already contained it
  bool insert(std::array<int, 3> triplet);

  std::size_t size() const { return triplets_.size(); }
  /// Number of insertions that the set refused.
  std::size_t repeats() const { return repeats_; }

 private:
  struct Hash {
    std::size_t operator()(const std::array<int, 3>& triplet) const;
  };
  std::unordered_set<std::array<int, 3>, Hash> triplets_;
  std::size_t repeats_ = 0;
};

}  // namespace quadrille
