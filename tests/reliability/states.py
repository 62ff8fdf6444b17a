"""Steps that fail, other numbers of ranks, many steps."""
import re
import time
from pathlib import Path

from harness import SCRATCH, Results, difference, edited, fresh
from trials import DECK, Count, chance, differ, reference, run, start, time_of

RANKS = 1, 2, 3, 4, 6


def newton(count, seed):
    """Newton's method fails in some step; with more iterations allowed the run goes on to the end of one that was never
    stopped."""
    dice, result, whole = chance(seed), Count("Newton fails: exit code 6, and resumed to the same end"), reference("newton.whole")
    for _ in range(count):
        folder = fresh("newton")
        stop = 5 * dice.randrange(1, 8)  # steps; fields are due there in any case
        run("run", DECK, "-o", folder, "-q", "--end", 5 * stop)
        code, said = run("restart", folder / "checkpoint.h5", "-q", "--end", "200", "--set", "solver/newton/max-iterations=1",
                         "--set", "time/least-step=5")
        if code != 6 or "the last accepted state is in" not in said:
            result.add(f"exit code {code}: {said}")
            continue
        code, said = run("restart", folder / "checkpoint.h5", "-q", "--set", "solver/newton/max-iterations=40",
                         "--set", "time/least-step=0")
        result.add(differ(whole, folder) if code == 0 else f"cannot go on: {code} {said}")
    return result.report()


def inversions(count, seed):
    """A side of a body leaps beyond the opposite one, at any time: the cell is named before anything is assembled with
    it, and the state before is kept."""
    dice, result = chance(seed), Count("cells turned inside out: exit code 6, named with their place, the state before kept")
    sides = {"inflow": -1, "outflow": 1}  # inwards, along y
    deck = SCRATCH / "inversions.xml"
    deck.parent.mkdir(parents=True, exist_ok=True)
    for _ in range(count):
        folder, side, stop = fresh("inversions"), dice.choice(list(sides)), dice.randrange(0, 8)
        x, y = dice.uniform(-3, 3), sides[side] * dice.uniform(4.2, 12)
        held = "outflow" if side == "inflow" else "inflow"
        flow = dice.choice(['<ale-fluid region="water" density="1" viscosity="1"/>', ""])
        inflow = '<prescribe field="velocity" on="inflow" value="0; -0.01"/>' * bool(flow)
        deck.write_text(f"""<hawser>
<mesh><water-box min="0 0" max="4 4" cells="4 4"/></mesh>
<modules>{flow}<mesh-motion region="water"/></modules>
<conditions>
  {inflow}
  <prescribe field="displacement" on="{held}" value="0.001*t; 0"/>
  <prescribe field="displacement" on="{side}" from="{stop}" value="{x}; {y}" replaces="true"/>
</conditions>
<time step="1" end="12" least-step="1"/>
<output fields-every="0" checkpoint-every="1"/>
</hawser>""")
        code, said = run("run", deck, "-o", folder, "-q")
        named = re.search(r"cell \d+ of (the body|region 'water'), which started near \(.*\) m, turned inside out .*at t = "
                          rf"{stop + 1} s", said)
        kept = stop == 0 or abs(time_of(folder) - stop) < 1e-9
        result.add(None if code == 6 and named and kept else f"{side} from {stop} by {x:g}, {y:g}, kept {time_of(folder)}: {code} {said}")
    return result.report()


def ranks(count, seed):
    """From N ranks to M, for all pairs of the first `count` - 1 of RANKS; within 1e-8 of each other."""
    result, numbers = Count("from N ranks to M: within 1e-8"), RANKS[:max(2, count - 1)]
    deck = edited("ranks", output_checkpoint_every="3", newton_tolerance="1e-11", linear_tolerance="1e-12",
                  linear_keep_factor="false", time_end="120")
    whole = fresh("ranks.whole")
    code, said = run("run", deck, "-o", whole, "-q", seconds=300)
    assert code == 0, said
    step, worst = Results(whole).steps()[-1], 0.0
    for before in numbers:
        folder = fresh(f"ranks.{before}")
        run("run", deck, "-o", folder, "-q", "--end", "60", ranks=before, seconds=300)
        for after in numbers:
            other = fresh("ranks.after")
            code, said = run("restart", folder / "checkpoint.h5", "-q", "--end", "120", "-o", other, ranks=after, seconds=300)
            if code != 0:
                result.add(f"{before} to {after}: {code} {said}")
                continue
            there, here = Results(whole).fields(step), Results(other).fields(step)
            apart = max(difference(here[name], there[name]) for name in ("displacement", "velocity"))
            worst = max(worst, apart)
            result.add(None if apart < 1e-8 else f"{before} to {after}: {apart:.1e} apart")
    print(f"  largest difference {worst:.1e}")
    return result.report()


def growth(count, seed):
    """The resident set after the first tenth of `count` steps and at their end."""
    folder = fresh("growth")
    with start("run", DECK, "-o", folder, "-q", "--set", "time/step=0.01", "--set", f"time/end={0.01 * count}",
               "--set", "output/fields-every=0", "--set", f"output/checkpoint-every={max(1, count // 20)}") as process:
        first = last = None
        while process.poll() is None:
            try:
                status = Path(f"/proc/{process.pid}/status").read_text()
                rows = (folder / "history.csv").read_text().count("\n") - 1
            except FileNotFoundError:
                continue
            if "VmRSS" in status:
                last = int(status.split("VmRSS:")[1].split()[0])
                if first is None and rows >= count // 10:
                    first = last
            time.sleep(0.5)
        _, said = process.communicate()
    result = Count(f"{count} steps: the resident set grows by less than 1 %")
    if process.returncode != 0 or first is None:
        result.add(f"{process.returncode} {said}")
    else:
        grown = last / first - 1
        print(f"  {first} KiB after {count // 10} steps, {last} KiB at the end: {100 * grown:+.2f} %")
        result.add(None if grown < 0.01 else f"grown by {100 * grown:.1f} %")
    return result.report()
