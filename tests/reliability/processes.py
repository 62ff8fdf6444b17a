"""Processes that are killed, signalled, raced."""
import os
import pty
import signal
import subprocess
import time

from harness import ENVIRONMENT, Results, command_line, fresh, ranks_of
from trials import (DECK, INTERVAL, Count, chance, differ, go_on, kill, reference, run, start, takes_signals, wait)

STEP = 5  # s, of the deck
LENGTH = "--set", "time/end=600"  # a run of a second, so that there is time to disturb it


def kills(count, seed):
    """kill -9 at any moment, every third one while a checkpoint is being written; what goes on may be killed, too."""
    dice, result = chance(seed), Count("kill -9: resumed to the same end, at most one interval lost")
    begin = time.monotonic()
    whole = reference("kills.whole", *LENGTH)
    seconds, in_window = time.monotonic() - begin, 0
    while result.all < count:
        folder = fresh("kills")
        write_window = result.all % 3 == 0
        with start("run", DECK, "-o", folder, "-q", *LENGTH, stdout=subprocess.DEVNULL) as process:
            if write_window:
                number = dice.randrange(1, 90)
                wait(lambda: process.poll() is not None or Results(folder).folder.joinpath("history.csv").exists()
                     and (folder / "history.csv").read_text().count("\n") > number * INTERVAL, 60)
                wait(lambda: process.poll() is not None or (folder / "checkpoint.h5.unfinished").exists(), 60)
                time.sleep(dice.uniform(0, 0.003))
            else:
                time.sleep(dice.uniform(0, seconds))
            late = process.poll() is not None
            in_window += write_window and (folder / "checkpoint.h5.unfinished").exists()
            process.kill()
        if late and (folder / "summary.json").exists():
            continue  # it was at its end
        result.add(go_on(whole, folder, at_most_lost=INTERVAL * STEP, arguments=LENGTH))
    print(f"  {in_window} of them while a checkpoint was being written")
    return result.report()


def stopped(process, folder, name):
    """None when the run has stopped as it should."""
    out, err = process.communicate(timeout=60)
    if process.returncode != 75:
        return f"{name}: exit code {process.returncode}: {err}"
    if f"hawser restart {folder}/checkpoint.h5" not in (out or "") + (err or ""):
        return f"{name}: it does not say how to go on: {err}"
    return None


def signalled(dice, whole, number, ranks=1):
    folder = fresh("signals")
    with start("run", DECK, "-o", folder, "-q", *LENGTH, ranks=ranks) as process:
        wait(lambda: (folder / "history.csv").exists() or process.poll() is not None, 60)
        time.sleep(dice.uniform(0, 0.3))
        if ranks == 1:
            kill(process, number)
        else:
            os.kill(dice.choice(ranks_of(process)), number)
        fault = stopped(process, folder, signal.Signals(number).name)
    if ranks == 1:
        return fault or go_on(whole, folder)
    if fault is None:
        code, said = run("restart", folder / "checkpoint.h5", "-q", ranks=ranks)
        fault = None if code == 0 else said
    return fault or differ(whole, folder)


def timed_out(dice, whole):
    """timeout(1) signals the process and its whole group: one wish, arriving twice."""
    folder = fresh("signals")
    command = ["timeout", f"{dice.uniform(0.6, 0.9):.3f}", *command_line(1, "run", DECK, "-o", folder, "-q", *LENGTH)]
    done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, start_new_session=True)
    if done.returncode == 0:
        return differ(whole, folder)
    if done.returncode != 124 or "go on with: hawser restart" not in done.stderr:
        if not (folder / "resolved.xml").exists():
            return None  # before signals are taken: nothing is lost
        return f"timeout: {done.returncode} {done.stderr}"
    return go_on(whole, folder)


def closed_pipe(dice, whole):
    """The reader of the log goes; the run does not."""
    folder = fresh("signals")
    with start("run", DECK, "-o", folder, *LENGTH) as process:
        process.stdout.readline()
        time.sleep(dice.uniform(0, 0.2))
        process.stdout.close()
        code = process.wait(timeout=60)
        process.stderr.close()
    return differ(whole, folder) if code == 0 else f"closed pipe: exit code {code}"


def closed_terminal(dice, whole):
    folder = fresh("signals")
    master, slave = pty.openpty()

    def own_terminal():
        os.setsid()
        import fcntl
        import termios
        fcntl.ioctl(slave, termios.TIOCSCTTY, 0)

    process = subprocess.Popen(command_line(1, "run", DECK, "-o", folder, *LENGTH), env={**ENVIRONMENT, "TERM": "xterm"},
                               stdin=slave, stdout=slave, stderr=slave, preexec_fn=own_terminal)
    os.close(slave)
    os.set_blocking(master, False)

    def written():
        try:
            while os.read(master, 65536):
                pass
        except (BlockingIOError, OSError):
            pass
        return (folder / "history.csv").exists() or process.poll() is not None

    wait(written, 60)
    end = time.monotonic() + dice.uniform(0, 0.2)
    while time.monotonic() < end:
        written()
        time.sleep(0.002)
    os.close(master)
    code = process.wait(timeout=60)
    if code == 0:
        return differ(whole, folder)
    return go_on(whole, folder) if code == 75 else f"closed terminal: exit code {code}"


def time_is_up(dice, whole):
    folder = fresh("signals")
    with start("run", DECK, "-o", folder, "-q", *LENGTH, "--stop-after", f"{dice.uniform(0.05, 0.4):.3f}s") as process:
        fault = stopped(process, folder, "--stop-after")
    return fault or go_on(whole, folder)


def signals(count, seed):
    """`count` of each kind."""
    dice, whole, good = chance(seed), reference("signals.whole", *LENGTH), True
    kinds = {number.name: lambda number=number: signalled(dice, whole, number) for number in (
        signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU, signal.SIGUSR1)}
    two = fresh("signals.np2")
    run("run", DECK, "-o", two, "-q", *LENGTH, ranks=2)
    kinds["SIGTERM to one of two ranks"] = lambda: signalled(dice, Results(two), signal.SIGTERM, ranks=2)
    kinds.update({"timeout": lambda: timed_out(dice, whole), "closed pipe": lambda: closed_pipe(dice, whole),
                  "closed terminal": lambda: closed_terminal(dice, whole),
                  "--stop-after": lambda: time_is_up(dice, whole)})
    for name, trial in kinds.items():
        result = Count(name)
        for _ in range(count):
            result.add(trial())
        good = result.report() and good
    return good


def locks(count, seed):
    """Two runs in one folder, the second at any distance in time, with --force every other time."""
    dice, result, whole = chance(seed), Count("two runs in one folder: one winner and whole results"), reference(
        "locks.whole", *LENGTH)
    for trial in range(count):
        folder = fresh("locks")
        force = ["--force"] * (trial % 2)
        first = start("run", DECK, "-o", folder, "-q", *LENGTH)
        time.sleep(dice.choice([0, 0, dice.uniform(0, 0.05), dice.uniform(0, 0.6)]))
        second = start("run", DECK, "-o", folder, "-q", *LENGTH, *force)
        ends = []
        for process in first, second:
            _, err = process.communicate(timeout=120)
            ends.append((process.returncode, err))
        winners = [code for code, _ in ends if code == 0]
        losers = [err for code, err in ends if code == 7]
        after = force and len(winners) == 2 and "" or None  # --force after the first one's end is no race
        if after is not None and not losers:
            result.add(differ(whole, folder))
        elif len(winners) != 1 or len(losers) != 1:
            result.add(f"exit codes {[code for code, _ in ends]}: {[err for _, err in ends]}")
        elif "is in use by a run" not in losers[0] and "holds" not in losers[0]:
            result.add(f"refused for another reason: {losers[0]}")
        else:
            result.add(differ(whole, folder))
    good = result.report()
    stale = Count("a lock whose process was killed does not bar the next run")
    for _ in range(max(1, count // 10)):
        folder = fresh("locks")
        with start("run", DECK, "-o", folder, "-q", *LENGTH) as process:
            wait(lambda: (folder / "checkpoint.h5").exists(), 60)
            process.kill()
        stale.add(go_on(whole, folder) if (folder / "lock").exists() else "no lock was left")
    other = Count("a lock of another host is left alone, and the sentence says what to do")
    folder = fresh("locks")
    folder.mkdir(parents=True)
    (folder / "lock").write_text("elsewhere.example.org 17 123 some-boot 2020-01-01 00:00:00 UTC\n")
    code, said = run("run", DECK, "-o", folder, "-q", "--force")
    other.add(None if code == 7 and "process 17 on elsewhere.example.org" in said and f"remove {folder}/lock" in said
              else f"{code} {said}")
    return stale.report() and other.report() and good


