#include "quadrille/spy_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/process_arguments.hpp"

namespace quadrille {
namespace {

namespace fs = std::filesystem;

struct SpyArguments {
  std::string url;
  /// Jar files with the classes of further messages.
  std::vector<std::string> jars;
};

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Returns the path of a file in the first of the folders that has it.
std::optional<fs::path> find_in(const std::vector<fs::path>& folders, const char* file) {
  std::error_code ignored;
  for (const fs::path& folder : folders) {
    if (!folder.empty() && fs::exists(folder / file, ignored)) return folder / file;
  }
  return std::nullopt;
}

std::optional<fs::path> find_java() {
  std::vector<fs::path> folders;
  std::istringstream list(variable("PATH"));
  for (std::string folder; std::getline(list, folder, ':');) folders.emplace_back(folder);
  return find_in(folders, "java");
}

/// Returns true if this Java is a version for machines without a screen.
bool is_headless(const fs::path& java) {
  std::error_code ignored;
  const fs::path libraries = fs::canonical(java, ignored).parent_path().parent_path() / "lib";
  return fs::exists(libraries / "libawt_headless.so", ignored) &&
         !fs::exists(libraries / "libawt_xawt.so", ignored);
}

/// Finds the messages' jar beside this program, as it was built or installed.
fs::path find_messages() {
  std::error_code ignored;
  const fs::path above = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  const auto jar = find_in({above / "java", above / "share/java"}, "quadrille-lcmtypes.jar");
  if (jar) return *jar;
  throw std::runtime_error(
      "spy: there is no quadrille-lcmtypes.jar; install default-jdk-headless and liblcm-java, and "
      "build anew");
}

/// Returns the Java program to run and its class path. Debian's own lcm-spy cannot be used, because
/// it passes an option to Java that no longer exists.
std::pair<std::string, std::string> java_and_classes(const SpyArguments& arguments) {
  const std::vector<fs::path> folders = {"/usr/share/java", "/usr/local/share/java"};
  const auto java = find_java(), lcm = find_in(folders, "lcm.jar"),
             charts = find_in(folders, "jchart2d.jar");
  std::string missing;
  if (!java || is_headless(*java)) missing += " default-jre";
  if (!lcm) missing += " liblcm-java";
  if (!charts) missing += " libjchart2d-java";
  if (!missing.empty()) {
    throw std::runtime_error(
        fmt::format("spy: lcm-spy needs more packages: apt-get install{}", missing));
  }
  std::string classes =
      fmt::format("{}:{}:{}", lcm->string(), find_messages().string(), charts->string());
  for (const std::string& jar : arguments.jars) classes += ":" + jar;
  const std::string others = variable("CLASSPATH");
  if (!others.empty()) classes += ":" + others;
  return {java->string(), classes};
}

void spy(const SpyArguments& arguments) {
  const auto [java, classes] = java_and_classes(arguments);
  if (variable("DISPLAY").empty()) {
    throw std::runtime_error("spy: there is no screen; set DISPLAY, or log in with ssh -X");
  }
  std::vector<std::string> words = {java, "-Djava.net.preferIPv4Stack=true", "-cp", classes,
                                    "lcm.spy.Spy"};
  if (!arguments.url.empty()) words.push_back("--lcm-url=" + arguments.url);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(java.c_str(), argv.data());
  throw std::runtime_error(fmt::format("spy: {} does not start ({}); reinstall default-jre", java,
                                       std::strerror(errno)));
}

}  // namespace

void add_spy_command(CLI::App& app) {
  auto arguments = std::make_shared<SpyArguments>();
  CLI::App* command = app.add_subcommand(
      "spy", "Show all messages on the bus, decoded, in the window of lcm-spy (needs Java)");
  add_address_option(*command, arguments->url);
  command->add_option("--jar", arguments->jars, "Classes of more messages")
      ->check(CLI::ExistingFile.description(""))
      ->type_name("FILE.jar");
  command->callback([arguments] { spy(*arguments); });
}

}  // namespace quadrille
