#include "view/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"
#include "view/base64.hpp"

using namespace quadrille;

namespace {

view::Scene scene_of(const std::string& name, std::size_t points) {
  view::Scene scene;
  scene.name = name;
  scene.cloud.frame = "camera";
  for (std::size_t i = 0; i < points; ++i) {
    scene.cloud.points.emplace_back(0.001f * static_cast<float>(i % 640),
                                    0.001f * static_cast<float>(i / 640), 1.0f);
  }
  scene.cloud.read = points;
  return scene;
}

/// The text of the element of that id.
std::string data_of(const std::string& page, const std::string& id) {
  const std::string begin = fmt::format("<script type=\"text/plain\" id=\"{}\">", id);
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) return "";
  return page.substr(at + begin.size(), page.find("</script>", at) - at - begin.size());
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

}  // namespace

TEST_CASE("base64 and hashes are those of the standards", "[view][report]") {
  // RFC 4648, section 10.
  CHECK(view::base64("") == "");
  CHECK(view::base64("f") == "Zg==");
  CHECK(view::base64("fo") == "Zm8=");
  CHECK(view::base64("foobar") == "Zm9vYmFy");
  // Longer than what is encoded at once: nothing is padded in between.
  const std::string text = view::base64(std::string((3 << 20) + 1, '\0'));
  CHECK(text.size() == (4u << 20) + 4);
  CHECK(text.find('=') == text.size() - 2);
  // The example of Content Security Policy Level 3, section 2.3.1.
  CHECK(view::policy_hash("alert('Hello, world.');") ==
        "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

TEST_CASE("a report is one file that needs nothing else", "[view][report]") {
  view::Report report("mug.pcd", "quadrille plan mug.pcd", "[search]\nbases = 12\n");
  report.add_scene(scene_of("mug.pcd", 640 * 480), false);
  report.add_table({"Shares", {"what", "share"}, {{"good", "97 %"}}});
  const std::string page = report.html();
  CHECK(page.size() < 5'000'000);
  CHECK(page.find(" src=\"") == std::string::npos);
  CHECK(page.find("<link rel=\"stylesheet\"") == std::string::npos);
  const auto session = nlohmann::json::parse(data_of(page, "report"));
  CHECK(session["mode"] == "report");
  CHECK(session["names"][0] == "mug.pcd");
  CHECK(session["tables"][0]["rows"][0][1] == "97 %");
  CHECK(session["settings"] == "[search]\nbases = 12\n");
  // base64 of "QVW1", with which each scene begins.
  CHECK(data_of(page, "scene-0").starts_with("UVZXM"));
  CHECK(data_of(page, "scene-1").empty());
}

TEST_CASE("a table of a report has no more rows than a browser shows in good time",
          "[view][report]") {
  constexpr std::size_t kMost = view::Report::kMaxRows;
  view::Report report("log", "", "");
  report.add_table({"Whole", {"row"}, std::vector(kMost, std::vector<std::string>{"a"})});
  report.add_table({"Cut", {"row"}, std::vector(kMost + 5, std::vector<std::string>{"a"})});
  const auto session = nlohmann::json::parse(data_of(report.html(), "report"));
  CHECK(session["tables"][0]["title"] == "Whole");
  CHECK(session["tables"][0]["rows"].size() == kMost);
  CHECK(session["tables"][1]["title"] == fmt::format("Cut: the first {} of {}", kMost, kMost + 5));
  CHECK(session["tables"][1]["rows"].size() == kMost);
}

TEST_CASE("the policy of a report names each of its scripts, and allows nothing else",
          "[view][report][safety]") {
  view::Report report("a", "", "");
  const std::string page = report.html();
  const std::size_t at = page.find("Content-Security-Policy");
  REQUIRE(at != std::string::npos);
  const std::string policy = page.substr(at, page.find("\n", at) - at);
  CHECK(policy.find("default-src 'none'") != std::string::npos);
  CHECK(policy.find("unsafe") == std::string::npos);
  std::size_t named = 0;
  for (std::size_t begin = page.find("<script>"); begin != std::string::npos;
       begin = page.find("<script>", begin + 1)) {
    const std::size_t text = begin + std::string("<script>").size();
    const std::string script = page.substr(text, page.find("</script>", text) - text);
    CHECK(policy.find(view::policy_hash(script)) != std::string::npos);
    ++named;
  }
  CHECK(named == 6);
  // The policy stands before all that it is for.
  CHECK(at < page.find("<style>"));
}

TEST_CASE("no name in a report becomes markup", "[view][report][safety][hostile]") {
  const std::string hostile = "</script><img src=x onerror=alert(1)>\xff\xfe<!--";
  view::Report report(hostile, hostile, hostile);
  view::Scene scene = scene_of(hostile, 10);
  scene.cloud.frame = hostile;
  scene.warnings = {hostile};
  report.add_scene(scene, false);
  report.add_note(hostile);
  report.add_table({hostile, {hostile}, {{hostile}}});
  const std::string page = report.html();
  const std::string plain = view::Report("a", "", "").html();
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("<!--") == plain.find("<!--"));
  // One more for the scene.
  CHECK(count(page, "</script>") == count(plain, "</script>") + 1);
  const auto session = nlohmann::json::parse(data_of(page, "report"));
  CHECK(session["name"].get<std::string>().starts_with("</script><img"));
}

TEST_CASE("a report of very many clouds stays of a size that browsers open", "[view][report]") {
  view::Report report("log", "", "");
  const view::Scene scene = scene_of("cloud", 640 * 480);
  for (int i = 0; i < 200; ++i) report.add_scene(scene, true);
  const std::string page = report.html();
  CHECK(page.size() < view::Report::kMaxSceneBytes + 3'000'000);
  const auto session = nlohmann::json::parse(data_of(page, "report"));
  const std::size_t shown = session["frames"].size();
  CHECK(shown > 10);
  CHECK(session["notes"][0].get<std::string>().find(fmt::format("{} clouds", 200 - shown)) !=
        std::string::npos);
}
