#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "quadrille/bus/status_message.hpp"
#include "view/live/live_scene.hpp"

namespace quadrille::view {
namespace {

using io::Json;

Json fact(const std::string& name, const std::string& value) { return Json::array({name, value}); }

/// Adds the figures that both kinds of status have in common.
/// @param stage  name of the stage that spans all of the work
template <class Status>
void add_figures(const Status& status, const std::string& stage, Json* facts) {
  facts->push_back(fact("comes in", fmt::format("{:.1f} Hz", status.received_rate)));
  facts->push_back(fact("goes out", fmt::format("{:.1f} Hz", status.published_rate)));
  for (const stage_t& s : status.stages) {
    if (s.name != stage) continue;
    facts->push_back(fact("latency", fmt::format("{:.0f} ms (99 %: {:.0f} ms)", s.p50, s.p99)));
  }
  facts->push_back(fact("passed over for newer", fmt::format("{}", status.superseded)));
  if (status.failed > 0) facts->push_back(fact("failed", fmt::format("{}", status.failed)));
  facts->push_back(fact("messages lost", fmt::format("{}", status.transport.dropped_messages)));
  if (status.transport.dropped_datagrams >= 0) {
    facts->push_back(fact("datagrams lost", fmt::format("{}", status.transport.dropped_datagrams)));
  }
  if (status.remembered_views > 0) {
    facts->push_back(fact("views remembered", fmt::format("{}", status.remembered_views)));
    facts->push_back(
        fact("pose corrected by", fmt::format("{:.1f} mm", 1e3 * status.pose_correction)));
  }
}

}  // namespace

Json live_status(const LatestMessages& messages) {
  Json json = Json::object();
  if (messages.detector_status) {
    const auto decoded = bus::decode_detector_status(*messages.detector_status);
    if (const auto* status = std::get_if<detector_status_t>(&decoded)) {
      Json facts = Json::array();
      add_figures(*status, "quadrics", &facts);
      facts.push_back(fact("clouds missing", fmt::format("{}", status->missing)));
      json["detector"] = {{"facts", facts}, {"warnings", status->warnings}};
    }
  }
  if (messages.planner_status) {
    const auto decoded = bus::decode_planner_status(*messages.planner_status);
    if (const auto* status = std::get_if<planner_status_t>(&decoded)) {
      Json facts = Json::array();
      add_figures(*status, "grasps", &facts);
      facts.push_back(fact("clouds missing", fmt::format("{}", status->missing_clouds)));
      facts.push_back(fact("without their cloud", fmt::format("{}", status->unpaired_quadrics)));
      json["planner"] = {{"facts", facts}, {"warnings", status->warnings}};
    }
  }
  return json;
}

}  // namespace quadrille::view
