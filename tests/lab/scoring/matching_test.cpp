#include "lab/scoring/matching.hpp"

#include "support/catch.hpp"

namespace quadrille::scoring {
namespace {

using Pairs = std::map<int, int>;

TEST_CASE("as many are matched as can be, the better pairs first", "[scoring][matching]") {
  // Finding 0 would take surface 0, which is all that finding 1 has.
  CHECK(match_most({{0, {{0, 0.9}, {1, 0.7}}}, {1, {{0, 0.8}}}}) == Pairs{{0, 1}, {1, 0}});
  CHECK(match_most({{0, {{0, 0.7}}}, {1, {{0, 0.8}}}}) == Pairs{{0, 1}});
  CHECK(match_most({}).empty());
}

TEST_CASE("a chain of findings moves on so that the last one has a surface",
          "[scoring][matching]") {
  const Candidates chain = {{0, {{0, 0.9}, {1, 0.8}}},
                            {1, {{1, 0.7}, {2, 0.6}}},
                            {2, {{2, 0.5}, {3, 0.4}}},
                            {3, {{0, 0.3}}}};
  CHECK(match_most(chain) == Pairs{{0, 3}, {1, 0}, {2, 1}, {3, 2}});
}

TEST_CASE("a finding has one surface at most, and each surface one finding",
          "[scoring][matching]") {
  const Candidates all = {{4, {{0, 0.6}, {1, 0.9}}}, {7, {{0, 0.8}, {1, 0.7}}}, {9, {{1, 0.6}}}};
  CHECK(match_most(all) == Pairs{{1, 4}, {0, 7}});
  // Without a surface to be, a finding is none.
  CHECK(match_most({{4, {}}}).empty());
}

}  // namespace
}  // namespace quadrille::scoring
