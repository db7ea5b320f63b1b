#include "support/words.hpp"

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"

using namespace quadrille;

TEST_CASE("each value of the detector's enumerations has a word of its own", "[words]") {
  test::check_words(BodyKind::kLump);
  test::check_words(PointLayout::Scalar::kFloat64);
  test::check_words(QuadricType::kImaginaryIntersectingPlanes);
  test::check_words(Family::kGeneral);
  test::check_words(BasisKind::kSphere);

  CHECK(to_string(PointLayout::Scalar::kFloat32) == "float32");
  CHECK(to_string(BasisKind::kThreePoints) == "three_points");
}

TEST_CASE("the words that stand in files are those of to_string()", "[words][options]") {
  for (const auto& [word, type] : words_of(QuadricType{})) CHECK(to_string(type) == word);
  CHECK(words_of(Family{}).size() == kFamilyCount);
}
