// Reports on the planner's node: status messages, statistics, the last line of a run.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "process/planner/node.hpp"
#include "process/planner/status_text.hpp"
#include "process/runtime/status/status.hpp"
#include "process/runtime/watch/other_senders.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

std::string PlannerNode::publish_status(const RunState& run) {
  planner_status_t status{};
  fill_counts(&status);
  write_common(run, settings_hash_, &status);
  publish_(settings_.status_channel, bus::encode(status));
  return to_exposition(status, settings_);
}

void PlannerNode::fill_counts(planner_status_t* filled) {
  const std::lock_guard lock(mutex_);
  planner_status_t& status = *filled;
  status = counts_;
  status.sender = own_sender();
  status.missing_clouds = gaps_.missing();
  status.received_rate = received_rate_.update(counts_.received_clouds);
  status.published_rate = published_rate_.update(counts_.published);
  status.paired = pairing_.paired();
  status.unpaired_quadrics = pairing_.unpaired();
  status.unpaired = pairing_.count_unpaired();
  status.num_unpaired = static_cast<std::int32_t>(status.unpaired.size());
  status.failed = failed();
  status.cut = planner_.cut();
  status.remembered_views = planner_.views();
  status.pose_correction = planner_.correction();
  status.requests = requests_;
  status.unmet = unmet_;
  status.rejected_clouds = bus::to_message(refused_clouds_.counts());
  status.num_rejected_clouds = static_cast<std::int32_t>(status.rejected_clouds.size());
  status.rejected_quadrics = bus::to_message(refused_quadrics_.counts());
  status.num_rejected_quadrics = static_cast<std::int32_t>(status.rejected_quadrics.size());
  status.rejected_requests = bus::to_message(refused_requests_.counts());
  status.num_rejected_requests = static_cast<std::int32_t>(status.rejected_requests.size());
  status.rejected_poses = bus::to_message(refused_poses_.counts());
  status.num_rejected_poses = static_cast<std::int32_t>(status.rejected_poses.size());
  status.rejected_knowledge = bus::to_message(refused_knowledge_.counts());
  status.num_rejected_knowledge = static_cast<std::int32_t>(status.rejected_knowledge.size());
  status.pose_age = posed_clouds_.last_age_ms();
  status.unplaced = posed_clouds_.count_poseless();
  status.num_unplaced = static_cast<std::int32_t>(status.unplaced.size());
  posed_views_.fill(&status);
  set_stages(stages_, filled);
}

std::string PlannerNode::summary() const {
  const std::lock_guard lock(mutex_);
  const std::string poses = settings_.pose_channel.empty()
                                ? ""
                                : fmt::format("poses in: {}, {}; ", posed_clouds_.poses(),
                                              describe(refused_poses_.counts()));
  const std::string requests = requests_ == 0
                                   ? ""
                                   : fmt::format("; requests: {}, {}, unmet: {}", requests_,
                                                 describe(refused_requests_.counts()), unmet_);
  return fmt::format(
      "clouds in: {}, {}; messages of quadrics in: {}, {}; {}pairs: {}; grasps out: {}{}",
      counts_.received_clouds, describe(refused_clouds_.counts()), counts_.received_quadrics,
      describe(refused_quadrics_.counts()), poses, pairing_.paired(), grasps_, requests);
}

std::vector<std::string> PlannerNode::find_oddities() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> oddities;
  if (pairing_.paired() == 0) {
    oddities.push_back(
        "no quadrics with their cloud; make it with quadrille-detector --copy-input");
  }
  const std::int64_t paired = pairing_.paired(), unpaired = pairing_.unpaired();
  if (paired > 0 && unpaired > 0) {
    oddities.push_back(fmt::format(
        "{} of {} messages of quadrics have no cloud of theirs ({}) and were not planned on",
        unpaired, counts_.decoded_quadrics, list_counts(pairing_.count_unpaired())));
  }
  if (paired > 0 && counts_.decoded_clouds > paired) {
    oddities.push_back(fmt::format("{} of {} clouds have no quadrics and were not planned on",
                                   counts_.decoded_clouds - paired, counts_.decoded_clouds));
  }
  if (refused_bodies_.counts().total() > 0) {
    oddities.push_back(fmt::format("of the messages of bodies {}; nothing was planned on lumps",
                                   describe(refused_bodies_.counts())));
  }
  if (refused_boxes_.counts().total() > 0) {
    oddities.push_back(fmt::format("of the messages of boxes {}; their boxes were sought anew",
                                   describe(refused_boxes_.counts())));
  }
  if (refused_knowledge_.counts().total() > 0) {
    oddities.push_back(fmt::format("of the messages on the robot and its surroundings {}",
                                   describe(refused_knowledge_.counts())));
  }
  for (std::string& oddity : posed_views_.find_oddities()) oddities.push_back(std::move(oddity));
  if (const std::string oddity = posed_clouds_.find_oddity(counts_.decoded_clouds);
      !oddity.empty()) {
    oddities.push_back(oddity);
  }
  return oddities;
}

}  // namespace quadrille
