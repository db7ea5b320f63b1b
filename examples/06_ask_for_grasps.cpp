// Asks quadrille-grasp-planner for grasps on the object nearest to a point, given in the frame of
// the planner's results:
//   06_ask_for_grasps X Y Z [TIMES [LCM_URL]]
// It needs a planner that has a cloud, best started with --on-request. The exit status is 1 if a
// request is not answered within 5 s.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <optional>
#include <random>
#include <string>

using Clock = std::chrono::steady_clock;

/// Sends a request and waits for its answer.
class Asker {
 public:
  explicit Asker(lcm::LCM& lcm) : lcm_(lcm) { lcm_.subscribe("GRASPS", &Asker::on_grasps, this); }

  /// Returns nullopt if no answer came in time.
  std::optional<quadrille::grasps_t> ask(quadrille::grasp_request_t request) {
    // Other clients may ask at the same time, so the ids must differ from theirs.
    request.utime = std::chrono::duration_cast<std::chrono::microseconds>(
                        std::chrono::system_clock::now().time_since_epoch())
                        .count();
    request.request_id = (first_id_ << 32) + ++asked_;
    wanted_ = request.request_id;
    answer_.reset();
    lcm_.publish("GRASP_REQUEST", &request);
    const auto end = Clock::now() + std::chrono::seconds(5);
    while (!answer_ && Clock::now() < end) {
      if (lcm_.handleTimeout(100) < 0) break;
    }
    return answer_;
  }

 private:
  void on_grasps(const lcm::ReceiveBuffer*, const std::string&, const quadrille::grasps_t* m) {
    if (m->request_id == wanted_) answer_ = *m;
  }

  lcm::LCM& lcm_;
  std::int64_t first_id_ = std::random_device()() >> 1, asked_ = 0, wanted_ = 0;
  std::optional<quadrille::grasps_t> answer_;
};

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: 06_ask_for_grasps X Y Z [TIMES [LCM_URL]]\n";
    return 2;
  }
  lcm::LCM lcm(argc > 5 ? argv[5] : "");
  if (!lcm.good()) {
    std::cerr << "LCM cannot open its address; see 05_listen_grasps.cpp\n";
    return 1;
  }
  quadrille::grasp_request_t request{};
  request.has_near = 1;
  for (int i = 0; i < 3; ++i) request.near[i] = std::atof(argv[1 + i]);
  request.max_grasps = 3;
  Asker asker(lcm);
  const int times = argc > 4 ? std::atoi(argv[4]) : 1;
  for (int n = 0; n < times; ++n) {
    const auto start = Clock::now();
    const auto answer = asker.ask(request);
    if (!answer) {
      std::cerr << "no answer within 5 s: is quadrille-grasp-planner running?\n";
      return 1;
    }
    const std::chrono::duration<double, std::milli> waited = Clock::now() - start;
    std::cout << "cloud " << answer->utime << " us, " << waited.count() << " ms, grasps:";
    for (const quadrille::grasp_t& grasp : answer->grasps) {
      std::cout << "  on " << grasp.target << " score " << grasp.score;
    }
    if (answer->grasps.empty()) {
      for (const quadrille::count_t& refused : answer->rejected) {
        std::cout << "  refused " << refused.count << ": " << refused.name;
      }
    }
    for (const std::string& warning : answer->warnings) std::cout << "  " << warning;
    std::cout << '\n';
  }
}
