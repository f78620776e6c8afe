# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""One run of a program: how it ended, what it cost, what it said. Shared by bench/ and tools/sweep."""
import dataclasses
import os
import signal
import subprocess
import tempfile
import threading
import time


RUNNING = set()  # leaders of the groups of processes that this module has started
ENDING = threading.Event()


@dataclasses.dataclass
class Run:
    code: int        # exit code; negative: the number of the signal that ended it
    timed_out: bool  # it was ended because it took longer than its limit
    cpu: float       # user + system, seconds
    kernel: float    # of that the system's
    wall: float      # seconds
    memory: float    # at most, MB
    output: str
    errors: str

    @property
    def ending(self):
        """How it ended, for people; empty if well."""
        last = (self.errors.strip().splitlines() or [""])[-1]
        if self.timed_out:
            return f"hangs: ended after {self.wall:.0f} s"
        if self.code < 0:
            return f"crash: {signal.Signals(-self.code).name}; {last}".removesuffix("; ")
        return f"exit {self.code}: {last}" if self.code else ""


def run_process(command, folder, environment=None, time_limit=None):
    """Runs a command in a folder; after `time_limit` seconds it is killed, with all that it has started."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        process = subprocess.Popen(list(map(str, command)), cwd=folder, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=errors, start_new_session=True, env={**os.environ, **(environment or {})})
        late = threading.Event()
        watch = threading.Timer(time_limit or threading.TIMEOUT_MAX, lambda: (late.set(), end_group(process.pid)))
        watch.daemon = True
        watch.start()
        RUNNING.add(process.pid)
        if ENDING.is_set():  # end_all may have come between the start and the line above
            end_group(process.pid)
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            end_group(process.pid)
            raise
        finally:
            RUNNING.discard(process.pid)
            watch.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        wall = time.monotonic() - start
        return Run(process.returncode, late.is_set(), usage.ru_utime + usage.ru_stime, usage.ru_stime, wall,
                   usage.ru_maxrss / 1024, text_of(output), text_of(errors))


def end_group(leader):
    try:
        os.killpg(leader, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it was faster


def end_all():
    """For who is interrupted while other threads wait for theirs. What they start afterwards ends at once."""
    ENDING.set()
    for leader in list(RUNNING):
        end_group(leader)


def text_of(file):
    file.seek(0)
    return file.read().decode("utf-8", errors="replace")


def markdown_table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"
