#include "quadrille/doctor_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "cli/output.hpp"
#include "cli/process_arguments.hpp"
#include "doctor/examine.hpp"
#include "doctor/report.hpp"
#include "link/channel_pattern.hpp"
#include "link/url.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille {
namespace {

struct DoctorArguments {
  doctor::Questions questions;
  std::string json;
};

/// Refuses channels that the processes refuse too.
void check_channels(const doctor::Questions& questions) {
  check_distinct(
      {{"--cloud-channel", questions.cloud_channel}, {"--pose-channel", questions.pose_channel}});
  if (questions.pose_channel.empty()) return;
  if (bus::ChannelPattern(questions.cloud_channel).is_pattern()) {
    throw CLI::ValidationError("--cloud-channel",
                               "a pattern stands for several cameras, and poses are those of one; "
                               "ask for each camera by itself");
  }
}

void run(DoctorArguments arguments) {
  doctor::Questions& questions = arguments.questions;
  const std::string given = questions.url;
  questions.url = bus::resolve_url(given);
  questions.cloud_channel = with_prefix(questions.channel_prefix, questions.cloud_channel);
  questions.pose_channel = with_prefix(questions.channel_prefix, questions.pose_channel);
  check_channels(questions);
  JsonLines json(arguments.json);
  const doctor::Findings findings = doctor::examine(questions);
  json.write(doctor::to_json(questions.url, findings));
  json.finish();
  if (!json.owns_stdout()) print(doctor::to_table(findings));
  check_address(given);
  if (doctor::has_failure(findings)) {
    throw std::runtime_error("doctor: " + doctor::describe_failure(findings) +
                             "; mend what has failed");
  }
}

}  // namespace

void add_doctor_command(CLI::App& app) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command =
      app.add_subcommand("doctor",
                         "Check the network: will clouds arrive over LCM? Sends ten messages as "
                         "large as a cloud, and some small ones, on this machine's bus");
  doctor::Questions& questions = arguments->questions;
  add_address_option(*command, questions.url);
  add_pattern_option(*command, "--cloud-channel", questions.cloud_channel, "clouds");
  add_channel_option(*command, "--pose-channel", questions.pose_channel,
                     "camera's poses (bot_core.pose_t), which are then checked too");
  add_prefix_option(*command, questions.channel_prefix);
  command
      ->add_option("--cloud-bytes", questions.cloud_bytes,
                   "Size of the clouds; else the largest seen on the bus, or 640x480 points")
      ->check(CLI::Range(std::size_t{1}, bus::kMaxMessageBytes))
      ->type_name("N");
  command->add_option("--seconds", questions.seconds, "How long to listen to the bus")
      ->check(CLI::Range(0.1, 3600.0))
      ->type_name("S")
      ->capture_default_str();
  command->add_option("--json", arguments->json, "Write the findings as JSON; - is stdout")
      ->type_name("FILE");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
