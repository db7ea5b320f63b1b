# shellcheck shell=bash disable=SC2034
# For tests on a network of their own; source it, then call begin_alone. Afterwards `url` is an LCM address there.

url="udpm://239.255.76.67:7667?ttl=0"

# fail TEXT: ends the script with the text and the last lines of the logs in `work`.
fail() {
  printf '%s\n' "${0##*/}: $*" >&2
  # There may be no folder or no log yet.
  tail -qn 2 "${work:-/nonexistent}"/*.log >&2 2>/dev/null || true
  exit 1
}

# begin_alone "$@": runs the script anew in a network of its own, which has no interface up and hears no one else. Then
# makes the folder `work`, which is removed at the end with the processes in `started`.
begin_alone() {
  local unshare
  if [[ -z ${QUADRILLE_PRIVATE_NETWORK:-} ]]; then
    for unshare in "unshare -n" "unshare -rn"; do
      if $unshare true 2>/dev/null; then QUADRILLE_PRIVATE_NETWORK=yes exec $unshare "$0" "$@"; fi
    done
    fail "needs the right to make a network namespace: root, or unprivileged user namespaces"
  fi
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

# carry_multicast: makes LCM's messages reach every process of this network.
carry_multicast() {
  ip link set lo up
  ip route add 224.0.0.0/4 dev lo
}

# wait_until SECONDS COMMAND…: until the command succeeds; fails if it does not in that time.
wait_until() {
  local tries=$(($1 * 50))
  shift
  until "$@"; do
    ((tries-- > 0)) || return 1
    sleep 0.02
  done
}

# has_own_network PROCESS: it has left this network for one of its own. A device that is moved to it earlier stays here.
has_own_network() { [[ $(readlink "/proc/$1/ns/net") != "$(readlink /proc/self/ns/net)" ]]; }

# has_listeners N: as many sockets are bound to LCM's port.
has_listeners() { [[ $(grep -c ':1DF3 ' /proc/net/udp) -ge $1 ]]; }
