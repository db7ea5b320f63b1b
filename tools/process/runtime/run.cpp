#include "process/runtime/run.hpp"

#include "process/runtime/logging.hpp"
#include "run/stop.hpp"

namespace quadrille {

void run_process(const std::string& name, const ProcessArguments& arguments,
                 const NodeMaker& make_node) {
  start_logging(name, arguments.verbose);
  bus::install_stop_signals();
  if (arguments.in_log.empty()) {
    run_on_bus(arguments, make_node);
  } else {
    run_on_log(arguments, make_node);
  }
}

}  // namespace quadrille
