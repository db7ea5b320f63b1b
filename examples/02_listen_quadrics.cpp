// Prints the quadrics that quadrille-detector publishes, until Ctrl-C or the end of a log:
//   02_listen_quadrics [LCM_URL]        e.g. "file://recorded.lcm?speed=0"
#include <iomanip>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <string>

struct Printer {
  void on_quadrics(const lcm::ReceiveBuffer*, const std::string&,
                   const quadrille::quadrics_t* message) {
    std::cout << "cloud " << message->utime << " us, frame '" << message->frame
              << "', quadrics: " << message->num_detections << '\n';
    for (const quadrille::quadric_t& found : message->detections) print(found);
    std::cout << std::flush;
  }

  static void print(const quadrille::quadric_t& found) {
    std::cout << std::fixed << std::setw(4) << found.id << "  " << std::left << std::setw(22)
              << found.type << std::right << " score " << std::setprecision(2) << found.score
              << "  at [m]" << std::setprecision(3);
    for (const double value : found.pose.position) std::cout << std::setw(8) << value;
    std::cout << std::setprecision(4);
    for (const quadrille::dimension_t& dimension : found.dimensions) {
      std::cout << "  " << dimension.name << ' ' << dimension.value << " ± " << dimension.std;
    }
    std::cout << '\n';
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
  lcm.subscribe("QUADRICS", &Printer::on_quadrics, &printer);
  while (lcm.handle() == 0) {
  }
}
