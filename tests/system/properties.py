"""Properties that modules and decks supply, against what is known exactly or published."""
from harness import BUILD, ROOT, SCRATCH, SystemTest, difference, figures, hawser, main, run

CONVECTION = ROOT / "inputs/verification/natural_convection.xml"
POROUS = """<hawser title="A stream through a porous plug">
  <mesh><water-box min="0 0" max="2 1" cells="10 4"/></mesh>
  <modules>
    <ale-fluid region="water" density="2" viscosity="0.1"><outflow on="right" kind="pressure" pressure="3"/></ale-fluid>
    SUPPLY
  </modules>
  <conditions>
    <prescribe field="velocity" on="left" value="1.5 0"/>
    <prescribe field="velocity" on="top bottom" component="y" value="0"/>
  </conditions>
  <time scheme="steady" end="1"/>
  <extreme name="p" of="pressure" on="water"/>
  <solver><linear method="mumps" tolerance="1e-10"/><newton tolerance="1e-12"/></solver>
</hawser>"""
ZONE = '<porous-zone region="water" linear="0.3" quadratic="0.7"/>'
FORMULA = ('<property name="body force" region="water" value="-(0.3 + 0.7*sqrt(velocity_x^2 + velocity_y^2 + 1e-20))*velocity_x; '
           '-(0.3 + 0.7*sqrt(velocity_x^2 + velocity_y^2 + 1e-20))*velocity_y"/>')


def plug(name, supply):
    SCRATCH.mkdir(parents=True, exist_ok=True)
    deck = SCRATCH / f"{name}.xml"
    deck.write_text(POROUS.replace("SUPPLY", supply))
    return deck


class Properties(SystemTest):
    def test_a_porous_zone_takes_the_pressure_that_its_law_says(self):
        for ranks in 1, 2:
            summary = run(f"zone_np{ranks}", plug("zone", ZONE), ranks).summary()
            self.assertAlmostEqual(summary["p_max_pa"], 3 + 2 * (0.3 + 0.7 * 1.5) * 1.5 * 2, delta=1e-9)
            self.assertAlmostEqual(summary["p_min_pa"], 3, delta=1e-9)

    def test_the_same_law_by_formula_is_the_same_to_rounding(self):
        module, formula = (run(name, plug(name, supply)) for name, supply in (("module", ZONE), ("formula", FORMULA)))
        there, here = module.fields(module.steps()[-1]), formula.fields(formula.steps()[-1])
        for field in "velocity", "pressure":
            self.assertLess(difference(here[field], there[field]), 1e-12)
        self.assertEqual(module.summary()["newton_iterations"], formula.summary()["newton_iterations"])

    def test_natural_convection_has_the_published_heat_flux(self):
        """De Vahl Davis' square; the flux is the reaction of the temperature's rows."""
        for rayleigh, cells, nusselt, within in (("1e3", 40, 1.1178, 2e-3), ("1e4", 80, 2.2448, 2e-3)):
            result = run(f"convection_{rayleigh}", CONVECTION, 1, "--set", f"rayleigh={rayleigh}", "--set", f"cells={cells}")
            self.assertTrue(figures.record(
                BUILD, f"system.convection.{rayleigh}", "Flows", f"natural convection, Rayleigh number {rayleigh}: Nusselt number",
                result.summary()["nusselt_flux_w_per_m"], nusselt, within * nusselt,
                "de Vahl Davis, Int. J. Numer. Methods Fluids 3 (1983) 249-264; Le Quere, Computers & Fluids 20 (1991) 29-41",
                "ctest --test-dir build -R '^system.properties$'", "1"))

    def test_what_does_not_fit_is_told(self):
        sentences = {
            '<property name="viscosty" region="water" value="1"/>': "did you mean 'viscosity'",
            '<property name="viscosity" region="water" value="1"/>': "gets 'viscosity' from its own attribute and from",
            '<property name="body force" region="water" adds="true" value="1"/>': "has 2 components, and here are 1",
            '<property name="eddy viscosity" region="water" value="temperatur"/>': "is no field of this run",
            '<property name="eddy viscosity" region="left" value="1"/>': "needs a region of triangles",
            '<property name="eddy viscosity" region="water" value="2 kg"/>': "'2 kg' is in kg, and 'eddy viscosity' in m^2/s",
        }
        for supply, sentence in sentences.items():
            with self.subTest(supply):
                done = hawser(1, "check", "--mesh", plug("unfit", supply))
                self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
                self.assertRegex(done.stderr, r"unfit\.xml:[0-9]+:[0-9]+: ")
                self.assertIn(sentence, done.stderr)

    def test_a_needed_property_that_nobody_gives_is_told(self):
        deck = plug("lacking", ZONE)
        deck.write_text(deck.read_text().replace(' viscosity="0.1"', ""))
        done = hawser(1, "check", "--mesh", deck)
        self.assertEqual(done.returncode, 3)
        self.assertIn("needs 'viscosity' (Pa s) on all of 'water', and nobody gives it there", done.stderr)

    def test_the_jacobian_of_a_deck_is_checked(self):
        done = hawser(1, "jacobian", CONVECTION, "--set", "cells=6")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("velocity by temperature", done.stdout)
        self.assertIn("every block within 1e-06 of central differences", done.stdout)


if __name__ == "__main__":
    main()
