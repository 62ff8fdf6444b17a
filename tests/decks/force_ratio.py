"""The tow force of case 4 (90 degrees) over that of case 1 (0 degrees) at U = 0.5 m/s: 0.68 +- 0.02.

By the boundary-layer formula of an aligned plate at each case's relative speed the ratio is 0.684.
"""
import json
import sys
from pathlib import Path

folder = Path(sys.argv[1])
force = {case: json.loads((folder / f"deck.deep_tow.{case}/summary.json").read_text())["tow_force_n_per_m"]
         for case in ("case_01_quick", "case_04_quick")}
ratio = force["case_04_quick"] / force["case_01_quick"]
print(f"|F4|/|F1| = {force['case_04_quick']:.1f}/{force['case_01_quick']:.1f} = {ratio:.4f}")
sys.exit(0 if abs(ratio - 0.68) <= 0.02 else 1)
