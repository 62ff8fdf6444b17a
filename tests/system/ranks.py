"""The answer does not depend on the number of ranks, and the same run twice is the same to the last bit."""
import numpy as np

from harness import SystemTest, difference, edited, main, run

TIGHT = dict(newton_tolerance="1e-11", output_fields_every="5")
BOUNDS = {"displacement": 1e-10, "velocity": 1e-8, "pressure": 1e-7}
FORCES = "tow_force_n_per_m", "tow_force_along_n_per_m", "tow_force_across_n_per_m"


class NumberOfRanks(SystemTest):
    def compare(self, name, **changes):
        deck = edited(name, **TIGHT, **changes)
        one = run(f"{name}.np1", deck)
        worst = dict.fromkeys([*BOUNDS, "force"], 0)
        for ranks in 2, 3, 4:
            many = run(f"{name}.np{ranks}", deck, ranks)
            with self.subTest(ranks=ranks):
                self.assertEqual(many.summary()["provenance"]["ranks"], ranks)
                self.assertSameCounts(one, many)
                for quantity, value in self.assertNear(one, many, 5, BOUNDS, 1e-9).items():
                    worst[quantity] = max(worst[quantity], value)
                self.assertNear(one, many, 10, {"displacement": 1e-8}, 1e-8)
        for quantity, bound in {**BOUNDS, "force": 1e-9}.items():
            self.assertRecorded(f"{name}_{quantity}", f"{quantity} on 2, 3 and 4 ranks against 1, 5 steps, {name}, relative",
                                worst[quantity], bound, "the order of sums in the linear solver")

    def assertSameCounts(self, one, many):
        counts = one.history()["newton_iterations"]
        self.assertGreater(counts.max(), 2)
        self.assertEqual(list(many.history()["newton_iterations"]), list(counts))

    def assertNear(self, one, many, steps, bounds, force_bound):
        there, here = one.fields(steps), many.fields(steps)
        np.testing.assert_array_equal(here["cells"], there["cells"])
        found = {name: difference(here[name], there[name]) for name in bounds}
        a, b = one.history(), many.history()
        found["force"] = max(difference(b[force][:steps], a[force][:steps]) for force in FORCES)
        print(f"{many.folder.name}, {steps} steps:", {name: f"{value:.1e}" for name, value in found.items()})
        for name, bound in {**bounds, "force": force_bound}.items():
            self.assertLessEqual(found[name], bound, name)
        return found

    def test_with_gmres(self):
        self.compare("gmres", linear_tolerance="1e-12", linear_keep_factor="false")

    def test_with_mumps(self):
        self.compare("mumps", linear_method="mumps", linear_tolerance="1e-12")


class Repeatability(SystemTest):
    def test_gmres_with_a_kept_factor(self):
        deck = edited("twice", output_fields_every="1")
        for ranks in 1, 2:
            first, second = (run(f"twice.{word}.np{ranks}", deck, ranks) for word in ("once", "again"))
            with self.subTest(ranks=ranks):
                for table in "history.csv", "cable.csv":
                    self.assertEqual((first.folder / table).read_bytes(), (second.folder / table).read_bytes())
                self.assertEqual(first.steps(), list(range(1, 11)))
                for grid in "flow", "cable":
                    for step in first.steps(grid):
                        a, b = first.fields(step, grid), second.fields(step, grid)
                        for name in a:
                            np.testing.assert_array_equal(a[name], b[name], f"{grid} {name} {step}", strict=True)
        self.assertRecorded("repeated", "the same run twice, on 1 and on 2 ranks: largest difference of all that is written",
                            0, 0, "compared to the last bit")


if __name__ == "__main__":
    main()
