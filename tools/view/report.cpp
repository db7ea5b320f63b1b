#include "view/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "view/assets.hpp"
#include "view/base64.hpp"

namespace quadrille::view {
namespace {

std::string_view asset(const std::string& name) {
  const std::vector<Asset>& all = assets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Asset& a) { return a.name == name; });
  if (found == all.end()) throw std::logic_error(fmt::format("the page has no {}", name));
  return found->content;
}

/// Replaces a text, which must occur.
void replace(std::string* page, std::string_view old, std::string_view with) {
  const std::size_t at = page->find(old);
  if (at == std::string::npos) throw std::logic_error(fmt::format("the page has no {}", old));
  page->replace(at, old.size(), with);
}

/// Replaces each `before NAME after` in the page by the text of the asset NAME.
/// @return the hashes of those texts, for the policy
std::string put_in(std::string* page, std::string_view before, std::string_view after,
                   std::string_view tag) {
  std::string hashes;
  for (std::size_t at = page->find(before); at != std::string::npos; at = page->find(before, at)) {
    const std::size_t begin = at + before.size(), end = page->find(after, begin);
    const std::string_view text = asset(page->substr(begin, end - begin));
    const std::string element = fmt::format("<{0}>{1}</{0}>", tag, text);
    page->replace(at, end + after.size() - at, element);
    hashes += fmt::format(" {}", policy_hash(text));
    at += element.size();
  }
  return hashes;
}

/// Returns JSON that is safe inside a page: none of its characters begins markup.
std::string text_in_page(const io::Json& json) {
  const std::string text = json.dump(-1, ' ', true, io::Json::error_handler_t::replace);
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string data_element(const std::string& id, const std::string& text) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, text);
}

io::Json json_of(const ReportTable& table) {
  const std::size_t count = table.rows.size(), told = std::min(count, Report::kMaxRows);
  const std::string title =
      told == count ? table.title : fmt::format("{}: the first {} of {}", table.title, told, count);
  io::Json rows = io::Json::array();
  for (std::size_t i = 0; i < told; ++i) rows.push_back(table.rows[i]);
  return {{"title", title}, {"columns", table.columns}, {"rows", rows}};
}

}  // namespace

Report::Report(std::string title, std::string command, std::string settings)
    : title_(std::move(title)),
      command_(std::move(command)),
      settings_(std::move(settings)),
      objects_(objects_table()),
      grasps_(grasps_table()) {}

void Report::add_scene(const Scene& scene, bool several) {
  add_rows(scene, &objects_, &grasps_);
  if (scene_bytes_ >= kMaxSceneBytes) {
    ++left_out_;
    return;
  }
  PackLimits limits;
  if (several) limits.points = kPointsOfMany;
  packs_.push_back(base64(pack_scene(scene, limits)));
  scene_bytes_ += packs_.back().size();
  names_.push_back(scene.name);
  utimes_.push_back(scene.utime);
}

std::string Report::left_out() const {
  if (left_out_ == 0) return "";
  return fmt::format("the last {} clouds are not shown: a page can hold no more", left_out_);
}

std::string Report::session() const {
  io::Json tables = io::Json::array();
  for (const ReportTable& table : tables_) tables.push_back(json_of(table));
  for (const ReportTable* table : {&objects_, &grasps_}) {
    if (!table->rows.empty()) tables.push_back(json_of(*table));
  }
  std::vector<std::string> notes = notes_;
  if (left_out_ > 0) {
    notes.push_back(
        fmt::format("the last {} clouds are not shown: a page can hold no more", left_out_));
  }
  return text_in_page({{"mode", "report"},
                       {"name", title_},
                       {"frames", utimes_},
                       {"names", names_},
                       {"tables", tables},
                       {"notes", notes},
                       {"command", command_},
                       {"settings", settings_}});
}

std::string Report::html() const {
  std::string page(asset(""));
  const std::string styles = put_in(&page, "<link rel=\"stylesheet\" href=\"", "\">", "style");
  const std::string scripts = put_in(&page, "<script src=\"", "\"></script>", "script");
  const std::string icon =
      fmt::format("href=\"data:image/svg+xml;base64,{}\"", base64(asset("icon.svg")));
  replace(&page, "href=\"icon.svg\"", icon);
  const std::string policy = fmt::format(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src{}; script-src{}; base-uri 'none'; form-action 'none'\">\n<title>",
      styles, scripts);
  replace(&page, "<title>", policy);
  std::string data = data_element("report", session());
  for (std::size_t n = 0; n < packs_.size(); ++n) {
    data += data_element(fmt::format("scene-{}", n), packs_[n]);
  }
  // Scripts run where they stand, so the data that they read must come before them.
  replace(&page, "<script>", data + "<script>");
  return page;
}

}  // namespace quadrille::view
