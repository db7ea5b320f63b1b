#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "view/scene/scene.hpp"
#include "view/scene/scene_tables.hpp"

namespace quadrille::view {

/// A page that shows scenes as quadrille view does, with tables and settings, in one file that
/// needs neither a server nor a network.
class Report {
 public:
  /// Limit of the scenes in total [byte]; further ones are left out, and the report says so.
  static constexpr std::size_t kMaxSceneBytes = std::size_t{16} << 20;
  /// Number of points shown of a cloud if there are several clouds.
  static constexpr std::size_t kPointsOfMany = 25000;
  /// Limit of the rows in a table.
  static constexpr std::size_t kMaxRows = 2000;

  /// @param title  title above the tables and on the browser's tab
  /// @param command  the command as it was typed
  /// @param settings  the settings as TOML; left out if empty
  Report(std::string title, std::string command, std::string settings);

  /// Adds a scene, with its objects and grasps in tables.
  /// @param several  true if more scenes may follow; each is then shown with fewer points
  void add_scene(const Scene& scene, bool several);
  void add_table(ReportTable table) { tables_.push_back(std::move(table)); }
  void add_note(std::string note) { notes_.push_back(std::move(note)); }

  /// Describes what the page leaves out; empty if nothing.
  std::string left_out() const;

  /// Returns the page, which is pure ASCII except for the program's own text, whatever names the
  /// scenes have.
  std::string html() const;

 private:
  std::string session() const;

  std::string title_, command_, settings_;
  std::vector<ReportTable> tables_;
  ReportTable objects_, grasps_;
  std::vector<std::string> notes_;
  /// The scenes as base64, and their names.
  std::vector<std::string> packs_, names_;
  std::vector<std::int64_t> utimes_;
  std::size_t scene_bytes_ = 0, left_out_ = 0;
};

}  // namespace quadrille::view
