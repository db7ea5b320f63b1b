#include "process/runtime/background.hpp"

#include <signal.h>
#include <sys/resource.h>

namespace quadrille {

void go_to_background(int niceness) {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  // On Linux each thread has its own niceness, so the receiving thread keeps its own. A failure
  // costs only speed.
  if (niceness > 0) setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + niceness);
}

}  // namespace quadrille
