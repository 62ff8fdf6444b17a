"""Makes doc/verification.md and its plots from what the tests measured.

python3 tests/verification/page.py            # write, from build/tests
python3 tests/verification/page.py --check    # exit code 1 when the committed page is stale

Sources: build/tests/figures/*.json (tests/support/figure.hpp), and the folders of the tests of decks in
build/tests/run: converge.json of `hawser converge`, the expectations in summary.json of `hawser run`. Only tests that
ctest knows count. A row whose test was not run here stays as it is, and its number may differ within the tolerance.
"""
import argparse
import json
import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "doc/verification.md"
sys.path.insert(0, str(ROOT / "apps/figures"))

HEAD = """# Verification

Made from runs by `tests/verification/page.py`; do not edit. Every number was printed by a test of this repository, with
the reference it is judged by, the difference that is allowed, and the command that makes it again (`build/` is the
build folder; `ctest -L slow` has the longer ones). How the tests are written: [testing.md](testing.md).
"""


def number(value, tolerance=0):
    """Four digits, or as many as tell a hundredth of the tolerance."""
    digits = math.ceil(math.log10(abs(value) / tolerance)) + 2 if value and tolerance else 4
    return f"{value:.{min(max(digits, 4), 12)}g}"


def holds(row):
    above = row["value"] - row["reference"]
    return abs(above) <= row["tolerance"] or (row["is"] == "at-least" and above > 0) or (
        row["is"] == "at-most" and above < 0)


def known_tests(build):
    said = subprocess.run(["ctest", "--test-dir", str(build), "-N"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"Test\s+#\d+: (\S+)", said)


def recorded(build):
    return [json.loads(path.read_text()) for path in sorted((build / "tests/figures").glob("*.json"))]


def expected(build, tests):
    rows = []
    for path in sorted((build / "tests/run").glob("deck.*.np*/summary.json")) + sorted(
            (build / "tests/run").glob("deck.*/summary.json")):
        name = path.parent.name
        if not any(test == name or test.startswith(name + ".np") for test in tests):
            continue
        summary = json.loads(path.read_text())
        for quantity, entry in summary.get("expectations", {}).items():
            if isinstance(entry, dict) and isinstance(entry["got"], float | int):
                rows.append({"name": f"{name}.{quantity}", "section": "Decks", "what": f"{name[5:]}: {quantity}",
                             "unit": "", "value": entry["got"], "reference": entry["expected"],
                             "tolerance": entry["within"], "is": "within", "source": entry["why"],
                             "command": f"ctest --test-dir build -R '^{name}'"})
    return rows


def converged(build, tests):
    """(row, result) per judged quantity of each study."""
    found = []
    for path in sorted((build / "tests/run").glob("converge.*/converge.json")):
        name = path.parent.name
        if not any(test.startswith(name + ".np") for test in tests):
            continue
        result = json.loads(path.read_text())
        for quantity, entry in result["quantities"].items():
            if "at_least" in entry:
                found.append(({"name": f"{name}.{quantity}", "section": "Orders of accuracy",
                               "what": f"{result['title']}: {quantity}", "unit": "1", "value": entry["finest_pair"],
                               "reference": entry["at_least"], "tolerance": 0, "is": "at-least",
                               "source": entry["why"], "command": f"ctest --test-dir build -R '^{name}[.]'",
                               "fitted": entry["fitted"], "error": entry.get("fitted_standard_error", float("nan"))},
                              (name, result)))
    return found


def kept(text, rows, tests):
    """{section: [(name, line)]} of the page's rows whose test is known and did not run here, such as a slow one."""
    ran = {row["command"] for row in rows}
    lines, section = {}, ""
    for line in text.splitlines():
        section = line[3:] if line.startswith("## ") else section
        match = re.match(r"\| <!-- (\S+) -->.*\| `(.*-R '(.*)')` \|$", line)
        if match and match.group(2) not in ran and any(re.search(match.group(3), test) for test in tests):
            lines.setdefault(section, []).append((match.group(1), line))
    return lines


def table(rows, others):
    lines = ["| figure | value | reference | allowed | why | command |", "|---|---|---|---|---|---|"]
    named = list(others)
    for row in rows:
        unit = "" if row["unit"] in ("", "1") else " " + row["unit"]
        allowed = {"within": "± ", "at-least": "at least − ", "at-most": "at most + "}[row["is"]] + number(row["tolerance"])
        named.append((row["name"], f"| <!-- {row['name']} -->{row['what']} | {number(row['value'], row['tolerance'])}{unit}"
                      f" | {number(row['reference'], row['tolerance'])} | {allowed} | {row['source']} | `{row['command']}` |"))
    return "\n".join(lines + [line for _, line in sorted(named)]) + "\n"


def order_table(studies, others):
    lines = ["| study | order, finest pair | fitted | asked for | why | command |", "|---|---|---|---|---|---|"]
    named = list(others)
    for row, _ in studies:
        named.append((row["name"], f"| <!-- {row['name']} -->{row['what']} | {row['value']:.3f}"
                      f" | {row['fitted']:.3f} ± {row['error']:.3f} | ≥ {number(row['reference'])} | {row['source']}"
                      f" | `{row['command']}` |"))
    return "\n".join(lines + [line for _, line in sorted(named)]) + "\n"


ORDERS = "Orders of accuracy"


def page(rows, studies, others):
    """The text; `others` are kept()."""
    pictures = {name: result["title"] for _, (name, result) in studies}
    for name, line in others.get(ORDERS, []):
        pictures[name.rpartition(".")[0]] = line.split(" | ")[0].split("-->")[1].rpartition(": ")[0]
    parts = [HEAD, f"\n## {ORDERS}\n\nErrors against manufactured solutions "
             "(`inputs/verification`; `hawser converge`), on meshes that move. The fitted order is that of least squares "
             "over all levels, with its standard error.\n\n", order_table(studies, others.get(ORDERS, [])), "\n"]
    parts += [f"![{title}](images/{name}.svg)\n" for name, title in sorted(pictures.items())]
    sections = {}
    for row in rows:
        sections.setdefault("Further orders" if row["section"] == ORDERS else row["section"], []).append(row)
    for section in sorted({*sections, *others} - {ORDERS}, key=lambda s: (s != "Further orders", s)):
        parts.append(f"\n## {section}\n\n{table(sections.get(section, []), others.get(section, []))}")
    return "".join(parts)


def stale(text, rows):
    """What is wrong with the committed page, as sentences."""
    committed = {}
    for line in text.splitlines():
        match = re.match(r"\| <!-- (\S+) -->.*? \| ([-+.\deE]+)", line)
        if match:
            committed[match.group(1)] = float(match.group(2))
    faults = []
    for row in rows:
        if row["name"] not in committed:
            faults.append(f"{row['name']} is not on the page")
        elif not holds({**row, "value": committed[row["name"]]}):
            faults.append(f"{row['name']} is {committed[row['name']]} on the page, which the test would not accept")
    return faults, committed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    tests = known_tests(given.build)
    studies = converged(given.build, tests)
    rows = recorded(given.build) + expected(given.build, tests)
    wrong = [row["name"] for row in rows + [row for row, _ in studies] if not holds(row)]
    if wrong:
        sys.exit("these tests failed: " + ", ".join(wrong))
    if given.check:
        faults, committed = stale(PAGE.read_text(), rows + [row for row, _ in studies])
        stems = {name.split(".")[0] for name in (re.sub(r"[.]np\d+$", "", test) for test in tests)}
        faults += [f"{name} is on the page, and no test is called {name.split('.')[0]}" for name in committed
                   if name.split(".")[0] not in stems]
        sys.exit("\n".join([*faults, "python3 tests/verification/page.py writes the page anew"]) if faults else 0)
    from convergence_figure import draw
    others = kept(PAGE.read_text(), rows + [row for row, _ in studies], tests)
    results = {name: result for _, (name, result) in studies}
    for name, result in results.items():
        draw(result, ROOT / "doc/images" / name, picture=False)
    PAGE.write_text(page(rows, studies, others))
    print(f"{PAGE}: {len(rows) + len(studies)} figures, {len(results)} plots; "
          f"{sum(map(len, others.values()))} rows of tests not run here stay")


if __name__ == "__main__":
    main()
