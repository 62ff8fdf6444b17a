"""The lid-driven cavity, steady from rest: Newton's method alone does not get there, continued in pseudo-time it does."""
import numpy as np

from harness import BUILD, ROOT, SystemTest, difference, figures, fresh, hawser, main, run

DECK = ROOT / "inputs/verification/cavity.xml"
SOURCE = "Botella and Peyret, Computers & Fluids 27 (1998) 421-433, table 9"
COMMAND = "ctest --test-dir build -R '^system.cavity$'"


class Cavity(SystemTest):
    def test_re_1000_has_the_published_extremes_on_the_centre_lines(self):
        result = run("re_1000", DECK)
        fields = result.fields(1)
        x, v = fields["points"], fields["velocity"]
        upright, level = np.abs(x[:, 0] - 0.5) < 1e-9, np.abs(x[:, 1] - 0.5) < 1e-9
        for name, value, reference in (("u_min", v[upright, 0].min(), -0.3885698), ("v_max", v[level, 1].max(), 0.3769447),
                                       ("v_min", v[level, 1].min(), -0.5270771)):
            self.assertTrue(figures.record(BUILD, f"system.cavity.{name}", "Flows", f"lid-driven cavity, Re 1000: {name}", value,
                                           reference, 0.005 * abs(reference), SOURCE, COMMAND, "m/s"), f"{name}: {value}")
        self.assertLessEqual(result.summary()["newton_iterations"], 25)

    def test_re_5000_converges_from_rest(self):
        result = run("re_5000", DECK, 1, "--set", "viscosity=0.0002", "--set", "mesh/water-box/cells=64 64")
        self.assertLessEqual(result.summary()["newton_iterations"], 50)

    def test_re_5000_is_reached_from_re_100_without_pseudo_time(self):
        way = "start/equilibrium/continuation/"
        result = run("continued", DECK, 1, "--set", "viscosity=0.0002", "--set", "mesh/water-box/cells=64 64",
                     "--set", "solver/newton/pseudo-step=0", "--set", f"{way}parameter=viscosity", "--set", f"{way}from=0.01",
                     "--set", f"{way}spacing=geometric", "--set", f"{way}steps=5")
        self.assertLessEqual(result.summary()["start_newton_iterations"], 40)
        self.assertEqual(result.summary()["newton_iterations"], 0)
        direct = run("direct", DECK, 1, "--set", "viscosity=0.0002", "--set", "mesh/water-box/cells=64 64")
        self.assertLess(difference(result.fields(1)["velocity"], direct.fields(1)["velocity"]), 1e-5)

    def test_newton_alone_says_what_stops_it(self):
        done = hawser(1, "run", DECK, "-o", fresh("alone"), "--set", "solver/newton/pseudo-step=0",
                      "--set", "mesh/water-box/cells=64 64")
        self.assertEqual(done.returncode, 6)
        self.assertIn("the residual diverges", done.stderr)
        self.assertIn('what may lead to a steady solution: <newton pseudo-step="1"/>;', done.stderr)


if __name__ == "__main__":
    main()
