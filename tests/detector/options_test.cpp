#include "quadrille/detector/options.hpp"

#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

struct Visited {
  std::set<std::string> names;
  std::set<const void*> fields;
};

Visited visit(DetectorOptions& options) {
  Visited visited;
  DetectorOptions::visit(options, [&](auto& field, const Setting& setting) {
    CHECK(visited.names.insert(setting.name).second);
    CHECK(visited.fields.insert(&field).second);
  });
  return visited;
}

/// Sets a field to a number if it has a range; false if it has none.
template <class Field>
bool set_number(Field* field, double value) {
  if constexpr (std::is_same_v<Field, double> || std::is_same_v<Field, int>) {
    *field = static_cast<Field>(value);
    return true;
  } else if constexpr (std::is_same_v<Field, std::vector<double>>) {
    *field = {value};
    return true;
  }
  return false;
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

TEST_CASE("each setting is taken at its bounds and refused by its name beyond them",
          "[options][hostile]") {
  DetectorOptions rows;
  int ranged = 0;
  DetectorOptions::visit(rows, [&](auto& row, const Setting& setting) {
    using Field = std::remove_reference_t<decltype(row)>;
    const auto complaint_at = [&](double value) {
      DetectorOptions options;
      DetectorOptions::visit(options, [&](auto& field, const Setting& other) {
        if (std::string(other.name) == setting.name) ranged += set_number(&field, value);
      });
      return complaint(options);
    };
    if (Field unused{}; !set_number(&unused, 1.0)) return;
    CAPTURE(setting.name);
    CHECK(complaint_at(setting.min).empty());
    CHECK(complaint_at(setting.max).empty());
    const std::string start = std::string(setting.name) + " = ";
    for (const double beyond : {setting.min - 1.0, setting.max * 1.01 + 1.0}) {
      const std::string text = complaint_at(beyond);
      CHECK(text.starts_with(start));
      CHECK(text.find(": must lie between ") != std::string::npos);
    }
    if constexpr (std::is_same_v<Field, double>) {
      CHECK(complaint_at(std::numeric_limits<double>::quiet_NaN()).starts_with(start));
    }
  });
  CHECK(ranged > 36 * 4);
}

TEST_CASE("an error of range names the bounds with their unit", "[options]") {
  DetectorOptions options;
  options.planes.sigmas = -1.0;
  CHECK(complaint(options) == "planes.sigmas = -1: must lie between 0.1 and 100");
  options = {};
  options.sampling.cell = 20.0;
  CHECK(complaint(options) == "sampling.cell = 20: must lie between 1e-05 and 10 m");
  options = {};
  options.planes.min_samples = 2;
  CHECK(complaint(options) == "planes.min_samples = 2: must lie between 4 and 1000000");
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
  options.search.radii = {};
  CHECK(complaint(options) == "search.radii: must not be empty");
  options = {};
  options.search.grow.families = {};
  CHECK(complaint(options) == "search.grow.families: must not be empty");
}

TEST_CASE("a visit reaches each setting", "[options]") {
  // A new field stops these lines from compiling until it is listed here, and visited.
  DetectorOptions o;
  auto& [seed, threads, only, report, sampling, planes, inlier, search, aggregate, views] = o;
  auto& [cell, relative_cell, max_cells, noisiest_cell, stride, noise] = sampling;
  auto& [noise_radius, quantile, patches] = noise;
  auto& [p1, p2, p3, p4, p5] = planes;
  auto& [i1, i2, i3] = inlier;
  auto& [basis, radii, s1, s2, s3, s4, grow] = search;
  auto& [grow_families, g1, g2, g3] = grow;
  auto& [families, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15] = aggregate;
  auto& [shift, turn, remember, sector, most] = views;
  const std::set<const void*> fields = {&seed,
                                        &threads,
                                        &only,
                                        &report,
                                        &cell,
                                        &relative_cell,
                                        &max_cells,
                                        &noisiest_cell,
                                        &stride,
                                        &noise_radius,
                                        &quantile,
                                        &patches,
                                        &p1,
                                        &p2,
                                        &p3,
                                        &p4,
                                        &p5,
                                        &i1,
                                        &i2,
                                        &i3,
                                        &basis,
                                        &radii,
                                        &s1,
                                        &s2,
                                        &s3,
                                        &s4,
                                        &grow_families,
                                        &g1,
                                        &g2,
                                        &g3,
                                        &families,
                                        &a1,
                                        &a2,
                                        &a3,
                                        &a4,
                                        &a5,
                                        &a6,
                                        &a7,
                                        &a8,
                                        &a9,
                                        &a10,
                                        &a11,
                                        &a12,
                                        &a13,
                                        &a14,
                                        &a15,
                                        &shift,
                                        &turn,
                                        &remember,
                                        &sector,
                                        &most};
  CHECK(visit(o).fields == fields);
}
