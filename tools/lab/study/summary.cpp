#include "lab/study/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/file_bytes.hpp"
#include "lab/study/csv.hpp"
#include "lab/study/rows.hpp"
#include "lab/study/study_files.hpp"

namespace quadrille::study {
namespace {

using Groups = std::map<std::string, GroupSummary>;

CsvTable read_table(const std::string& path, const std::vector<std::string>& columns) {
  const std::vector<std::byte> bytes = io::read_file(path);
  return {path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, columns};
}

/// Returns the path of the table of grasps that a path refers to.
std::string table_of(const std::string& path) {
  constexpr std::string_view kScenes = ".scenes.csv";
  if (!path.ends_with(kScenes)) return path;
  return fmt::format("{}.csv", path.substr(0, path.size() - kScenes.size()));
}

/// Returns the key of a row's group: rows with the same label belong to one group.
std::string key_of(const CsvTable& table, std::size_t row) {
  std::string key;
  for (const auto& [column, value] : label_of({}, "", "", "")) {
    key += table.cell(row, column) + '\n';
  }
  return key;
}

GroupSummary& group_of(const CsvTable& table, std::size_t row, Groups* groups) {
  const auto [entry, is_new] = groups->try_emplace(key_of(table, row));
  if (!is_new) return entry->second;
  const std::string &gripper = table.cell(row, "gripper"), &unknown = table.cell(row, "unknown"),
                    &family = table.cell(row, "family");
  const std::string scenes = family.empty() ? "given clouds" : family;
  entry->second.name = fmt::format("{}, unknown {}, {}", gripper, unknown, scenes);
  entry->second.short_name = fmt::format("{}, {}, {}", gripper, unknown, scenes);
  entry->second.settings = fmt::format("version {}, settings {}", table.cell(row, "version"),
                                       table.cell(row, "settings"));
  return entry->second;
}

void count(const CsvTable& table, std::size_t row, const char* counted, const char* of,
           Ratio* ratio) {
  // A cell is empty if nothing was judged or tried.
  if (table.cell(row, counted).empty()) return;
  ratio->counted += table.count(row, counted);
  ratio->of += table.count(row, of);
}

void add_scene(const CsvTable& table, std::size_t row, GroupSummary* group) {
  ++group->scenes;
  group->failed += !table.cell(row, "error").empty();
  if (!table.cell(row, "error").empty()) return;
  group->without_truth += table.cell(row, "objects").empty();
  group->grasps += table.count(row, "grasps");
  count(table, row, "objects_with_grasp", "objects", &group->objects_with_grasp);
  count(table, row, "objects_with_good", "objects", &group->objects_with_good);
  count(table, row, "objects_with_held", "objects", &group->objects_with_held);
  count(table, row, "first_good", "first", &group->first_good);
  count(table, row, "first_touching", "first", &group->first_touching);
  count(table, row, "first_held", "first_tried", &group->first_held);
  count(table, row, "grasps_good", "grasps", &group->all_good);
  count(table, row, "grasps_touching", "grasps", &group->all_touching);
  count(table, row, "grasps_held", "grasps_tried", &group->all_held);
}

void add_first_grasps(const CsvTable& table, const std::set<std::string>& finished,
                      Groups* groups) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool is_finished = finished.count(key_of(table, row) + table.cell(row, "input")) > 0;
    if (!is_finished || table.cell(row, "first") != "1" || table.cell(row, "verdict").empty()) {
      continue;
    }
    const std::string& outcome = table.cell(row, "outcome");
    group_of(table, row, groups)
        .first.push_back({table.number(row, "score"), table.cell(row, "object_type"),
                          table.cell(row, "verdict") == "good",
                          !outcome.empty() && outcome != "untried", outcome == "held"});
  }
}

void add_table(const std::string& path, std::map<std::string, std::string>* seen, Groups* groups) {
  const std::string scenes_file = scenes_path(path);
  const CsvTable scenes = read_table(scenes_file, scene_columns());
  std::set<std::string> finished;
  for (std::size_t row = 0; row < scenes.rows(); ++row) {
    // Scenes are identified by their input, since studies with different first seeds number the
    // same scenes differently.
    const std::string scene = key_of(scenes, row) + scenes.cell(row, "input");
    finished.insert(scene);
    const auto [entry, is_new] = seen->emplace(scene, scenes_file);
    if (!is_new) {
      throw io::FileError(
          scenes_file, fmt::format("row {}", row + 1),
          fmt::format("scene {} ({}) is in {} too; give each scene once", scenes.cell(row, "scene"),
                      scenes.cell(row, "input"), entry->second));
    }
    add_scene(scenes, row, &group_of(scenes, row, groups));
  }
  add_first_grasps(read_table(path, grasp_columns()), finished, groups);
}

}  // namespace

std::vector<GroupSummary> summarise(const std::vector<std::string>& csv_paths) {
  Groups groups;
  std::map<std::string, std::string> seen;
  std::set<std::string> tables;
  for (const std::string& path : csv_paths) {
    std::error_code missing;  // ignored, since reading the table will report it
    const std::string table = table_of(path);
    const std::string real = std::filesystem::weakly_canonical(table, missing).string();
    if (tables.insert(real).second) add_table(table, &seen, &groups);
  }
  std::vector<GroupSummary> result;
  for (auto& [key, group] : groups) result.push_back(std::move(group));
  return result;
}

}  // namespace quadrille::study
