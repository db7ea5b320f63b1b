# shellcheck shell=bash
# For tests that play with the network. To be sourced by scripts that have fail().

# enter_private_network "$@": runs the script anew in a network of its own, which needs no route of
# the machine and hears no one else; fails where the machine allows none.
enter_private_network() {
  local unshare
  [[ -z ${QUADRILLE_PRIVATE_NETWORK:-} ]] || return 0
  for unshare in "unshare -n" "unshare -rn"; do
    if $unshare true 2>/dev/null; then QUADRILLE_PRIVATE_NETWORK=yes exec $unshare "$0" "$@"; fi
  done
  return 1
}

# need_private_network "$@": the same, and the end where it is not to be had.
need_private_network() {
  enter_private_network "$@" ||
    fail "needs the right to make a network namespace: root, or unprivileged user namespaces"
}

# make_work_folder: `work`, which is removed at the end with the processes in `started`.
make_work_folder() {
  work=$(mktemp -d)
  started=()
  trap clean_up EXIT
}

clean_up() {
  local process
  # One that has ended by itself cannot be ended again.
  for process in "${started[@]}"; do kill -KILL "$process" 2>/dev/null || true; done
  rm -rf "$work"
}
