"""Runs stopped by a signal, at any time and to any rank, leave a checkpoint from which they come to the same end.

python3 tests/system/stops.py --build build                  # a handful of stops, as in ctest
python3 tests/system/stops.py --build build --count 50 --seed 7
"""
import os
import random
import signal
import subprocess
import time
from pathlib import Path

import harness
from harness import BUILD, SCRATCH, Results, SystemTest, completed, difference, edited, fresh, main, ranks_of, started

harness.parser.add_argument("--count", type=int, default=4, help="of stops at random times")
harness.parser.add_argument("--seed", type=int, default=None)
GIVEN = harness.parser.parse_known_args()[0]

RANKS = 2
STOPS = signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, signal.SIGHUP, signal.SIGXCPU
LENGTH = dict(time_end="400", output_fields_every="5")
# A restarted run has no factor and no Jacobian from before. A run that keeps none, or that drops them at a checkpoint
# after each step, is therefore the same to the last bit wherever it is stopped; one that keeps them is the same to
# what its solvers leave.
EXACT = {"forgetful": dict(LENGTH, linear_keep_factor="false", newton_lagged="false"),
         "saving": dict(LENGTH, output_checkpoint_every="1")}


def slow_mesher(seconds):
    """Stands in for the mesher and takes its time: what comes meanwhile comes before the first step."""
    SCRATCH.mkdir(parents=True, exist_ok=True)
    script = SCRATCH / "slow_mesher"
    script.write_text(f'#!/bin/bash\nsleep {seconds}\nexec {BUILD}/bin/hawser_mesher "$@"\n')
    script.chmod(0o755)
    return {"HAWSER_MESHER": str(script)}


def wait_for(path, seconds=120):
    end = time.monotonic() + seconds
    while not path.exists():
        if time.monotonic() > end:
            raise AssertionError(f"{path} does not appear")
        time.sleep(0.002)


def takes_signals(rank):
    """Whether that process has come so far; before, while MPI starts, a signal ends it, and nothing is lost."""
    caught = int(Path(f"/proc/{rank}/status").read_text().split("SigCgt:")[1].split()[0], 16)
    return all(caught >> (stop - 1) & 1 for stop in STOPS)


def wait_until_all_take_signals(process, seconds=120):
    end = time.monotonic() + seconds
    while process.poll() is None and time.monotonic() < end:
        try:
            ranks = ranks_of(process)
            if len(ranks) == RANKS and all(takes_signals(rank) for rank in ranks):
                return
        except FileNotFoundError:
            pass  # one has ended
        time.sleep(0.002)


def reference(name, deck):
    """The same, left alone."""
    folder = fresh(name)
    completed(RANKS, "run", deck, "-o", folder, "-q", seconds=300)
    return Results(folder)


class Stops(SystemTest):
    def stopped(self, process, folder, signal_sent):
        """What is true of every stopped run; returns the time of its checkpoint in s."""
        out, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 75, out + err)
        self.assertRegex(err, rf"\Astopped by {signal_sent.name} at t = .* s; go on with: hawser restart "
                              rf"{folder}/checkpoint.h5\n\Z")
        self.assertFalse((folder / "summary.json").exists())
        return float(err.split(" t = ")[1].split()[0])

    def test_at_random_times(self):
        """On 2 ranks, to any one of them."""
        seed = GIVEN.seed if GIVEN.seed is not None else random.randrange(10**6)
        print(f"seed {seed}")
        chance = random.Random(seed)
        decks = {name: edited(name, **changes) for name, changes in EXACT.items()}
        whole = {}
        for name, deck in decks.items():
            begin = time.monotonic()
            whole[name] = reference(f"{name}.whole", deck), time.monotonic() - begin
        times, too_late = [], 0
        while len(times) < GIVEN.count:
            self.assertLess(too_late, 2 * GIVEN.count + 10)
            name, folder = chance.choice(list(decks)), fresh("stopped")
            results, seconds = whole[name]
            command = "run", decks[name], "-o", folder
            while True:  # what goes on from a checkpoint may be stopped, too
                sent = chance.choice(STOPS)
                with started(RANKS, *command, "-q") as process:
                    wait_until_all_take_signals(process)
                    time.sleep(chance.uniform(0, 0.7 * seconds))
                    try:
                        os.kill(chance.choice(ranks_of(process)), sent)
                    except (IndexError, ProcessLookupError, FileNotFoundError):
                        pass  # it has ended
                    process.wait(timeout=300)
                    if (folder / "summary.json").exists():
                        process.communicate()
                        too_late += 1
                        break
                    times.append(self.stopped(process, folder, sent))
                command = "restart", folder / "checkpoint.h5"
                if chance.random() < 0.7:
                    completed(RANKS, *command, "-q", seconds=300)
                    break
            self.assertSame(results, Results(folder))
        print(f"{len(times)} stops at t = {', '.join(f'{t:g}' for t in times)} s, all continued to the same end; "
              f"{too_late} came after the end")
        self.assertGreater(len(set(times)), 1)

    def test_a_run_that_keeps_its_factor_ends_alike_to_the_solvers_tolerance(self):
        # A kept Jacobian converges linearly and stops at its tolerance: of a residual of 1e-9 some 1e-8 is left in p.
        deck = edited("keeping", **LENGTH, newton_lagged="true", newton_tolerance="1e-9")
        folder = fresh("keeping")
        whole = reference("keeping.whole", deck)
        with started(RANKS, "run", deck, "-q", "-o", folder) as process:
            while (folder / "history.csv").read_text().count("\n") < 4 if (folder / "history.csv").exists() else True:
                time.sleep(0.002)
            os.kill(ranks_of(process)[1], signal.SIGTERM)
            self.assertLess(self.stopped(process, folder, signal.SIGTERM), 400)
        completed(RANKS, "restart", folder / "checkpoint.h5", "-q", seconds=300)
        step = whole.steps()[-1]
        there, here = whole.fields(step), Results(folder).fields(step)
        for name in "displacement", "velocity", "pressure":
            apart = difference(here[name], there[name])
            print(f"{name}: {apart:.1e} of the largest")
            self.assertLessEqual(apart, 1e-6, name)

    def test_before_the_first_step(self):
        whole = reference("forgetful.whole", edited("forgetful", **EXACT["forgetful"]))
        folder = fresh("early")
        with started(RANKS, "run", SCRATCH / "forgetful.xml", "-q", "-o", folder, **slow_mesher(1)) as process:
            wait_for(folder)
            os.kill(ranks_of(process)[1], signal.SIGINT)
            self.assertEqual(self.stopped(process, folder, signal.SIGINT), 0)
        self.assertFails(7, rf"{folder} holds an unfinished run; go on with: hawser restart {folder}/checkpoint.h5; "
                            ".*--force to begin again", RANKS, "run", SCRATCH / "forgetful.xml", "-q", "-o", folder)
        completed(RANKS, "restart", folder / "checkpoint.h5", "-q", seconds=300)
        self.assertSame(whole, Results(folder))

    def test_a_second_signal_stops_at_once(self):
        folder = fresh("twice")
        with started(1, "run", edited("twice"), "-q", "-o", folder, **slow_mesher(20)) as process:
            wait_for(folder)
            process.send_signal(signal.SIGTERM)
            with self.assertRaises(subprocess.TimeoutExpired, msg="the first one waits for the mesh"):
                process.wait(timeout=1)
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(timeout=10), -signal.SIGTERM)

    def test_through_mpirun(self):
        """It forwards SIGUSR1 and SIGUSR2, and leaves the ranks their time."""
        deck, folder = edited("forwarded", **EXACT["saving"]), fresh("forwarded")
        with started(RANKS, "run", deck, "-o", folder, **slow_mesher(1)) as process:
            wait_for(folder)
            process.send_signal(signal.SIGUSR2)
            out, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, err)
        self.assertIn(f"SIGUSR2: checkpoint of t = 0 s in {folder}/checkpoint.h5\n", out)
        self.assertSame(reference("saving.whole", deck), Results(folder))
        folder = fresh("forwarded")
        with started(RANKS, "run", deck, "-q", "-o", folder, **slow_mesher(1)) as process:
            wait_for(folder)
            process.send_signal(signal.SIGUSR1)
            self.stopped(process, folder, signal.SIGUSR1)


if __name__ == "__main__":
    main()
