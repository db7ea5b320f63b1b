#include "lab/bench/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "lab/experiments/measure.hpp"

namespace quadrille::bench {
namespace {

using experiments::Plot;
using experiments::quantile;
using experiments::Table;
using nlohmann::ordered_json;

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.1f}", 100.0 * share) : "-";
}

std::string two_decimals(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-";
}

std::string millimetres(double metres) { return two_decimals(1e3 * metres); }

std::string counted_name(const Row& row) { return row.counted.empty() ? "all" : row.counted; }

/// The share in two digits; a dash of nothing.
std::string share_of(int part, int whole) {
  return whole > 0 ? fmt::format("{:.2f}", static_cast<double>(part) / whole) : "-";
}

void add_rows(const Stability& cloud, Table* table) {
  for (const auto& [varied, counts] :
       {std::pair{"seed", cloud.seeds}, std::pair{"shift", cloud.shifts}}) {
    table->add({cloud.cloud, varied, fmt::format("{} / {}", counts.in_all, counts.in_any),
                share_of(counts.in_all, counts.in_any), share_of(counts.same_type, counts.in_all),
                fmt::format("{} / {}", counts.sure_in_all, counts.sure_in_any),
                share_of(counts.sure_in_all, counts.sure_in_any)});
  }
}

/// A number with one decimal; a dash if it is unknown.
std::string one_decimal(double value) {
  return std::isfinite(value) ? fmt::format("{:.1f}", value) : "-";
}

std::string millions(double count) { return one_decimal(1e-6 * count); }

void add_row(const std::string& set, const StageSpeed& stage, Table* table) {
  const double change = stage.change();
  table->add({set, stage.stage, one_decimal(stage.ms), two_decimals(stage.floor_ms),
              millions(stage.instructions), millions(stage.floor_instructions),
              millions(stage.stored),
              std::isfinite(change) ? fmt::format("{:+.1f}", 100.0 * change) : "-"});
}

ordered_json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value;
}

}  // namespace

Table to_table(const std::vector<Row>& rows) {
  Table table{"",
              {"family", "counted", "contender", "frames", "surfaces", "recall %", "precision %",
               "right width %", "median width error %", "median distance mm", "planes found %",
               "planes right %", "wall ms", "CPU ms"},
              {}};
  for (const Row& row : rows) {
    table.add({row.family, counted_name(row), row.contender, fmt::format("{}", row.frames),
               fmt::format("{}", row.total.wanted), percent(row.total.recall()),
               percent(row.precision()), percent(row.total.right_width()),
               percent(row.width_error()), millimetres(row.distance()),
               percent(row.total.plane_recall()), percent(row.total.plane_precision()),
               fmt::format("{:.1f}", quantile(row.wall_ms, 0.5)),
               fmt::format("{:.1f}", quantile(row.cpu_ms, 0.5))});
  }
  return table;
}

Table to_table(const std::vector<StageCounts>& families) {
  Table table{"",
              {"family", "scenes", "wanted", "no hypothesis", "claimed", "first look", "fit",
               "confidence", "accepted", "detected", "wrong accepted"},
              {}};
  for (const StageCounts& counts : families) {
    std::vector<std::string> row = {counts.family};
    for (const int n :
         {counts.scenes, counts.wanted, counts.no_hypothesis, counts.claimed, counts.first_look,
          counts.fit, counts.confidence, counts.accepted, counts.detected, counts.wrong}) {
      row.push_back(fmt::format("{}", n));
    }
    table.add(std::move(row));
  }
  return table;
}

Table to_table(const std::vector<Stability>& clouds) {
  Table table{"",
              {"cloud", "varied", "in all / in any", "share", "of one type", "sure in all / in any",
               "share of sure"},
              {}};
  Stability total{"total", {}, {}};
  for (const Stability& cloud : clouds) {
    add_rows(cloud, &table);
    total.seeds += cloud.seeds;
    total.shifts += cloud.shifts;
  }
  if (clouds.size() > 1) add_rows(total, &table);
  return table;
}

Table to_table(const std::vector<SpeedSet>& sets) {
  Table table{"",
              {"set", "stage", "ms", "floor ms", "M instructions", "floor", "baseline", "change %"},
              {}};
  for (const SpeedSet& set : sets) {
    for (const StageSpeed& stage : set.stages) add_row(set.name, stage, &table);
    add_row(set.name, set.total, &table);
    if (!std::isfinite(set.cgal_ms)) continue;
    table.add({set.name, "CGAL", one_decimal(set.cgal_ms), "-", "-", "-", "-", "-"});
    table.add(
        {set.name, "CGAL / all", one_decimal(set.cgal_ms / set.total.ms), "-", "-", "-", "-", "-"});
  }
  return table;
}

nlohmann::ordered_json to_json(const std::vector<Row>& rows) {
  ordered_json list = ordered_json::array();
  for (const Row& row : rows) {
    list.push_back({{"family", row.family},
                    {"counted", counted_name(row)},
                    {"contender", row.contender},
                    {"frames", row.frames},
                    {"surfaces", row.total.wanted},
                    {"found", row.total.found},
                    {"wrong", row.finds_others ? ordered_json() : ordered_json(row.total.wrong)},
                    {"recall", number(row.total.recall())},
                    {"precision", number(row.precision())},
                    {"right_width", number(row.total.right_width())},
                    {"width_error", number(row.width_error())},
                    {"distance", number(row.distance())},
                    {"plane_recall", number(row.total.plane_recall())},
                    {"plane_precision", number(row.total.plane_precision())},
                    {"wall_ms", quantile(row.wall_ms, 0.5)},
                    {"cpu_ms", quantile(row.cpu_ms, 0.5)}});
  }
  return list;
}

std::vector<Plot> plots_of(const std::vector<Row>& rows) {
  std::vector<Plot> plots;
  for (const Row& row : rows) {
    if (!std::isfinite(row.total.recall())) continue;
    const std::string title =
        fmt::format("{}, {}", row.family, row.counted.empty() ? "all quadrics" : "spheres alone");
    if (plots.empty() || plots.back().title != title) {
      plots.push_back({title, "median wall time of a frame [ms]", "recall", {}, true});
      plots.back().min_y_range = {0.0, 1.0};
    }
    plots.back().lines.push_back(
        {row.contender, {{quantile(row.wall_ms, 0.5), row.total.recall()}}, false, true});
  }
  return plots;
}

std::string to_markdown(const std::vector<Row>& rows, const std::vector<Contender>& contenders,
                        const std::string& command, const std::string& version) {
  std::string text = fmt::format("# Benchmark\n\nquadrille {}: `{}`. ", version, command);
  text +=
      "Times depend on the machine and are medians over the frames, one thread, from the decoded "
      "cloud to the quadrics; all else is the same each time.\n\n"
      "A surface is **found** by a quadric that holds 60 % of its points within the noise, with "
      "their normals within 20°, and few points around that are not the surface's. **Precision** "
      "is that of curved quadrics. The **width** is the one across the line of sight that a "
      "gripper would close on; it is right within 10 %, or 4 mm. The **distance** is the mean "
      "distance of a surface's visible points, without their noise, from the finding to which it "
      "is least; the median is over all surfaces, found or not. A contender that looks for spheres "
      "alone is judged by the spheres. In the rows of spheres the others have no precision: what "
      "they find beside spheres is no mistake, and nothing tells which of their mistakes was meant "
      "for a sphere.\n\n![recall against time](bench.svg)\n\n";
  text += to_markdown(to_table(rows)) + "\n";
  for (const Contender& contender : contenders) {
    text += fmt::format("- `{}`: {}{}\n", contender.name, contender.about,
                        contender.absent.empty() ? "" : " (" + contender.absent + ")");
  }
  return text;
}

}  // namespace quadrille::bench
