#pragma once

#include <string>
#include <vector>

#include "view/scene/scene.hpp"

namespace quadrille::view {

/// Rows of text under a title.
struct ReportTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Make empty tables for the objects and the best grasps of several scenes.
ReportTable objects_table();
ReportTable grasps_table();

/// Adds the rows of one scene to such tables.
void add_rows(const Scene& scene, ReportTable* objects, ReportTable* grasps);

}  // namespace quadrille::view
