#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "view/scene.hpp"
#include "view/scene_tables.hpp"

namespace quadrille::view {

/// A page that shows scenes as quadrille view does, with tables and settings, in one file that
/// needs neither a server nor a network.
class Report {
 public:
  /// Scenes that come after so much are left out, and the report says so [byte].
  static constexpr std::size_t kMaxSceneBytes = std::size_t{16} << 20;
  /// Points of a cloud that are shown where there are several clouds.
  static constexpr std::size_t kPointsOfMany = 25000;
  /// Rows of a table that are told.
  static constexpr std::size_t kMaxRows = 2000;

  /// @param title    stands above the tables, and on the browser's tab
  /// @param command  as it was typed
  /// @param settings as TOML; empty: not told
  Report(std::string title, std::string command, std::string settings);

  /// Shows a scene, and tells its objects and grasps in tables.
  /// @param several  whether more may come: each is then shown with fewer points
  void add_scene(const Scene& scene, bool several);
  void add_table(ReportTable table) { tables_.push_back(std::move(table)); }
  void add_note(std::string note) { notes_.push_back(std::move(note)); }

  /// What the page leaves out; empty: nothing.
  std::string left_out() const;

  /// The page; pure ASCII but for the program's own text, whatever names the scenes have.
  std::string html() const;

 private:
  std::string session() const;

  std::string title_, command_, settings_;
  std::vector<ReportTable> tables_;
  ReportTable objects_, grasps_;
  std::vector<std::string> notes_;
  /// As base64, with the names of the scenes.
  std::vector<std::string> packs_, names_;
  std::vector<std::int64_t> utimes_;
  std::size_t scene_bytes_ = 0, left_out_ = 0;
};

}  // namespace quadrille::view
