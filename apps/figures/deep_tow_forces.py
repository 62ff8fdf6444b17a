"""What the deep-tow study says about forces: of the towed cables and of an aligned line, on three meshes each."""
import matplotlib.pyplot as plt
import numpy as np

import deep_tow as dt
from figure_style import COLOURS, style
from page_table import cell, table

FORCE, LINE_FORCE = "tow_force_n_per_m", "line_force_along_n_per_m"

PER_METRE = ("<p><b>What the forces are.</b> In two dimensions the cable is a curtain of infinite depth, and its forces are newtons per metre "
             "of that depth, with an eddy viscosity that stands for what a mesh of this size cannot resolve. They are not the newtons "
             "on a streamer, and no factor turns them into those. The positions do not depend on how the drag is modelled.</p>")

FORMULAS = ("<p>Plate friction: F = C ρ W² L / 2 with C = 2 (1.328 Re<sup>-1/2</sup> + 2.668 Re<sup>-7/8</sup>), Re = W L / ν. Drag law: "
            "T = ρ C<sub>t</sub> π D W² L / 2 of a neutrally buoyant streamer, ρ = 1025 kg/m³, C<sub>t</sub> = 0.01, D = 6 cm.</p>\n")

# What is charged for a value that was changed once, on one mesh: 1.25 times the error that the difference stands for. A halved step of
# a scheme of first order leaves half of the error, a box of four times the size a quarter (blockage goes with one over the width).
CHARGES = {"step": 1.25 * 2, "box": 1.25 * 4 / 3}

LIMITS = ("<p>The limit at cell size 0 is extrapolated with the order that the three meshes show; where they show none in common, it is the finest "
          "value. The uncertainty is by the rules of Eça and Hoekstra (Lisbon 2006): 1.25 times what is extrapolated; an order above 2 is not believed, "
          "and 1.25 times the range of the three values is charged; three times the range where no order shows.</p>\n")

EFFECTS = ("<p>Step and box: the same tow on the coarsest mesh with half the step, and in a box of four times the size, against the run on that mesh. Charged "
           "are 2.5 times the one difference and 5/3 times the other, and added to the uncertainty of the mesh: they are biases, and may go one way.</p>\n")


def limit_cells(limit, bar):
    """Order, limit with its uncertainty, and whether that is within the bar."""
    off = limit.uncertainty / limit.value
    within = "yes" if off <= bar else "no"
    return (cell("none" if limit.order is None else f"{limit.order:.2f}") + cell(f"{limit.value:.0f} ± {limit.uncertainty:.0f}") +
            cell(f"± {100 * off:.1f} %") + cell(within, kind=within))


def scale(case):
    return case.value("mesh_scale") or 1.0


def family(case, coarser):
    """The runs of one tow on meshes of one family, coarse to fine; (mesh scales, forces)."""
    runs = sorted([*same_tow(case, coarser), case], key=scale, reverse=True)
    return [scale(c) for c in runs], [c.quantity(FORCE) for c in runs]


def same_tow(case, sweep):
    return [c for c in (sweep.finished if sweep else [])
            if (c.value("current"), c.value("tow_angle")) == (case.value("current"), case.value("tow_angle"))]


def effects(case, coarser, changed):
    """Relative change of the force per sweep of `changed`, each against the run on the same mesh; None where a run is missing."""
    found = {}
    for name, sweep in changed.items():
        pairs = [(c, base) for c in same_tow(case, sweep) for base in [*same_tow(case, coarser), case] if scale(base) == scale(c)]
        found[name] = pairs[0][0].quantity(FORCE) / pairs[0][1].quantity(FORCE) - 1 if pairs else None
    return found


def with_effects(limit, found):
    """The limit with what step and box are charged."""
    more = sum(CHARGES[name] * abs(change) for name, change in found.items() if change is not None)
    return limit._replace(uncertainty=limit.uncertainty + more * abs(limit.value))


def towed(tows, study, figures):
    """Forces of the towed cables; with runs on two coarser meshes also their limits, with runs at another step and in another box what these do."""
    coarser = study.sweep("coarser")
    changed = {name: study.sweep(name) for name in CHARGES if study.sweep(name)} if coarser else {}
    rows, families = [], {}
    for u in tows.currents:
        for a in tows.angles:
            case = tows.get(u, a)
            w = dt.relative_speed(u, a)
            plate = dt.plate_force(w)
            row = cell(u, "{:g}") + cell(a, "{:g}") + cell(w, "{:.3f}")
            if coarser:
                scales, forces = family(case, coarser)
                row += cell(" / ".join(f"{force:.0f}" for force in forces))
                found = effects(case, coarser, changed)
                if len(forces) == 3:
                    limit = with_effects(dt.grid_limit(scales, forces), found)
                    families[u, a] = scales, np.array(forces) / plate, limit, plate
                    row += limit_cells(limit, dt.force_bar(u))
                    best = limit.value
                else:
                    row += cell("a run is missing") + 3 * cell("–")
                    best = case.quantity(FORCE)
                for change in found.values():
                    row += cell("–" if change is None else f"{100 * change:+.2f} %")
            else:
                best = case.quantity(FORCE)
                row += cell(best, "{:.0f}")
            rows.append("<tr>" + row + cell(plate, "{:.0f}") + cell(best / plate, "{:.3f}") + cell(dt.drag_law_tension(w), "{:.0f}") + "</tr>")
    if families:
        draw_towed(tows, families, figures)
    found = ["force on three meshes (N per m of depth)", "order", "limit (N per m)", "uncertainty", "within 3 %, 5 % at 2 m/s",
             *(f"{name}: change" for name in changed)]
    head = ["U (m/s)", "θ (degrees)", "W (m/s)", *(found if coarser else ["tow force (N per m of depth)"]),
            "plate friction (N per m)", "ratio", "drag law, one streamer (N)"]
    return "<h2>Forces</h2>\n" + PER_METRE + table(head, rows) + (LIMITS if families else "") + (EFFECTS if changed else "") + FORMULAS


def draw_towed(tows, families, figures):
    """families: (mesh scales, forces over plate friction, limit, plate friction) per current and angle."""
    figure, panels = plt.subplots(1, len(tows.currents), figsize=(4.6 * len(tows.currents), 4.2), sharey=True, squeeze=False)
    for axes, u in zip(panels[0], tows.currents):
        for i, a in enumerate(tows.angles):
            if (u, a) not in families:
                continue
            scales, ratios, limit, plate = families[u, a]
            axes.plot(scales, ratios, **style(i), label=f"θ = {a:g} degrees")
            draw_limit(axes, limit, plate, i, 0.03 * (i - 1.5))
        axes.axhline(1, color="black", lw=1, ls=":")
        axes.set(xlabel="size of the cells / coarsest (-)", title=f"U = {u:g} m/s", xlim=(-0.09, 1.05))
    panels[0, 0].set_ylabel("tow force / boundary-layer formula (-)")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.02), ncol=4)
    figures.save(figure, "force_limits", "Force of the towed cables on three meshes, over the friction of an aligned plate at the relative speed. "
                 "Open symbols: the limit at cell size 0 with its uncertainty.")


def draw_limit(axes, limit, scale, index, at=0.0):
    axes.errorbar([at], [limit.value / scale], yerr=[limit.uncertainty / scale], color=COLOURS[index], marker=style(index)["marker"],
                  mfc="none", ms=9, capsize=4)


def friction(sweep, figures):
    """The aligned line: table and figure."""
    lines = []
    figure, axes = plt.subplots(figsize=(6.6, 4.6))
    for i, speed in enumerate(sorted({case.value("speed") for case in sweep.finished})):
        cases = sorted((c for c in sweep.finished if c.value("speed") == speed), key=lambda c: c.value("cells"))
        sizes, forces = [1 / case.value("cells") for case in cases], [case.quantity(LINE_FORCE) for case in cases]
        formula = dt.plate_force(speed)
        axes.plot(sizes, np.array(forces) / formula, **style(i), label=f"W = {speed:g} m/s")
        row = cell(speed, "{:g}") + cell(" / ".join(f"{case.value('cells'):.3g}" for case in cases)) + cell(" / ".join(f"{f:.0f}" for f in forces))
        if len(cases) == 3:
            limit = dt.grid_limit(sizes, forces)
            draw_limit(axes, limit, formula, i)
            row += limit_cells(limit, dt.force_bar(speed - dt.SPEED))
        else:
            limit = None
            row += cell("a run is missing") + 3 * cell("–")
        off = (limit.value if limit else forces[-1]) / formula - 1
        lines.append("<tr>" + row + cell(formula, "{:.0f}") + cell(f"{100 * off:+.1f} %") + "</tr>")
    axes.axhline(1, color="black", lw=1, ls=":")
    axes.set(xlabel="size of the cells on the line / thickness of the boundary layer (-)",
             ylabel="friction / boundary-layer formula (-)", xlim=(-0.01, None))
    axes.legend()
    figures.save(figure, "friction", "Friction of a line along the flow on three meshes, over the boundary-layer formula. Open symbols with bars: "
                 "the limit at cell size 0 with its uncertainty.")
    return ("<h2>Friction of the aligned line, converged</h2>\n<p>A freely towed cable feels friction at the relative speed W. Its force has a singularity "
            "at the leading edge; meshes are finer at the ends.</p>\n" +
            table(["W (m/s)", "cells per layer", "forces (N/m)", "order", "limit (N/m)", "uncertainty", "within 3 %, 5 % at 2.2 m/s", "formula (N/m)",
                   "off"], lines) + LIMITS)
