#pragma once

#include <chrono>
#include <cstdint>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/planner/knowledge.hpp"
#include "process/planner/map_publisher.hpp"
#include "process/planner/messages.hpp"
#include "process/planner/pair_planner.hpp"
#include "process/planner/pairing.hpp"
#include "process/planner/recent_messages.hpp"
#include "process/planner/recent_pairs.hpp"
#include "process/planner/settings.hpp"
#include "process/runtime/limited_log.hpp"
#include "process/runtime/node.hpp"
#include "process/runtime/poses/posed_clouds.hpp"
#include "process/runtime/poses/posed_views.hpp"
#include "process/runtime/refusals.hpp"
#include "process/runtime/status/rate.hpp"
#include "process/runtime/status/stages.hpp"
#include "process/runtime/viewer.hpp"
#include "process/runtime/watch/sequence_gaps.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/request_message.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// Plans grasps on clouds and the quadrics found in them: on every cloud, or only on request.
class PlannerNode : public Node {
 public:
  PlannerNode(const PlannerSettings& settings, bus::Publish publish);

  std::vector<InChannel> in_channels() const override;
  std::vector<OutChannel> out_channels() const override;
  std::optional<Job> receive(const std::string& channel, std::span<const std::byte> bytes) override;
  std::vector<Job> find_due_jobs(Time now) override;
  std::optional<Job> find_spare_job() override;
  std::string publish_status(const RunState& run) override;
  std::string summary() const override;
  std::vector<std::string> find_oddities() const override;

 private:
  using SharedPair = PairPlanner::SharedPair;

  std::optional<Job> receive_cloud(const std::string& channel, std::span<const std::byte> bytes);
  std::optional<Job> receive_quadrics(const std::string& channel, std::span<const std::byte> bytes);
  void receive_boxes(const std::string& channel, std::span<const std::byte> bytes);
  void receive_bodies(const std::string& channel, std::span<const std::byte> bytes);
  void receive_body_tracks(const std::string& channel, std::span<const std::byte> bytes);
  std::optional<Job> receive_view(int camera, std::span<const std::byte> bytes);
  std::optional<Job> receive_request(const std::string& channel, std::span<const std::byte> bytes);
  std::optional<Job> pair_quadrics(const bus::QuadricsMessage& quadrics, const OtherThings& others);
  std::optional<Job> make_job(std::optional<CloudAndQuadrics> pair);
  std::optional<Job> receive_forget(const std::string& channel, std::span<const std::byte> bytes);
  std::optional<Known> known_about(const CloudAndQuadrics& pair, GraspPlan* without);
  void remember(const SharedPair& pair);
  void remember_view(int camera, const bus::CloudMessage& cloud, const CameraPose& pose);
  void forget(const forget_t& message);
  void plan_and_publish(const SharedPair& pair);
  void answer(const grasp_request_t& request, std::chrono::steady_clock::time_point at);
  void refuse(const grasp_request_t& request, const SharedPair& pair, const std::string& why);
  void publish_answer(const grasp_request_t& request, const SharedPair& pair,
                      const GraspPlan& plan);
  template <class Message>
  std::int64_t publish(const std::string& channel, const Message& message);
  std::int64_t publish_maps(const Stamp& stamp, const GraspPlan& plan,
                            const Eigen::Isometry3d& X_RK);
  void fill_counts(planner_status_t* status);

  const PlannerSettings settings_;
  const bus::Publish publish_;
  const std::string settings_hash_;

  mutable std::mutex mutex_;
  Pairing pairing_;
  RecentMessages<bus::BoxesMessage> boxes_;
  RecentMessages<bus::BodiesMessage> bodies_;
  RecentMessages<bus::BodyTracksMessage> body_tracks_;
  RecentPairs recent_;
  planner_status_t counts_{};
  std::int64_t grasps_ = 0;
  PosedClouds posed_clouds_;
  /// The clouds of further cameras.
  PosedViews posed_views_;
  std::int64_t requests_ = 0, unmet_ = 0;
  Refusals refused_clouds_, refused_quadrics_, refused_boxes_, refused_bodies_;
  Refusals refused_poses_, refused_requests_, refused_knowledge_;
  Knowledge knowledge_;
  LimitedLog unpaired_log_;
  SequenceGaps gaps_;
  Stages stages_{{"decode", "wait", "plan", "grasps", "maps"}};
  Rate received_rate_, published_rate_;
  // These are used by the working thread only.
  PairPlanner planner_;
  MapPublisher occupancies_;
  /// The viewer, if --viz is given.
  std::optional<Viewer> viewer_;
};

}  // namespace quadrille
