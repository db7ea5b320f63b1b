#include "surfaces/claims.hpp"

#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr int kClaimedColumns = 20, kClaimedRows = 10;

std::vector<int> columns(int from, int to) {
  std::vector<int> list;
  for (int k = 0; k < kClaimedColumns * kClaimedRows; ++k) {
    if (k % kClaimedColumns >= from && k % kClaimedColumns < to) list.push_back(k);
  }
  return list;
}

}  // namespace

TEST_CASE("what was claimed is open no more", "[claims]") {
  Claims claims(kClaimedColumns * kClaimedRows);
  CHECK(claims.open_of(columns(0, 4)) == columns(0, 4));
  claims.add(columns(0, 2));
  claims.add(columns(1, 2));
  CHECK(claims.open_of(columns(0, 4)) == columns(2, 4));
  for (const int k : columns(0, kClaimedColumns))
    CHECK((claims.free()[k] == 0) == (k % kClaimedColumns < 2));
}
