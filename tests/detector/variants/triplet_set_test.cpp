#include "variants/triplet_set.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("a triplet is new once, in whatever order", "[triplets]") {
  TripletSet set;
  CHECK(set.insert({1, 2, 3}));
  CHECK_FALSE(set.insert({3, 1, 2}));
  CHECK_FALSE(set.insert({1, 2, 3}));
  CHECK(set.insert({1, 2, 4}));
  CHECK(set.insert({3, 2, 2}));
  CHECK(set.insert({3, 3, 2}));
  CHECK(set.size() == 4);
  CHECK(set.repeats() == 2);
}

TEST_CASE("all triplets of many samples are told apart", "[triplets]") {
  TripletSet set;
  for (int a = 0; a < 40; ++a) {
    for (int b = a; b < 40; ++b) {
      for (int c = b; c < 40; ++c) CHECK(set.insert({c << 24, a << 24, b << 24}));
    }
  }
  CHECK(set.size() == 40 * 41 * 42 / 6);
  CHECK(set.repeats() == 0);
}
