#!/usr/bin/env bash
# Runs Slurm on this machine alone, to try array jobs without a cluster. Debian and Ubuntu, as root.
#
#   one_node_slurm.sh start [FOLDER]   installs missing packages and starts Slurm
#   export SLURM_CONF=FOLDER/slurm.conf
#   sbatch --wait --array=1-2 slurm.sh out/study --scenes 4 --seed 1 --gripper franka
#   one_node_slurm.sh stop [FOLDER]
#
# All its files are in FOLDER, by default /var/tmp/one_node_slurm. munge, by which the parts of Slurm
# authenticate each other, is left running.
set -euo pipefail

command=${1:-}
folder=$(realpath -m "${2:-/var/tmp/one_node_slurm}")
export SLURM_CONF=$folder/slurm.conf

fail() {
  echo "one_node_slurm.sh: $*" >&2
  exit 1
}

# wait_for SECONDS COMMAND… repeats the command until it succeeds, for at most so many seconds.
wait_for() {
  local tries=$(($1 * 5))
  shift
  until "$@" >/dev/null 2>&1; do
    ((tries-- > 0)) || return 1
    sleep 0.2
  done
}

install_packages() {
  local needed=(slurmctld slurmd slurm-client munge) missing=() package status
  for package in "${needed[@]}"; do
    # dpkg-query fails for a package that it does not know.
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
  done
  ((${#missing[@]} == 0)) && return
  apt-get -q update >/dev/null
  DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends "${missing[@]}" \
    >/dev/null || fail "cannot install ${missing[*]}"
}

start_munge() {
  munge -n >/dev/null 2>&1 && return
  mkdir -p /run/munge
  chown munge: /run/munge
  chmod 0755 /run/munge
  runuser -u munge -- /usr/sbin/munged
  wait_for 10 munge -n || fail "munge does not start; see /var/log/munge/munged.log"
}

# Writes settings with the node as slurmd sees it, without accounting, control groups or power saving.
write_settings() {
  local name node
  name=$(hostname -s)
  node=$(slurmd -C | head -n 1)
  mkdir -p "$folder/state" "$folder/spool"
  cat >"$SLURM_CONF" <<TEXT
ClusterName=one
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
$node NodeAddr=127.0.0.1 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
TEXT
}

is_idle() { sinfo -h -o %T | grep -q '^idle'; }

start() {
  ((EUID == 0)) || fail "needs root: sudo $0 start"
  install_packages
  start_munge
  if pgrep -x slurmctld >/dev/null || pgrep -x slurmd >/dev/null; then
    fail "a Slurm runs here already; use that"
  fi
  write_settings
  slurmctld
  slurmd
  wait_for 30 is_idle || fail "the node does not come up; see $folder/*.log"
  echo "Slurm is up: export SLURM_CONF=$SLURM_CONF"
}

case $command in
  start) start ;;
  stop) scontrol shutdown ;;
  *) echo "usage: one_node_slurm.sh start|stop [FOLDER]" >&2; exit 2 ;;
esac
