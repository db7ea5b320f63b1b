#include "quadrille/detector/options.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

struct Visited {
  std::set<std::string> names;
  std::set<const void*> fields;
};

Visited visit(DetectorOptions& options) {
  Visited visited;
  visit_options(options, [&](const char* name, auto& field) {
    CHECK(visited.names.insert(name).second);
    CHECK(visited.fields.insert(&field).second);
  });
  return visited;
}

/// Sets one field to what is out of any range; true if it has a range.
bool break_field(DetectorOptions* options, const std::string& wanted) {
  bool ranged = false;
  visit_options(*options, [&](const char* name, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if (name != wanted) return;
    if constexpr (std::is_same_v<Field, double>) {
      field = std::numeric_limits<double>::quiet_NaN();
      ranged = true;
    } else if constexpr (std::is_same_v<Field, int>) {
      field = -1;
      ranged = true;
    }
  });
  return ranged;
}

/// What check() says against the options; empty if nothing.
std::string complaint(const DetectorOptions& options) {
  try {
    options.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the defaults are in range", "[options]") { CHECK_NOTHROW(DetectorOptions().check()); }

TEST_CASE("each setting out of range is refused by its name", "[options][hostile]") {
  DetectorOptions defaults;
  for (const std::string& name : visit(defaults).names) {
    CAPTURE(name);
    DetectorOptions options;
    if (!break_field(&options, name)) {
      CHECK(std::set<std::string>{"seed", "search.basis", "search.quantisation",
                                  "search.hash_triplets", "agglomerate.enabled"}
                .contains(name));
      continue;
    }
    CHECK(complaint(options).starts_with(name + " = "));
  }
}

TEST_CASE("infinities and absurd counts are refused as well", "[options][hostile]") {
  DetectorOptions options;
  options.sampling.cell = std::numeric_limits<double>::infinity();
  CHECK(complaint(options).starts_with("sampling.cell = inf"));
  options = {};
  options.threads = 1000000;
  CHECK(complaint(options).starts_with("threads = 1000000"));
  options = {};
  options.search.bases = 0;
  CHECK(complaint(options).starts_with("search.bases = 0"));
  options = {};
  options.search.radii = {10.0, 5.0};
  CHECK(complaint(options) == "search.radii: must ascend");
}

TEST_CASE("a visit reaches each scalar setting", "[options]") {
  // A new field stops these lines from compiling until it is listed here, and visited.
  DetectorOptions o;
  auto& [seed, threads, only, sampling, planes, inlier, search, agglomerate, aggregate] = o;
  auto& [cell, noisiest_cell, stride, noise] = sampling;
  auto& [noise_radius, quantile, patches] = noise;
  auto& [p1, p2, p3, p4, p5] = planes;
  auto& [i1, i2, i3] = inlier;
  auto& [basis, quantisation, radii, s1, s2, hash, s3, grow] = search;
  auto& [enabled, c1, c2, c3] = agglomerate;
  auto& [grow_families, g1, g2, g3] = grow;
  auto& [families, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13] = aggregate;
  const std::set<const void*> scalars = {&seed,         &threads,  &cell,    &noisiest_cell,
                                         &noise_radius, &quantile, &patches, &p1,
                                         &p2,           &p3,       &p4,      &p5,
                                         &i1,           &i2,       &i3,      &s1,
                                         &s2,           &s3,       &g1,      &g2,
                                         &g3,           &a1,       &a2,      &a3,
                                         &a4,           &a5,       &a6,      &a7,
                                         &a8,           &a9,       &a10,     &a11,
                                         &a12,          &a13,      &stride,  &basis,
                                         &quantisation, &hash,     &enabled, &c1,
                                         &c2,           &c3};
  CHECK(visit(o).fields == scalars);
  CHECK(only.empty());
  CHECK(radii.size() == 3);
  CHECK(basis == BasisKind::kThreePoints);
  CHECK(families.size() > grow_families.size());
}
