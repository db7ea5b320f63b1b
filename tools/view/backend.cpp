#include "view/backend.hpp"

#include <nlohmann/json.hpp>

namespace quadrille::view {

io::Json Backend::status() { return io::Json::object(); }

std::int64_t Backend::ask(const Question&) {
  throw NotAllowed("nothing is asked of a log's robot; choose how to plan on the log instead");
}

io::Json Backend::wait_answer(std::int64_t, std::chrono::milliseconds) {
  throw std::out_of_range("nothing was asked");
}

}  // namespace quadrille::view
