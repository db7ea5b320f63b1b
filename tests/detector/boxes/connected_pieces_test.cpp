#include "boxes/connected_pieces.hpp"

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("pieces are parted where there is a gap", "[boxes]") {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 20; ++j) {
      if (i != 25 && i != 26) places.emplace_back(0.1 * i - 7.0, 0.1 * j + 3.0);
    }
  }
  const std::vector<int> apart = connected_pieces(places, 0.12);
  REQUIRE(apart.size() == places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    CHECK((apart[k] == apart.front()) == (places[k].x() < -4.55));
  }
  for (const int piece : connected_pieces(places, 0.3)) CHECK(piece == 0);
}

TEST_CASE("one stray place far away costs no memory and is a piece of its own", "[boxes]") {
  const std::vector<Eigen::Vector2d> places = {{0, 0}, {0, 0.001}, {0.001, 0}, {1e7, 1e7}};
  const std::vector<int> pieces = connected_pieces(places, 0.002);
  CHECK(pieces[0] == pieces[1]);
  CHECK(pieces[0] == pieces[2]);
  CHECK(pieces[0] != pieces[3]);
  CHECK(connected_pieces({}, 0.002).empty());
}

}  // namespace quadrille
