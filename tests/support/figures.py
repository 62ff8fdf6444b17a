"""Measured numbers that doc/verification.md tells: record(...) beside the assertion that judges them."""
import json
from pathlib import Path


def record(build, name, section, what, value, reference, tolerance, source, command, unit="1", **rule):
    """Writes BUILD/tests/figures/NAME.json; the keys are explained in tests/support/figure.hpp.

    `command` makes the number again; is_="at-least" or "at-most" judges from one side only. True when it holds.
    """
    one_sided = rule.get("is_", "within")
    above = value - reference
    holds = abs(above) <= tolerance or (above > 0 if one_sided == "at-least" else
                                        above < 0 if one_sided == "at-most" else False)
    folder = Path(build) / "tests/figures"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.json").write_text(json.dumps(
        {"name": name, "section": section, "what": what, "unit": unit, "value": float(value),
         "reference": float(reference), "tolerance": float(tolerance), "is": one_sided, "source": source,
         "command": command}, indent=1) + "\n")
    return bool(holds)
