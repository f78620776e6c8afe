# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A Slurm cluster of one node, this machine, for as long as a test takes: everything it has is in one folder."""
import contextlib
import ctypes
import os
import pathlib
import pwd
import select
import shutil
import signal
import socket
import subprocess
import sys
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "sinfo", "scancel")

# The daemons believe only who can read the key of this test's own munged. More CPUs than there are let all tasks of an
# array run at once.
CONFIGURATION = """ClusterName=meniscus
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=5
NodeName=localhost NodeAddr=127.0.0.1 CPUs={cpus} RealMemory=64000
PartitionName=all Nodes=localhost Default=YES State=UP
"""


def find(program):
    """The path of a program; daemons are where the PATH of an ordinary user does not look."""
    return shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def obstacle():
    """Why there can be no cluster here; empty if there can."""
    absent = [name for name in PROGRAMS if find(name) is None]
    if absent:
        return f"needs {', '.join(absent)}, which the package slurm-wlm brings (packages.txt)"
    try:
        socket.getaddrinfo(None, 1, socket.AF_INET, socket.SOCK_STREAM, 0, socket.AI_ADDRCONFIG | socket.AI_PASSIVE)
    except socket.gaierror:
        return "this machine has no address but 127.0.0.1, and Slurm needs one"
    return ""


def free_ports(count):
    """Ports that nothing listened on just now."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def processes_with(variables):
    """Processes with all these environment variables, as (id, id of the parent, words of the command line)."""
    wanted = {f"{name}={value}".encode() for name, value in variables.items()}
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if wanted <= set((entry / "environ").read_bytes().split(b"\0")):
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
                words = (entry / "cmdline").read_bytes().split(b"\0")[:-1]
                found.append((int(entry.name), parent, [os.fsdecode(word) for word in words]))
        except OSError:
            continue  # ended meanwhile, or of another user
    return found


def children():
    """Processes of which this one is the parent."""
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if int((entry / "stat").read_text().rpartition(")")[2].split()[1]) == os.getpid():
                yield int(entry.name)


def serve(folder):
    """Runs the daemons until standard input ends, or one of them. Then nothing that they have started is left, nor the
    folder; this is a process of its own, so that it is done for a test that was killed, too."""
    pr_set_child_subreaper = 36  # whoever loses its parent is given to this process
    ctypes.CDLL(None).prctl(pr_set_child_subreaper, 1)
    socket_of_munge = folder / "munge.socket"
    key = folder / "munge.key"
    key.touch(0o600)
    key.write_bytes(os.urandom(128))
    daemons = []

    def start(program, *words):
        with open(folder / f"{program}.out", "wb") as out:
            daemons.append(subprocess.Popen([find(program), *words], stdin=subprocess.DEVNULL, stdout=out, stderr=out))

    def is_wanted(seconds):
        asked_to_end = select.select([sys.stdin], [], [], seconds)[0]
        return not asked_to_end and all(daemon.poll() is None for daemon in daemons)

    start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={socket_of_munge}",
          *(f"--{name}-file={folder}/munged.{name}" for name in ("pid", "log", "seed")))
    while is_wanted(0.02) and not socket_of_munge.exists():
        pass
    start("slurmctld", "-D")
    start("slurmd", "-D", "-N", "localhost")
    while is_wanted(0.2):
        pass
    with contextlib.suppress(ChildProcessError):
        while True:
            for child in children():
                os.kill(child, signal.SIGKILL)
            os.waitpid(-1, 0)
    if select.select([sys.stdin], [], [], 0)[0]:
        shutil.rmtree(folder.parent)


class Cluster:
    """A controller and a daemon, from start() to stop(), in a part of a folder which stop() removes. Commands find them by
    `environment`."""

    def __init__(self, scratch, cpus):
        self.folder = pathlib.Path(scratch) / "cluster"
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        user = pwd.getpwuid(os.getuid()).pw_name
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(ports=free_ports(2), user=user, folder=self.folder, cpus=cpus))
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")  # none of it is used
        self.environment = {**os.environ, "SLURM_CONF": str(configuration)}
        self.server = None

    def start(self):
        self.server = subprocess.Popen([sys.executable, "-B", __file__, self.folder], env=self.environment,
                                       stdin=subprocess.PIPE, start_new_session=True)
        self.wait_until(lambda: self.run("sinfo", "--noheader", "--format=%T", check=False) == "idle\n",
                        "the node is not ready")

    def wait_until(self, happened, what, seconds=120):
        """Waits as long as the daemons live."""
        end = time.monotonic() + seconds
        while not happened():
            if self.server.poll() is not None:
                raise RuntimeError(f"{what}: a daemon has ended\n{self.messages()}")
            if time.monotonic() > end:
                raise RuntimeError(f"{what} within {seconds} s\n{self.messages()}")
            time.sleep(0.02)

    def stop(self):
        """Ends jobs and daemons, whatever state they are in."""
        if self.server:
            self.server.stdin.close()
            self.server.wait(60)
        shutil.rmtree(self.folder.parent, ignore_errors=True)

    def messages(self):
        return "\n".join(f"{path.name}:\n{path.read_text(errors='replace')[-3000:]}"
                         for path in sorted(self.folder.glob("*.out")))

    def run(self, program, *words, check=True):
        """What one of Slurm's programs prints."""
        done = subprocess.run([find(program), *map(str, words)], env=self.environment, capture_output=True,
                              encoding="utf-8", timeout=60, check=False)
        if check and done.returncode != 0:
            raise RuntimeError(f"{program}: {done.stderr}\n{self.messages()}")
        return done.stdout

    def jobs(self):
        """Jobs that have not ended, array tasks one by one, each with its state."""
        lines = self.run("squeue", "--noheader", "--array", "--states=all", "--format=%i %T", check=False).splitlines()
        ended = {"COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY"}
        return {job: state for job, state in map(str.split, lines) if state not in ended}

    def value(self, job, name):
        """One of the values that `scontrol show job` has: JobState, ExitCode, Restarts."""
        words = self.run("scontrol", "show", "--oneliner", "job", job).split()
        return next(word.removeprefix(name + "=") for word in words if word.startswith(name + "="))


if __name__ == "__main__":
    serve(pathlib.Path(sys.argv[1]))
