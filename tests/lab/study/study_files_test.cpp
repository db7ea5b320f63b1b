#include "lab/study/study_files.hpp"

#include <filesystem>
#include <fstream>

#include "lab/study/csv.hpp"
#include "lab/study/tables.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace quadrille;
using namespace quadrille::study;
using test::content_of;
using test::TempFolder;

namespace {

void append_scene(StudyFiles* files, const Label& label, const SceneName& name) {
  const SceneRecord record = test::typical_scene();
  files->append(grasp_rows(label, name, record), scene_row(label, name, record));
}

/// Writes the first `count` scenes of two.
std::string written(const TempFolder& folder, const char* file, int count) {
  const std::string path = folder.path(file);
  const Label label = test::label_with("franka");
  StudyFiles files(path, label, test::names_of(2));
  for (int n = 0; n < count; ++n) append_scene(&files, label, test::names_of(2)[n]);
  return path;
}

void add_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::app) << text;
}

}  // namespace

TEST_CASE("a study that was stopped in a scene ends with the rows of one that was not", "[study]") {
  const TempFolder folder;
  const std::string whole = written(folder, "whole.csv", 2), part = written(folder, "part.csv", 1);
  const Label label = test::label_with("franka");
  // Grasps of the second scene, and half a row, as a stop leaves them.
  add_text(part, csv_line(grasp_rows(label, test::names_of(2)[1], test::typical_scene())[0]));
  add_text(part, "1.2.3,table");
  add_text(scenes_path(part), "1.2.3,\"ta");
  {
    StudyFiles files(part, label, test::names_of(2));
    CHECK(files.finished() == 1);
    append_scene(&files, label, test::names_of(2)[1]);
  }
  CHECK(content_of(part) == content_of(whole));
  CHECK(content_of(scenes_path(part)) == content_of(scenes_path(whole)));
  CHECK(StudyFiles(part, label, test::names_of(5)).finished() == 2);
}

TEST_CASE("a study with other settings is refused, and its files stay as they are",
          "[study][hostile]") {
  const TempFolder folder;
  const std::string path = written(folder, "a.csv", 2);
  const std::string before = content_of(path) + content_of(scenes_path(path));
  const auto open = [&](const Label& label, const std::vector<SceneName>& names) {
    const StudyFiles files(path, label, names);
  };
  const std::vector<SceneName> names = test::names_of(2);
  CHECK_THROWS_WITH(open(test::label_with("wsg50"), names),
                    test::contains("row 1: has gripper 'franka' where this run has 'wsg50'"));
  CHECK_THROWS_WITH(open(test::label_with("franka", "y"), names), test::contains("other settings"));
  CHECK_THROWS_WITH(open(test::label_with("franka"), test::names_of(1)),
                    test::contains("row 2: scene 2 (tabletop 12) is none of this run"));
  CHECK_THROWS_WITH(open(test::label_with("franka"), {names[1]}),
                    test::contains("row 1: is scene 1 (tabletop 11) where this run has scene 2"));
  CHECK(content_of(path) + content_of(scenes_path(path)) == before);
}

TEST_CASE("files that are no study's are refused, and left alone", "[study][hostile]") {
  const TempFolder folder;
  const Label label = test::label_with("franka");
  const auto open = [&](const std::string& path) {
    const StudyFiles files(path, label, test::names_of(2));
  };
  const std::string other = folder.write("other.csv", "a,b\n1,2\n");
  CHECK_THROWS_WITH(open(other), test::contains("no study to go on with"));
  CHECK(content_of(other) == "a,b\n1,2\n");
  const std::string lost = written(folder, "lost.csv", 2);
  std::filesystem::resize_file(lost, csv_line(grasp_columns()).size());
  CHECK_THROWS_WITH(open(lost), test::contains("has 0 rows where 6 are counted"));
  CHECK_THROWS_WITH(open(folder.path("none/a.csv")), test::contains("cannot be written"));
  const StudyFiles holder(folder.path("used.csv"), label, test::names_of(2));
  CHECK_THROWS_WITH(open(folder.path("used.csv")),
                    test::contains("is being written by another study"));
}
