# A Slurm of three nodes on this machine alone, for bash to source: slurm_up FOLDER, slurm_down FOLDER,
# node_pids FOLDER NODE, job_pids FOLDER NODE.
# Everything is in FOLDER and on loopback ports; no root is needed.

slurm_installed() {
  PATH=$PATH:/usr/sbin
  command -v munged slurmctld slurmd sbatch >/dev/null
}

# Four ports in a row that nothing listens on.
free_ports() {
  local port
  for port in $(shuf -i 20000-32000 -n 50); do
    ss -Htln | awk -v a="$port" '{sub(/.*:/, "", $4); if ($4 >= a && $4 <= a + 3) found = 1} END {exit found}' &&
      echo "$port" && return
  done
  return 1
}

slurm_up() {
  local folder=$1 port user node
  user=$(id -un)
  port=$(free_ports)
  mkdir -p "$folder"/{run,state,log}
  chmod 755 "$folder/run"
  head -c 1024 /dev/urandom >"$folder/munge.key"
  chmod 400 "$folder/munge.key"
  munged --key-file="$folder/munge.key" --socket="$folder/run/munge" --pid-file="$folder/run/munged.pid" \
    --log-file="$folder/log/munged.log" --seed-file="$folder/run/seed" --force >/dev/null 2>&1
  cat >"$folder/slurm.conf" <<CONF
ClusterName=skyway
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/run/munge,cred_expire=6
SlurmctldPort=$port
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.%n.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
SlurmdTimeout=5
KillWait=1
ReturnToService=2
MpiDefault=none
NodeName=node1 NodeAddr=127.0.0.1 NodeHostname=localhost Port=$((port + 1)) CPUs=1 RealMemory=16000
NodeName=node2 NodeAddr=127.0.0.1 NodeHostname=localhost Port=$((port + 2)) CPUs=1 RealMemory=16000
NodeName=node3 NodeAddr=127.0.0.1 NodeHostname=localhost Port=$((port + 3)) CPUs=1 RealMemory=16000
PartitionName=all Nodes=node[1-3] Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$folder/slurm.conf
  slurmctld -f "$SLURM_CONF"
  for node in node1 node2 node3; do
    mkdir -p "$folder/spool.$node"
    slurmd -N "$node" -f "$SLURM_CONF"
  done
  for _ in $(seq 50); do
    [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | wc -l)" -eq 3 ] && return
    sleep 0.2
  done
  echo "the nodes did not come up:" >&2
  tail -n 5 "$folder"/log/*.log >&2
  return 1
}

# The daemon of a node, and the jobs that run there with what watches them.
node_pids() {
  local folder=$1 node=$2 pid parent
  cat "$folder/run/slurmd.$node.pid" 2>/dev/null || true
  for pid in $(job_pids "$folder" "$node"); do
    parent=$(ps -o ppid= -p "$pid" | tr -d ' ')
    [ "$(cat "/proc/$parent/comm" 2>/dev/null)" != slurmstepd ] || echo "$parent"
    echo "$pid"
  done
}

# Processes of jobs on a node: they have its name, and the folder, in their environment.
job_pids() {
  local folder=$1 node=$2 environment
  for environment in $(grep -lzsxF "SLURMD_NODENAME=$node" /proc/[0-9]*/environ); do
    grep -qzsxF "SLURM_CONF=$folder/slurm.conf" "$environment" && basename "$(dirname "$environment")"
  done || true
}

slurm_down() {
  local folder=$1 node name pid
  scancel -u "$(id -un)" >/dev/null 2>&1 || true
  for node in node1 node2 node3; do
    for pid in $(node_pids "$folder" "$node"); do kill -9 "$pid" 2>/dev/null || true; done
  done
  for name in slurmctld munged; do
    [ ! -e "$folder/run/$name.pid" ] || kill "$(cat "$folder/run/$name.pid")" 2>/dev/null || true
  done
}
