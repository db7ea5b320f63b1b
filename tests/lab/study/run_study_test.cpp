#include "lab/study/run_study.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lab/scene/scene.hpp"
#include "lab/scene/scene_files.hpp"
#include "lab/study/tables.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace quadrille;
using namespace quadrille::study;
using test::content_of;
using test::TempFolder;

namespace {

/// A small view of a scene, planned on without physics.
Study small_study(int scenes, int threads) {
  Study study;
  study.options = test::study_with("franka");
  study.options.tries = Tries::kNone;
  study.options.detector.threads = 1;
  study.label = label_of(study.options, "1.2.3", "tabletop", "x");
  study.names = test::names_of(scenes);
  study.threads = threads;
  study.input = [names = study.names](std::size_t index) {
    if (names[index].number == 3) throw std::runtime_error("scene 3 is gone");
    const scene::Scene made =
        scene::make_scene({scene::Family::kTabletop, std::stoull(names[index].seed), 320, 240});
    StudyInput input;
    input.cloud.points = made.view.points;
    input.truth = physics::true_scene(scene::truth_json(made));
    return input;
  };
  return study;
}

std::string run(const Study& study, const std::string& path) {
  StudyFiles files(path, study.label, study.names);
  run_study(study, &files);
  return content_of(path) + content_of(scenes_path(path));
}

}  // namespace

TEST_CASE("the rows of a study are the same for any number of threads, and after a stop",
          "[study][determinism]") {
  const TempFolder folder;
  const std::string one = run(small_study(4, 1), folder.path("one.csv"));
  CHECK(one.find("sphere") != std::string::npos);
  CHECK(run(small_study(4, 3), folder.path("three.csv")) == one);
  const std::string part = folder.path("part.csv");
  run(small_study(2, 1), part);
  CHECK(run(small_study(4, 2), part) == one);
}

TEST_CASE("a cloud that cannot be read is a row that says why", "[study][hostile]") {
  const TempFolder folder;
  const std::string text = run(small_study(4, 2), folder.path("a.csv"));
  CHECK(text.find("tabletop 13,13,,") != std::string::npos);
  CHECK(text.find(",scene 3 is gone\n") != std::string::npos);
}

TEST_CASE("shards have every scene once", "[study]") {
  const std::vector<SceneName> names = test::names_of(10);
  std::vector<int> seen(11);
  for (int shard = 1; shard <= 3; ++shard) {
    for (const SceneName& name : shard_of(names, shard, 3)) {
      CHECK((name.number - shard) % 3 == 0);
      ++seen[static_cast<std::size_t>(name.number)];
    }
  }
  CHECK(seen == std::vector<int>{0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  CHECK(shard_of(names, 4, 12).size() == 1);
  CHECK(shard_of(names, 11, 12).empty());
}
