"""A page with tables and figures on the results of a study: python3 study_report.py FOLDER

Writes FOLDER/report/index.html, which needs no other file, and each figure as PNG and SVG beside it."""
import html
import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt

import deep_tow as dt
import deep_tow_claims
import deep_tow_figures as draw
import deep_tow_forces
from figure_style import Figures, style
from page_table import cell, table
from study_results import Study, number

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>
body {{ font-family: "DejaVu Sans", Verdana, sans-serif; max-width: 72em; margin: 2em auto; padding: 0 1em; color: #111; line-height: 1.45 }}
table {{ border-collapse: collapse; margin: 1em 0 }} td, th {{ border: 1px solid #999; padding: .25em .6em; text-align: left; vertical-align: top }}
td.n {{ text-align: right; font-variant-numeric: tabular-nums }} th {{ background: #eee }}
tr.failed td, td.no {{ background: #fde0d0 }} td.yes {{ background: #d8efe6 }} td.about {{ background: #fdf3d0 }}
figure {{ margin: 2em 0 }} figure img {{ max-width: 100% }} figcaption {{ max-width: 56em; color: #333 }}
@media print {{ body {{ max-width: none }} figure, tr {{ break-inside: avoid }} }}
</style></head><body>
<h1>{title}</h1>
{body}
</body></html>
"""

QUANTITIES = [("end_error_m", "end error (m)", "{:.2f}"), ("end_error_exact_m", "exact, stretched (m)", "{:.2f}"),
              ("total_error_m", "total error (m)", "{:.2f}"), ("total_error_arc_m", "along the cable (m)", "{:.2f}"),
              ("tow_force_n_per_m", "tow force (N/m)", "{:.0f}"), ("line_force_n_per_m", "force (N/m)", "{:.0f}"),
              ("mesh_quality_min", "mesh quality", "{:.2f}"), ("steps_rejected", "steps cut", "{:.0f}")]

REFINED = ("step", "mesh_scale")  # what a deck's discretisation follows from
LIMITED = ("end_error_m", "total_error_arc_m", "tow_force_n_per_m", "line_force_n_per_m")


def case_rows(sweep):
    """One row per case; a failed one says why."""
    known = [q for q in QUANTITIES if any(math.isfinite(case.quantity(q[0])) for case in sweep.finished)]
    rows = []
    for case in sweep.cases:
        cells = cell(case.name) + cell(case.title)
        if case.finished:
            cells += cell("done" if case.exit_code == 0 else "an expectation does not hold")
            cells += "".join(cell(case.quantity(name), form) for name, _, form in known)
            cells += cell(case.wall, "{:.0f}") + cell(case.cpu, "{:.0f}")
            rows.append(f'<tr id="{case.sweep}-{case.name}">{cells}</tr>')
        else:
            said = f"{case.state}, exit code {case.exit_code}: {case.reason}" if case.state == "failed" else case.state
            rows.append(f'<tr class="failed" id="{case.sweep}-{case.name}">{cells}<td colspan="{len(known) + 3}">'
                        f"{html.escape(said)}</td></tr>")
    return table(["case", "what", "state", *(label for _, label, _ in known), "wall (s)", "CPU (s)"], rows)


def by_value(sweep):
    """The runs of a sweep that varies one value, with that value, ascending; none where it varies others."""
    if len(sweep.varied) != 1:
        return []
    runs = [(number(case.values[sweep.varied[0]]), case) for case in sweep.finished]
    return sorted((run for run in runs if run[0] is not None), key=lambda run: run[0])


def curves(sweep, figures):
    """Errors and forces over the one value that a sweep varies."""
    points = by_value(sweep)
    shown = [q for q in QUANTITIES if q[0] in ("end_error_m", "total_error_arc_m", "tow_force_n_per_m")
             and all(math.isfinite(case.quantity(q[0])) for _, case in points)]
    if len(points) < 2 or not shown:
        return
    path = sweep.varied[0]
    unit = " ".join(str(points[0][1].values[path]).split()[1:])
    figure, panels = plt.subplots(1, len(shown), figsize=(4.4 * len(shown), 3.6), squeeze=False)
    x = [value for value, _ in points]
    for i, (axes, (name, label, _)) in enumerate(zip(panels[0], shown)):
        axes.plot(x, [case.quantity(name) for _, case in points], **style(i))
        axes.set(xlabel=f"{path.split('/')[-1].replace('_', ' ')} ({unit or '-'})", ylabel=label)
        if x[0] > 0 and x[-1] / x[0] > 8:
            axes.set_xscale("log")
    figure.tight_layout()
    figures.save(figure, f"sweep_{sweep.name}", f"{sweep.meaning or sweep.name}")


def limits(sweep):
    """Where a sweep refines the step or the mesh in one ratio: what its quantities tend to, by the three finest runs."""
    runs = by_value(sweep)[2::-1]
    sizes = [size for size, _ in runs]
    if len(runs) < 3 or sweep.varied[0] not in REFINED or not math.isclose(sizes[0] / sizes[1], sizes[1] / sizes[2], rel_tol=1e-3):
        return ""
    rows = []
    for name, label, form in QUANTITIES:
        values = [case.quantity(name) for _, case in runs]
        if name in LIMITED and all(math.isfinite(value) for value in values):
            limit = dt.grid_limit(sizes, values)
            rows.append("<tr>" + cell(label) + cell(" / ".join(form.format(value) for value in values)) +
                        cell("none" if limit.order is None else f"{limit.order:.2f}") +
                        cell(f"{form.format(limit.value)} ± {form.format(limit.uncertainty)}") + "</tr>")
    return table(["quantity", "at " + " / ".join(f"{size:g}" for size in sizes), "order", "limit"], rows) if rows else ""


def inference(study, tows):
    """The tow speed that the paper's one number stands for."""
    formula = dt.tow_speed_for(dt.PAPER_END_ERROR, 0.5, 30)
    text = (f"<p>The paper gives the tow speed in a figure that is not at hand. A straight cable of {dt.LENGTH:g} m has the paper's "
            f"{dt.PAPER_END_ERROR} m at its end in case 2 for a tow speed of V = <b>{formula:.3f} m/s</b>; the decks take {dt.SPEED} m/s.")
    sweep = study.sweep("speed")
    runs = [(case.value("tow_speed"), case.quantity("end_error_m")) for case in (sweep.finished if sweep else [])]
    if tows.get(0.5, 30):
        runs.append((dt.SPEED, tows.get(0.5, 30).quantity("end_error_m")))
    runs.sort()
    for (v0, e0), (v1, e1) in zip(runs, runs[1:]):
        if (e0 - dt.PAPER_END_ERROR) * (e1 - dt.PAPER_END_ERROR) <= 0:
            found = v0 + (v1 - v0) * (dt.PAPER_END_ERROR - e0) / (e1 - e0)
            text += (f" The runs themselves, {e0:.2f} m at {v0:g} m/s and {e1:.2f} m at {v1:g} m/s, have it at "
                     f"V = <b>{found:.3f} m/s</b>; the cable stretches and its mesh is finite.")
    return text + "</p>\n"


def held_section(sweep, figures):
    points = deep_tow_claims.held(sweep)
    if len(points) < 2:
        return ""
    draw.held(points, figures)
    for case in sweep.finished:
        if case.value("angle") == 60:
            draw.flow(case, "flow_held", "Flow past the line held at 60 degrees, Re 100: pressure jumps across it.", figures)
    words = ", ".join(f"{cd:.2f} at {angle:g} degrees" for angle, cd, _ in points)
    ratio = points[-1][1] / points[0][1]
    steps = [(b[1] - a[1], a[0], b[0]) for a, b in zip(points, points[1:])]
    largest = max(steps)
    return ("<h2>Where a six-fold growth is found: a conjecture</h2>\n<p>A line <i>held</i> at an angle to the current, at a Reynolds number of 100, has the drag "
            f"coefficients {words}: a growth by a factor of <b>{ratio:.1f}</b> from 0 to 90 degrees, largest from {largest[1]:g} to {largest[2]:g} degrees. "
            "That is the kind of growth that the paper reports. It is a conjecture that the paper's drag was of a cable that had not come into line with the relative flow, or at "
            "another Reynolds number; its text does not say. No towed case was tuned toward it.</p>\n")


def deep_tow_sections(study, figures):
    """Headings and tables; figures are saved on the way."""
    body, sweep = "", study.sweep("tow")
    tows = dt.Tows(sweep) if sweep else None
    if tows and tows.complete:
        rows = ["<tr>" + cell(sentence) + cell(finding) + cell(word, kind=word) + "</tr>"
                for sentence, finding, word in deep_tow_claims.claims(tows)]
        body += "<h2>The paper's claims</h2>\n" + table(["the paper", "these runs", "holds"], rows)
        fits = "; ".join("U = {:g} m/s: {:.3f} θ + {:.2f} m, R² = {:.4f}".format(
            u, *dt.straight_line_fit(tows.angles, tows.row(u, "total_error_m"))) for u in tows.currents)
        body += f"<p>Lines through the total error over θ in degrees: {fits}.</p>\n"
        body += "<h2>The tow speed</h2>\n" + inference(study, tows)
        body += deep_tow_forces.towed(tows, study, figures)
        if tows.get(0.5, 30):
            draw.cable_shape(tows.get(0.5, 30), figures)
        draw.total_error(tows, figures)
        draw.drag(tows, figures)
        draw.cables_in_current(tows, figures)
        if tows.get(0.5, 30):
            draw.mesh(tows.get(0.5, 30), figures)
            draw.flow(tows.get(0.5, 30), "flow", "Flow around the cable of case 2 at the end: speed, pressure, vorticity. The cable is a thin layer "
                      "of shear; the pressure has one value per side, and jumps where the cable turns the flow.", figures)
        draw.histories(tows, figures)
    elif sweep:
        body += "<p>The towed cases are not all there; the paper's claims need all of them.</p>\n"
    if (sweep := study.sweep("friction")) and sweep.finished:
        body += deep_tow_forces.friction(sweep, figures)
    if (sweep := study.sweep("held")) and sweep.finished:
        body += held_section(sweep, figures)
    return body


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "study.json").exists():
        sys.exit("study_report.py FOLDER: the folder of a study, with its study.json")
    study = Study(sys.argv[1])
    figures = Figures(study.folder / "report")
    states = [case.state for case in study.cases]
    total = sum(case.cpu for case in study.cases)
    body = (f"<p>{len(states)} cases of {html.escape(study.file)}: {states.count('finished')} finished, {states.count('failed')} failed, "
            f"{len(states) - states.count('finished') - states.count('failed')} not run; {total:.0f} s of CPU time.</p>\n")
    failed = [case for case in study.cases if case.state == "failed"]
    if failed:
        body += "<p><b>Failed:</b> " + "; ".join(html.escape(f"{c.sweep}/{c.name} ({c.title}): {c.reason}") for c in failed) + "</p>\n"
    if study.report == "deep-tow":
        body += deep_tow_sections(study, figures)
    body += "<h2>Cases</h2>\n"
    for sweep in study.sweeps:
        if study.report != "deep-tow":
            curves(sweep, figures)
        body += f"<h3>{html.escape(sweep.name)}</h3>\n<p>{html.escape(sweep.meaning)} Base deck: {html.escape(sweep.deck)}.</p>\n"
        body += case_rows(sweep) + limits(sweep)
    body += "<h2>Figures</h2>\n"
    for name, caption, image in figures.shown:
        body += f'<figure id="{name}"><img alt="{html.escape(name)}" src="{image}"><figcaption>{html.escape(caption)}</figcaption></figure>\n'
    page = figures.folder / "index.html"
    page.write_text(PAGE.format(title=html.escape(study.title or "A study"), body=body))
    print(f"Report: {page}")


if __name__ == "__main__":
    main()
