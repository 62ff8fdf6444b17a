"""Two hundred steps of a two-thousandth of the length in the middle of a tow leave no mark on the pressure."""
import numpy as np

from harness import BUILD, ROOT, Results, SystemTest, completed, difference, figures, fresh, main

SECTION = "Flows"
COMMAND = "ctest --test-dir build -R '^system.cut_steps$'"


def alternation(fields):
    """Mean deviation of the far pressure from the plane through its neighbours, relative to the mean range of those."""
    points, pressure = fields["points"][:, :2], fields["pressure"]
    neighbours = [set() for _ in pressure]
    for cell in fields["cells"].reshape(-1, 3):
        for node in cell:
            neighbours[node].update(cell)
    deviations, ranges = [], []
    for node, near in enumerate(neighbours):
        near = np.array(sorted(near - {node}))
        if len(near) < 5 or np.hypot(*points[node]) < 1000:
            continue
        plane = np.column_stack([np.ones(len(near)), points[near] - points[node]])
        deviations.append(abs(pressure[node] - np.linalg.lstsq(plane, pressure[near], rcond=None)[0][0]))
        ranges.append(np.ptp(pressure[near]))
    return np.mean(deviations) / np.mean(ranges)


def go_on(name, checkpoint, end, *settings):
    folder = fresh(name)
    changes = [word for setting in settings for word in ("--set", setting)]
    completed(1, "restart", checkpoint, "-o", folder, "-q", "--end", end, *changes, seconds=900)
    return Results(folder)


class CutSteps(SystemTest):
    def test_short_steps_leave_no_mark_on_the_pressure(self):
        begun = fresh("begun")
        completed(1, "run", ROOT / "inputs/deep_tow/case_02_quick.xml", "-o", begun, "-q", "--end", 400, "--set",
                  "output/checkpoint-at-end=true", seconds=900)
        whole = go_on("whole", begun / "checkpoint.h5", 600)
        cut = go_on("cut", begun / "checkpoint.h5", 402, "time/step=0.01", "output/checkpoint-at-end=true")
        self.assertGreaterEqual(cut.summary()["steps"], 200)
        after = go_on("after", cut.folder / "checkpoint.h5", 600, "time/step=20")
        fields = {run: run.fields(run.steps()[-1]) for run in (Results(begun), whole, cut, after)}
        before, end, short, later = (alternation(fields[run]) for run in fields)
        change = difference(fields[after]["pressure"], fields[whole]["pressure"])
        for name, what, value, reference, tolerance in (
                ("short", "alternation of the far pressure after 200 steps of 0.01 s", short, before, 0.25 * before),
                ("later", "the same at 600 s, after longer steps again", later, end, 0.1 * end),
                ("pressure", "largest difference of the pressure at 600 s from the run without, relative", change, 0, 0.01)):
            with self.subTest(name):
                self.assertTrue(figures.record(BUILD, f"system.cut_steps.{name}", SECTION, f"case 2, quick: {what}", value, reference,
                                               tolerance, "the run with steps of 20 s", COMMAND), f"{what}: {value}, {reference}")


if __name__ == "__main__":
    main()
