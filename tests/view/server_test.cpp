#include "view/server.hpp"

#include <fmt/format.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <span>
#include <thread>

#include "io/gzip.hpp"
#include "support/catch.hpp"
#include "view/http/http_server.hpp"
#include "view/http_client.hpp"
#include "view/scene/pack.hpp"

using namespace quadrille;

namespace {

/// Serves one large cloud and, as the name of all, whatever it is given.
class FakeBackend : public view::Backend {
 public:
  explicit FakeBackend(std::string name = "log") : name_(std::move(name)) {}

  io::Json session() override { return {{"mode", "log"}, {"name", name_}}; }
  view::Pack frame(std::size_t number, const view::PlanChoice& choice) override {
    if (choice.gripper == "none")
      throw std::invalid_argument("gripper: there is none of that name");
    return number == 0 ? large_ : nullptr;
  }
  std::int64_t ask(const view::Question& question) override {
    if (!asking_allowed) throw view::NotAllowed("requests are off");
    asked = question;
    return 7;
  }
  io::Json wait_answer(std::int64_t number, std::chrono::milliseconds) override {
    if (number != 7) throw std::out_of_range("there is no such question");
    return {{"grasps", io::Json::array()}};
  }
  std::uint64_t wait_newer(std::uint64_t version, std::chrono::milliseconds) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return version + 1;
  }

  bool asking_allowed = true;
  view::Question asked;

  static constexpr std::size_t kLarge = std::size_t{16} << 20;

 private:
  std::string name_;
  view::Pack large_ = std::make_shared<const std::string>(kLarge, 'x');
};

struct Fixture {
  FakeBackend backend;
  view::Server server{backend, {}};
  HttpClient client{server.port()};

  unsigned status_of(const std::string& path, const HttpClient::Headers& headers = {}) {
    return client.get(path, headers).result_int();
  }
};

/// A connection that has sent a request, and has read nothing yet.
class StalledClient : public TestConnection {
 public:
  StalledClient(int port, const std::string& path) : TestConnection(port) {
    send(fmt::format("GET {} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n", path));
  }
};

}  // namespace

TEST_CASE("the page comes with a policy that lets no script in from elsewhere", "[view][safety]") {
  Fixture f;
  const auto answer = f.client.get("/");
  CHECK(answer.result_int() == 200);
  const std::string policy(answer["Content-Security-Policy"]);
  CHECK(policy.find("default-src 'none'") != std::string::npos);
  CHECK(policy.find("script-src 'self'") != std::string::npos);
  CHECK(policy.find("unsafe") == std::string::npos);
  CHECK(answer["X-Content-Type-Options"] == "nosniff");
  // No script or style within the page, which that policy would refuse.
  CHECK(answer.body().find("<script>") == std::string::npos);
  CHECK(answer.body().find("<style") == std::string::npos);
  CHECK(answer.body().find(" style=") == std::string::npos);
  CHECK(f.status_of("/three.min.js") == 200);
  CHECK(f.status_of("/app.js") == 200);
}

TEST_CASE("requests for another host or from another page are refused", "[view][safety]") {
  Fixture f;
  for (const char* path : {"/", "/app.js", "/api/session", "/api/frames/0", "/api/events"}) {
    CAPTURE(path);
    CHECK(f.status_of(path, {{"Host", "evil.example"}}) == 403);
    CHECK(f.status_of(path, {{"Origin", "http://evil.example"}}) == 403);
  }
  CHECK(f.status_of("/api/session",
                    {{"Origin", fmt::format("http://127.0.0.1:{}", f.server.port())}}) == 200);
}

TEST_CASE("nothing can be changed, and there are no files but the page's", "[view][safety]") {
  Fixture f;
  CHECK(f.client.send("POST", "/api/session", {}, "x").result_int() == 405);
  CHECK(f.client.send("PUT", "/", {}, "x").result_int() == 405);
  CHECK(f.client.send("DELETE", "/api/frames/0", {}, "").result_int() == 405);
  for (const char* path :
       {"/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc/passwd", "//etc/passwd",
        "/page/app.js", "/api/frames/../session", "/app.js/..", "/api/frames/-1",
        "/api/frames/99999999999999999999", "/api/frames/1", "/api/newest"}) {
    CAPTURE(path);
    CHECK(f.status_of(path) == 404);
  }
}

TEST_CASE("texts are packed for browsers that can unpack them", "[view]") {
  Fixture f;
  const std::string plain = f.client.get("/app.js").body();
  const auto packed = f.client.get("/app.js", {{"Accept-Encoding", "br, gzip"}});
  CHECK(packed["Content-Encoding"] == "gzip");
  const auto unpacked = io::gunzip(std::as_bytes(std::span(packed.body())), "app.js");
  CHECK(std::string(reinterpret_cast<const char*>(unpacked.data()), unpacked.size()) == plain);
  CHECK(f.client.get("/api/frames/0", {{"Accept-Encoding", "gzip"}})["Content-Encoding"].empty());
}

TEST_CASE("the head of an answer comes without its body", "[view]") {
  Fixture f;
  const auto head = f.client.send("HEAD", "/api/frames/0", {}, "");
  CHECK(head.result_int() == 200);
  CHECK(head["Content-Length"] == std::to_string(FakeBackend::kLarge));
  CHECK(head.body().empty());
  CHECK(f.client.send("HEAD", "/api/events", {}, "").result_int() == 200);
}

TEST_CASE("how a log is planned on is chosen in the address, and checked", "[view][requests]") {
  Fixture f;
  CHECK(f.status_of("/api/frames/0?gripper=wsg50&unknown=free&clearance=2.5") == 200);
  CHECK(f.status_of("/api/frames/0?gripper=none") == 400);
  for (const char* wrong : {"-1", "1e9", "nan", "inf", "5mm", "0x10"}) {
    CAPTURE(wrong);
    CHECK(f.status_of(std::string("/api/frames/0?clearance=") + wrong) == 400);
  }
}

TEST_CASE("the page may ask the planner, other pages may not", "[view][requests][safety]") {
  Fixture f;
  const std::string question = R"({"track": 3, "clearance": 5})";
  const auto ask = [&](HttpClient::Headers headers, const std::string& body,
                       const char* type = "application/json") {
    headers.emplace_back("Content-Type", type);
    return f.client.send("POST", "/api/questions", headers, body).result_int();
  };
  const std::string origin = fmt::format("http://127.0.0.1:{}", f.server.port());
  CHECK(ask({{"Origin", origin}}, question) == 200);
  CHECK(f.backend.asked.track == 3);
  CHECK(f.backend.asked.min_clearance == 0.005);
  CHECK(ask({{"Origin", "http://evil.example"}}, question) == 403);
  CHECK(ask({{"Host", "evil.example"}}, question) == 403);
  // What a form of another page can send without being asked for leave.
  for (const char* type : {"text/plain", "application/x-www-form-urlencoded"}) {
    CHECK(ask({}, question, type) == 405);
  }
  for (const char* wrong :
       {"", "[]", "{}", "{\"track\": -1}", "{\"track\": 3000000000}", "{\"track\": 1.5}",
        "{\"track\": \"1\"}", "{\"track\": 1, \"clearance\": -1}",
        "{\"track\": 1, \"clearance\": \"5\"}"}) {
    CAPTURE(wrong);
    CHECK(ask({}, wrong) == 400);
  }
  CHECK(ask({}, std::string(2000, ' ') + question) == 413);
  f.backend.asking_allowed = false;
  CHECK(ask({}, question) == 403);
  CHECK(f.status_of("/api/questions/7") == 200);
  CHECK(f.status_of("/api/questions/8") == 404);
}

TEST_CASE("whatever a name holds, the answer is sound JSON", "[view][safety][hostile]") {
  FakeBackend backend("</script><script>alert(1)</script>\xff\xfe\n\"");
  const view::Server server(backend, {});
  const auto answer = HttpClient(server.port()).get("/api/session");
  CHECK(answer["Content-Type"] == "application/json");
  const auto json = nlohmann::json::parse(answer.body());
  CHECK(json["name"].get<std::string>().starts_with(
      "</script><script>alert(1)</script>\xef\xbf\xbd"));
}

TEST_CASE("fifty browsers at once are all served", "[view][safety]") {
  Fixture f;
  std::atomic<int> served{0};
  std::vector<std::thread> browsers;
  for (int i = 0; i < 50; ++i) {
    browsers.emplace_back([&] {
      const auto answer = f.client.get("/api/frames/0");
      if (answer.result_int() == 200 && answer.body().size() == FakeBackend::kLarge) ++served;
    });
  }
  for (std::thread& browser : browsers) browser.join();
  CHECK(served == 50);
}

TEST_CASE("browsers that take nothing hold nobody up, and are let go", "[view][safety]") {
  FakeBackend backend;
  auto server = std::make_unique<view::Server>(backend, view::ServerOptions{});
  std::vector<std::unique_ptr<StalledClient>> stalled;
  for (int i = 0; i < 8; ++i) {
    stalled.push_back(std::make_unique<StalledClient>(server->port(), "/api/frames/0"));
  }
  CHECK(HttpClient(server->port()).get("/api/session").result_int() == 200);
  // The server ends although they still wait.
  server.reset();
}

TEST_CASE("when all places are taken, the slowest browsers give way", "[view][safety]") {
  Fixture f;
  std::vector<std::unique_ptr<StalledClient>> stalled;
  for (int i = 0; i < 2 * view::HttpServer::kMaxConnections; ++i) {
    stalled.push_back(std::make_unique<StalledClient>(f.server.port(), "/api/frames/0"));
  }
  CHECK(f.status_of("/api/session") == 200);
}

TEST_CASE("no more browsers are told of news than there are places", "[view][safety]") {
  Fixture f;
  std::vector<std::unique_ptr<StalledClient>> listeners;
  int refused = 0, told = 0;
  for (int i = 0; i < view::Server::kMaxListeners + 4; ++i) {
    listeners.push_back(std::make_unique<StalledClient>(f.server.port(), "/api/events"));
    const std::string answer = listeners.back()->read_some();
    refused += answer.find(" 503 ") != std::string::npos ? 1 : 0;
    told += answer.find(" 200 ") != std::string::npos ? 1 : 0;
  }
  CHECK(told == view::Server::kMaxListeners);
  CHECK(refused == 4);
  CHECK(f.status_of("/api/session") == 200);
}

TEST_CASE("a port that is taken is not shared", "[view]") {
  Fixture f;
  FakeBackend other;
  CHECK_THROWS_AS(view::Server(other, {"127.0.0.1", f.server.port()}), std::runtime_error);
}
