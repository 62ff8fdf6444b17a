"""What may be meant, but probably is not, is told before the first step: by `check --mesh`, by the dry run, in the
run's head and in its summary, in the same words; and not a word where it is said to be meant."""
import json

from harness import ROOT, SCRATCH, SystemTest, completed, fresh, main

MESHES = ROOT / "tests/bad_decks/meshes"
FLUID = '<ale-fluid region="near" density="1" viscosity="1"/>'
CABLE = ('<cable region="{}" mass-per-length="2.9" axial-stiffness="1e7"><drag current="0; -0.5" diameter="0.06"/>'
         "</cable>")


def deck(name, body):
    path = SCRATCH / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'<?xml version="1.0"?>\n<hawser>\n{body}\n</hawser>\n')
    return path


def line(conditions="", inside="", end=200, modules=CABLE.format("cable"), output=""):
    """A cable of 100 m towed along x at 0.2 m/s."""
    return f"""<mesh><line from="0 0" to="0 -100" segments="4"/></mesh>
<modules>{modules}</modules>
<conditions>
{conditions or '<prescribe field="displacement" on="tow-point" value="0.2*ramp_distance(t, 0, 100); 0"/>'}
</conditions>
<time step="20" end="{end}"/>
<solver><linear method="mumps"/><newton line-search="false" max-iterations="40" divergence="1e14"/></solver>
{output}
{inside}"""


def tow(**attributes):
    given = {"angle": "90", "speed": "0.2", "current": "0.5", **attributes}
    return ('<tow cable="cable" tow-point="tow-point" '
            + " ".join(f'{name}="{value}"' for name, value in given.items() if value) + "/>")


def square(conditions, mesh="", modules='<ale-fluid region="near far" density="1" viscosity="1"/>'):
    return f"""<mesh {mesh}><file name="{MESHES}/overlapping_groups.msh"/></mesh>
<modules>{modules}</modules>
<conditions>
{conditions}
</conditions>
<time step="1" end="2"/>"""


def disagreeing(first, second, more=""):
    """Two prescriptions on the tow point."""
    return line(f'<prescribe field="displacement" on="tow-point" value="{first}"/>\n'
                f'<prescribe field="displacement" on="tow-point" value="{second}"{more}/>')


# name: deck, what is told (a regular expression) or nothing
CASES = {
    "cells in no module": (square("", modules=FLUID), r"1 cell of the body's 4, of 'far', belong to no module"),
    "they are meant": (square("", mesh='apart="far"', modules=FLUID), None),
    "a first displacement far away": (
        line('<prescribe field="displacement" on="tow-point" value="30; 0"/>'),
        r":6:2: at the start, t = 0 s, the displacement on 'tow-point' is 30 m from its initial value, at \(0, 0\)"),
    "far away with a formula": (
        line('<prescribe field="displacement" on="tow-point" value="0.2*t - 5; 1"/>'), r"is 5\.09902 m from its initial"),
    "far away in y alone": (
        line('<prescribe field="displacement" on="tow-point" component="y" value="12"/>'), "is 12 m from its initial"),
    "far away from a given place": (
        line('<initial field="displacement" on="cable" value="30; 0"/>'
             '<prescribe field="displacement" on="tow-point" value="0; 0"/>'), "is 30 m from its initial value"),
    "at its given place": (
        line('<initial field="displacement" on="cable" value="30; 0"/>'
             '<prescribe field="displacement" on="tow-point" value="30; 0"/>'), None),
    "a displacement that begins at zero": (line(), None),
    "two values at a node": (
        disagreeing("0 0", "0.1*t; 0"),
        r":7:2: 'displacement' on 'tow-point' disagrees with 'displacement' on 'tow-point' of \S+:6:2 at 1 node that "
        r"both have, \(0, 0\): component x is 2 there, and was to be 0 \(t = 20 s\)\. The later one holds"),
    "they are meant to": (disagreeing("0 0", "0.1*t; 0", ' replaces="true"'), None),
    "two equal values": (disagreeing("0.1*t; 0", "t/10; 0"), None),
    "two values at different times": (disagreeing("0.01*t; 0", "1; 0", ' from="100"'),
                                      r"component x is 1 there, and was to be 2 \(t = 200 s\)"),
    "a window after the end": (
        line('<prescribe field="displacement" on="tow-point" value="0 0"/>'
             '<prescribe field="displacement" on="tow-point" from="500" value="1; 0"/>'),
        "it never holds: the run ends at t = 200 s, and this from 500 s on"),
    "a window before the start": (
        line('<prescribe field="displacement" on="tow-point" value="0 0"/>'
             '<prescribe field="displacement" on="tail" until="0" value="0 0"/>'),
        "it never holds: the run begins at t = 0 s, and this is until 0 s"),
    "an axis that fits": (line(inside=tow()), None),
    "an axis that is left": (
        line('<prescribe field="displacement" on="tow-point" value="0.2*t; 0.1*ramp_distance(t, 100, 50)"/>',
             inside=tow()), r"does not always move along the axis of <tow>, angle=\"90\": at t = "),
    "another speed": (line(inside=tow(speed="0.3")),
                      r"the tow point reaches 0\.2 m/s, and <tow> says speed=\"0\.3\""),
    "no current": (line(inside=tow(current="")), "no exact value to compare the errors with: <tow> does not say current"),
    "no speed": (line(inside=tow(speed="")), "<tow> does not say speed"),
    "neither": (line(inside=tow(speed="", current="")), "<tow> does not say speed and current"),
    "a checkpoint after the end": (line(output='<output checkpoint-every="50"/>'),
                                   r"a checkpoint is asked for every 50 steps, and in steps of 20 s the run ends before"),
    "receivers after the end": (
        line(inside=tow().replace("/>", '><receivers every="50"/></tow>')), "asked for every 50 steps"),
}


def notes(said):
    return [text[12:] for text in said.splitlines() if text.startswith("note ")]


class Notes(SystemTest):
    def test_each_is_told_by_the_check(self):
        for name, (body, expected) in CASES.items():
            for ranks in (1, 2) if expected and "node" in name else (1,):
                with self.subTest(name, ranks=ranks):
                    told = notes(completed(ranks, "check", "--mesh", deck(name.replace(" ", "_"), body)).stdout)
                    self.assertEqual(len(told), 1 if expected else 0, told)
                    if expected:
                        self.assertRegex(told[0], expected)

    def test_the_same_words_everywhere(self):
        for ranks in 1, 2:
            path = deck("everywhere", CASES["two values at a node"][0])
            checked = notes(completed(ranks, "check", "--mesh", path).stdout)
            self.assertEqual(len(checked), 1)
            self.assertEqual(notes(completed(ranks, "run", "--dry-run", path).stdout), checked)
            run = completed(ranks, "run", path, "-o", fresh("everywhere"), "--log-json")
            events = [json.loads(text) for text in run.stdout.splitlines()]
            start = [event["event"] for event in events].index("start")
            self.assertIn(checked[0], [event.get("text") for event in events[:start]])
            self.assertEqual(events[-1]["summary"]["notes"], checked)

    def test_a_shortened_run_says_less(self):
        body = line(inside=tow().replace("/>", '><receivers times="100 200"/></tow>'))
        run = completed(1, "run", deck("shortened", body), "--end", "100", "-o", fresh("shortened"))
        self.assertRegex(run.stdout, r"receivers are asked for at t = 200 s, and the run ends at 100 s, which is not the "
                                     r"deck's end")


class Shipped(SystemTest):
    def test_decks_have_no_notes(self):
        for folder in "tutorials", "structures", "verification":
            for path in sorted((ROOT / "inputs" / folder).glob("*.xml")):
                with self.subTest(path.name):
                    told = notes(completed(1, "check", "--mesh", path).stdout)
                    self.assertEqual([one for one in told if "hinged" not in one], [])  # as two_cables means it


if __name__ == "__main__":
    main()
