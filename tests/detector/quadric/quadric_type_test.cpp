#include <set>
#include <string>

#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"

using quadrille::all_quadric_types;
using quadrille::QuadricType;

TEST_CASE("each type's name leads back to it and no two are the same", "[type]") {
  std::set<std::string> names;
  for (const QuadricType type : all_quadric_types()) {
    const std::string name(to_string(type));
    CHECK(quadrille::quadric_type_from_string(name) == type);
    names.insert(name);
  }
  CHECK(names.size() == quadrille::kQuadricTypeCount);
}

TEST_CASE("the names are those that scripts rely on", "[type][contract]") {
  const std::set<std::string> contract = {"sphere",
                                          "ellipsoid",
                                          "cylinder",
                                          "elliptic_cylinder",
                                          "cone",
                                          "elliptic_cone",
                                          "elliptic_paraboloid",
                                          "hyperbolic_paraboloid",
                                          "hyperboloid_one_sheet",
                                          "hyperboloid_two_sheets",
                                          "hyperbolic_cylinder",
                                          "parabolic_cylinder",
                                          "plane",
                                          "parallel_planes",
                                          "intersecting_planes"};
  for (const std::string& name : contract) {
    CAPTURE(name);
    const auto type = quadrille::quadric_type_from_string(name);
    REQUIRE(type);
    CHECK_FALSE(is_imaginary(*type));
  }
}

TEST_CASE("a name that is none has no type", "[type][degenerate]") {
  for (const char* name : {"", "Sphere", "sphere ", "cube", "plane\n"}) {
    CHECK_FALSE(quadrille::quadric_type_from_string(name));
  }
}

TEST_CASE("four real types are flat and five are imaginary", "[type]") {
  int flat = 0, imaginary = 0;
  for (const QuadricType type : all_quadric_types()) {
    if (is_imaginary(type)) {
      ++imaginary;
      CHECK(std::string(to_string(type)).starts_with("imaginary_"));
    } else if (is_flat(type)) {
      ++flat;
      CHECK(std::string(to_string(type)).find("plane") != std::string::npos);
    }
  }
  CHECK(flat == 4);
  CHECK(imaginary == 5);
}
