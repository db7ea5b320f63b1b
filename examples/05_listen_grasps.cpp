// Prints the grasps that quadrille-grasp-planner publishes, until Ctrl-C or the end of a log:
//   05_listen_grasps [LCM_URL]        e.g. "file://recorded.lcm?speed=0"
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <string>

struct Printer {
  static constexpr std::size_t kShown = 5;

  void on_grasps(const lcm::ReceiveBuffer*, const std::string&,
                 const quadrille::grasps_t* message) {
    // Answers to requests may cover only some targets: see 06_ask_for_grasps.cpp.
    if (message->request_id != 0) return;
    std::cout << "cloud " << message->utime << " us, hand " << message->gripper
              << ", grasps: " << message->num_grasps << '\n';
    const std::size_t shown = std::min(message->grasps.size(), kShown);
    for (std::size_t i = 0; i < shown; ++i) print(message->grasps[i]);
    for (const std::string& warning : message->warnings) std::cout << "      " << warning << '\n';
    if (shown == 0) {
      for (const quadrille::count_t& refused : message->rejected) {
        std::cout << "      " << refused.count << " refused: " << refused.name << '\n';
      }
    }
    std::cout << std::flush;
  }

  static void print(const quadrille::grasp_t& grasp) {
    std::cout << std::fixed << std::setprecision(2) << "      on quadric " << grasp.target
              << "  score " << grasp.score << "  at [m]" << std::setprecision(3);
    for (const double value : grasp.pose.position) std::cout << std::setw(8) << value;
    std::cout << std::setprecision(0) << "  width " << 1000.0 * grasp.width << " mm  clearance "
              << 1000.0 * grasp.clearance << " mm\n";
  }
};

int main(int argc, char** argv) {
  const std::string url = argc > 1 ? argv[1] : "";  // "" means $LCM_DEFAULT_URL
  lcm::LCM lcm(url);
  if (!lcm.good()) {
    std::cerr << "LCM cannot open " << (url.empty() ? "its default address" : url) << '\n';
    if (url.empty() || url.starts_with("udpm:")) {
      std::cerr << "is there a multicast route? (ip route add 224.0.0.0/4 dev lo)\n";
    }
    return 1;
  }
  Printer printer;
  lcm.subscribe("GRASPS", &Printer::on_grasps, &printer);
  while (lcm.handle() == 0) {
  }
}
