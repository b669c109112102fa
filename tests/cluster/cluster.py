# SPDX-License-Identifier: BSD-3-Clause
"""A Slurm cluster of one controller and some nodes on this machine: keys, sockets, ports and folders are its own."""
import contextlib
import ctypes
import os
import pathlib
import pwd
import secrets
import shutil
import signal
import socket
import subprocess
import time

DAEMONS = ("munged", "slurmctld", "slurmd")
SECONDS_TO_START = 20
PR_SET_CHILD_SUBREAPER = 36

CONFIGURATION = """
ClusterName=kreisel
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
SlurmdParameters=config_overrides
SwitchType=switch/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
DefMemPerCPU=200
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=1,sched_interval=1,batch_sched_delay=0
ReturnToService=2
SlurmdTimeout=6
KillWait=3
MinJobAge=3600
JobRequeue=1
{nodes}
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def find(daemon):
    return shutil.which(daemon, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def free_ports(count):
    with contextlib.ExitStack() as opened:
        sockets = [opened.enter_context(socket.socket()) for _ in range(count)]
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]


def until(what, condition, seconds):
    """Waits for it; what it returns then. `what` tells what is wrong otherwise."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.05)
    raise AssertionError(f"after {seconds} s: {what()}")


def processes():
    """The parent and the words of each process."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):  # it may end meanwhile
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
                found[int(entry.name)] = (parent, (entry / "cmdline").read_bytes().decode().split("\0")[:-1])
    return found


def below(process):
    """All descendants of a process."""
    known, found, front = processes(), [], [process]
    while front:
        front = [each for each, (parent, _) in known.items() if parent in front]
        found += front
    return found


class Cluster:
    """Whatever it starts, jobs as well, ends with it: orphans become children of this process."""

    def __init__(self, folder, nodes):
        self.folder = pathlib.Path(folder)
        self.names = [f"n{i + 1}" for i in range(nodes)]
        self.daemons = {}
        self.environment = {**os.environ, "SLURM_CONF": f"{folder}/slurm.conf"}

    def __enter__(self):
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)
        self._write_configuration()
        try:
            self._start("munged", "--foreground", "--force", f"--key-file={self.folder}/munge.key",
                        f"--socket={self.folder}/munge.socket", f"--pid-file={self.folder}/munge.pid",
                        f"--log-file={self.folder}/munge.log", f"--seed-file={self.folder}/munge.seed")
            until(lambda: "munged has no socket", (self.folder / "munge.socket").exists, SECONDS_TO_START)
            self._start("slurmctld", "-D")
            for name in self.names:
                self.start_node(name)
            until(lambda: "the nodes are not idle", lambda: self.say("sinfo", "--noheader", "--format=%T %D") ==
                  f"idle {len(self.names)}", SECONDS_TO_START)
        except BaseException:
            print(self.logs())
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        while left := below(os.getpid()):
            for process in left:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process, signal.SIGKILL)
            with contextlib.suppress(ChildProcessError):
                while os.waitpid(-1, os.WNOHANG)[0]:
                    pass
            time.sleep(0.02)

    def _write_configuration(self):
        (self.folder / "state").mkdir()
        (self.folder / "cgroup.conf").write_text("CgroupAutomount=no\n")
        key = self.folder / "munge.key"
        key.touch(0o600)
        key.write_bytes(secrets.token_bytes(128))
        port, *ports = free_ports(1 + len(self.names))
        host = socket.gethostname().partition(".")[0]
        nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=4 RealMemory=1000"
                          for name, port in zip(self.names, ports))
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(host=host, port=port, folder=self.folder, user=pwd.getpwuid(os.geteuid()).pw_name, nodes=nodes))

    def _start(self, daemon, *words):
        with open(self.folder / "daemons.log", "ab") as log:
            return subprocess.Popen([find(daemon), *words], env=self.environment, stdin=subprocess.DEVNULL, stdout=log,
                                    stderr=log, start_new_session=True)

    def start_node(self, name):
        self.daemons[name] = self._start("slurmd", "-D", "-N", name)

    def kill_node_daemon(self, name):
        """Its jobs stay."""
        self.daemons[name].kill()
        self.daemons[name].wait()

    def say(self, *words):
        done = subprocess.run(words, env=self.environment, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.stdout.strip()

    def logs(self):
        return "".join(f"--- {file.name}\n{file.read_text(errors='replace')}" for file in self.folder.glob("*.log"))
