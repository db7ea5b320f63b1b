// Makes the logs of the end-to-end test and checks what was recorded.
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "tool.hpp"

namespace {

void run(const std::vector<std::string>& words) {
  using namespace quadrille::e2e;
  const std::string command = words.empty() ? "" : words[0];
  if (command == "make-logs" && words.size() == 2) return make_logs(words[1]);
  if (command == "check-quadrics" && words.size() == 2) return check_quadrics(words[1]);
  if (command == "check-status" && words.size() == 2) return check_status(words[1], false);
  if (command == "check-hostile-status" && words.size() == 2) return check_status(words[1], true);
  if (command == "check-same" && words.size() == 4) return check_same(words[1], words[2], words[3]);
  if (command == "check-copy" && words.size() == 3) return check_copy(words[1], words[2]);
  if (command == "rename-channel" && words.size() == 5) {
    return rename_channel(words[1], words[2], words[3], words[4]);
  }
  if (command == "check-plan" && words.size() == 3) return check_plan(words[1], words[2]);
  if (command == "check-plan-elsewhere" && words.size() == 3) {
    return check_plan(words[1], words[2], true);
  }
  if (command == "load" && words.size() >= 6) {
    return put_under_load(words[1], words[2],
                          {std::stoi(words[3]), std::stoi(words[4]), std::stod(words[5]),
                           words.size() > 6 && words[6] == "lossy"});
  }
  if (command == "hostile" && words.size() >= 5) {
    return send_hostile(words[1], words[2],
                        {std::stol(words[3]), std::stoi(words[4]),
                         words.size() > 5 ? std::stoi(words[5]) : Hostile{}.at_once});
  }
  if (command == "make-poses" && words.size() == 6) {
    return make_pose_log(words[1], {std::stoi(words[2]), std::stoi(words[3]), std::stoi(words[4]),
                                    std::stoi(words[5])});
  }
  if (command == "check-poses" && words.size() == 4) {
    return check_poses(words[1], {std::stoul(words[2]), std::stoul(words[3])});
  }
  if (command == "check-equal" && words.size() == 3) return check_equal_results(words[1], words[2]);
  if (command == "check-remembered" && words.size() == 3) {
    return check_remembered(words[1], words[2]);
  }
  if (command == "make-cameras" && words.size() == 2) return make_camera_logs(words[1]);
  if (command == "check-cameras" && words.size() == 3) return check_cameras(words[1], words[2]);
  if (command == "check-own-hand" && words.size() == 3) return check_own_hand(words[1], words[2]);
  throw std::invalid_argument(
      "use: make-logs FOLDER | check-quadrics LOG | check-status LOG | check-hostile-status LOG | "
      "check-same LIVE OFFLINE CHANNEL | check-copy SOURCE COPY | check-plan LOG JSON | "
      "check-plan-elsewhere LOG JSON | "
      "rename-channel SOURCE COPY FROM TO | load URL LOG BURSTS CLOUDS HZ [lossy] | "
      "hostile URL LOG MESSAGES SEED [AT_ONCE] | "
      "make-poses LOG CLOUDS PERCENT_DISORDERED POSES_LATE_MS CLOUDS_LATE_MS | "
      "check-poses LOG PLACED REFUSED | check-equal LOG LOG | check-remembered LOG LOG | "
      "make-cameras FOLDER | check-cameras TWO ONE | check-own-hand TOLD UNTOLD");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "e2e_tool: %s\n", error.what());
    return 1;
  }
}
