// Publishes one cloud as drake.lcmt_point_cloud, as a camera driver would:
//   04_publish_cloud [LCM_URL]
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <string>
#include <vector>

// The near half of a ball of 5 cm radius, 60 cm in front of the camera: x, y, z of each point [m].
std::vector<float> half_ball() {
  std::vector<float> xyz;
  for (double polar = 0.02; polar < M_PI / 2.0; polar += 0.02) {
    for (double azimuth = 0.0; azimuth < 2.0 * M_PI; azimuth += 0.02 / std::sin(polar)) {
      xyz.push_back(static_cast<float>(0.05 * std::sin(polar) * std::cos(azimuth)));
      xyz.push_back(static_cast<float>(0.05 * std::sin(polar) * std::sin(azimuth)));
      xyz.push_back(static_cast<float>(0.6 - 0.05 * std::cos(polar)));
    }
  }
  return xyz;
}

drake::lcmt_point_cloud to_message(const std::vector<float>& xyz) {
  drake::lcmt_point_cloud message{};
  message.utime = 1'000'000;
  message.frame_name = "camera";
  message.width = static_cast<std::int64_t>(xyz.size() / 3);
  message.height = 1;
  for (const char* name : {"x", "y", "z"}) {
    drake::lcmt_point_cloud_field field{};
    field.name = name;
    field.byte_offset = 4 * message.num_fields++;
    field.datatype = drake::lcmt_point_cloud::FLOAT32;
    field.count = 1;
    message.fields.push_back(field);
  }
  message.point_step = 12;
  message.row_step = 12 * message.width;
  message.data_size = message.row_step;
  message.data.resize(xyz.size() * sizeof(float));
  std::memcpy(message.data.data(), xyz.data(), message.data.size());
  return message;
}

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
  const drake::lcmt_point_cloud message = to_message(half_ball());
  lcm.publish("POINT_CLOUD", &message);
  std::cout << "published " << message.width << " points on POINT_CLOUD\n";
}
