"""The figures of the deep-tow study; the paper's numbers are in the names."""
import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

import deep_tow as dt
from figure_style import COLOURS, line_style, style

FORCE = "tow_force_n_per_m"


def arrow(axes, start, vector, colour, text, offset=(0, 0)):
    start, vector = np.asarray(start, float), np.asarray(vector, float)
    axes.annotate("", xy=start + vector, xytext=start,
                  arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2, "mutation_scale": 16})
    axes.text(*(start + 0.5 * vector + np.asarray(offset)), text, color=colour, ha="center", va="center",
              bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5})


def cable_shape(case, figures):
    """The paper's figure 4: seen from the tug, with the tow axis upward."""
    angle = math.radians(case.value("tow_angle"))
    along = np.array([math.sin(angle), math.cos(angle)])
    starboard = np.array([along[1], -along[0]])
    cable = case.cable() - case.cable()[0]
    seen = np.column_stack([cable @ starboard, cable @ along])
    current = np.array([-starboard[1], -along[1]])
    figure, axes = plt.subplots(figsize=(5.6, 6.4))
    axes.axvline(0, color="#666666", lw=1, ls=(0, (6, 3)), label="tow axis")
    axes.plot(*np.array([[0, 0], 450 * current]).T, ":", color="black", lw=1.6, label="direction of the current")
    axes.plot(*seen.T, color=COLOURS[1], lw=2.6, label="cable", solid_capstyle="round")
    axes.plot(0, 0, "o", color=COLOURS[1], ms=9, label="tow point")
    arrow(axes, (0, 25), (0, 85), COLOURS[1], "tow", (38, 0))
    arrow(axes, -110 * current + [-60, 0], 90 * current, COLOURS[0], "current", (58, 12))
    error = case.quantity("end_error_m")
    axes.annotate("", xy=(0, seen[-1, 1]), xytext=seen[-1], arrowprops={"arrowstyle": "<->", "color": "black", "lw": 1.2})
    axes.text(12, seen[-1, 1] - 14, f"end error {error:.1f} m", ha="left", va="top")
    axes.set(xlabel="distance from the tow axis, to starboard (m)", ylabel="distance along the tow axis (m)", aspect="equal",
             xlim=(-230, 260), ylim=(-450, 140))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.11), ncol=2)
    figures.save(figure, "fig4_cable_shape", f"Case 2 at the end of the tow, seen from the tug (the paper's figure 4). The current comes "
                 f"30 degrees off the bow; the cable is straight and ends {error:.1f} m off the tow axis; the paper says "
                 f"{dt.PAPER_END_ERROR} m.")


def total_error(tows, figures):
    """The paper's figure 5, with the straight cable's exact curve."""
    figure, axes = plt.subplots(figsize=(6.6, 4.6))
    angles = np.linspace(0, 90, 181)
    for i, current in enumerate(tows.currents):
        length = np.mean(tows.row(current, "cable_length_m"))
        exact = [dt.straight_end_error(current, a, length=length) / 2 for a in angles]
        axes.plot(angles, exact, color=COLOURS[i], lw=1.2, ls=line_style(i)["linestyle"])
        axes.plot(tows.angles, tows.row(current, "total_error_m"), **{**style(i), "linestyle": "none", "markersize": 8},
                  label=f"U = {current:g} m/s")
    axes.plot([], [], color="black", lw=1.2, label="straight cable, exact")
    axes.set(xlabel="angle θ between tow and current (degrees)", ylabel="total positioning error (m)", xticks=tows.angles,
             ylim=(0, None))
    axes.legend()
    fits = ", ".join(f"{dt.straight_line_fit(tows.angles, tows.row(u, 'total_error_m'))[2]:.3f}" for u in tows.currents)
    figures.save(figure, "fig5_total_error", f"Total positioning error, the mean over the cable's nodes (the paper's figure 5). Lines: half "
                 f"the end error of a straight cable along the relative flow. R² of a straight line through each set: {fits}.")


def drag(tows, figures):
    """The paper's figure 6, with its claim."""
    base = tows.get(0.5, 30)
    if base is None:
        return
    figure, axes = plt.subplots(figsize=(6.6, 5.0))
    for i, current in enumerate(tows.currents):
        force = tows.row(current, FORCE) / base.quantity(FORCE)
        friction = [dt.plate_force(dt.relative_speed(current, a)) / base.quantity(FORCE) for a in np.linspace(0, 90, 91)]
        axes.plot(np.linspace(0, 90, 91), friction, color=COLOURS[i], lw=1, ls=":")
        axes.plot(tows.angles, force, **style(i), label=f"U = {current:g} m/s")
        axes.plot([90], [6 * force[0]], marker=style(i)["marker"], color=COLOURS[i], ms=11, mfc="none", mew=1.8, ls="none")
        axes.annotate("", xy=(90, 6 * force[0] * 0.93), xytext=(90, force[0] * 1.1),
                      arrowprops={"arrowstyle": "->", "color": COLOURS[i], "lw": 0.8, "ls": (0, (2, 3))})
    axes.plot([], [], "o", color="black", mfc="none", ms=11, mew=1.8, label="the paper's claim: 6 times 0 degrees")
    axes.plot([], [], ":", color="black", lw=1, label="boundary-layer friction")
    axes.set(xlabel="angle θ between tow and current (degrees)", ylabel="tow-point drag / that of case 2 (-)", yscale="log",
             xticks=tows.angles, xlim=(-4, 97))
    axes.set_yticks([0.5, 1, 2, 5, 10, 20, 50], ["0.5", "1", "2", "5", "10", "20", "50"])
    axes.legend(loc="upper left", fontsize=9, ncol=2)
    axes.set_ylim(0.5, 150)
    figures.save(figure, "fig6_drag", "Drag at the tow point over that of case 2 (the paper's figure 6), on a logarithmic scale. Open "
                 "symbols: where the force at 90 degrees would be if it were six times that at 0. Dotted: friction of an aligned plate.")


def cables_in_current(tows, figures):
    """The paper's figure 7."""
    figure, axes = plt.subplots(figsize=(6.2, 6.0))
    current = tows.currents[0]
    for i, angle in enumerate(tows.angles):
        cable = tows.get(current, angle).cable()
        axes.plot(*(cable - cable[0]).T, **line_style(i), label=f"case {i + 1}: θ = {angle:g} degrees")
    axes.plot(0, 0, "o", color="black", ms=7)
    arrow(axes, (70, 75), (0, -60), COLOURS[0], "current", (48, 0))
    axes.set(xlabel="across the current (m)", ylabel="along the current (m)", aspect="equal", xlim=(-250, 180),
             ylim=(-450, 95))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.11), ncol=2)
    figures.save(figure, "fig7_cables", f"The cables of cases 1-4 (U = {current:g} m/s) in the current's frame, from one tow point (the "
                 "paper's figure 7): the more the tow crosses the current, the larger the cable's angle to it.")


def mesh(case, figures):
    """The paper's figure 2."""
    grid = case.grid("flow")
    cable = case.cable()
    moved = grid.points
    start = moved - grid.fields["displacement"][:, :2]
    nearest = [int(np.argmin(np.linalg.norm(moved - node, axis=1))) for node in cable]
    figure, both = plt.subplots(1, 2, figsize=(10, 5.6))
    for axes, points, title in zip(both, (start, moved), ("(a) before", f"(b) after {grid.time:.0f} s")):
        line = points[nearest]
        centre = line.mean(axis=0)
        near = np.all(np.abs(points[grid.cells].mean(axis=1) - centre) < 420, axis=1)
        edges = points[np.vstack([grid.cells[near][:, pair] for pair in ([0, 1], [1, 2], [2, 0])])]
        axes.add_collection(LineCollection(edges, colors="#4477aa", linewidths=0.5))
        axes.plot(*line.T, color=COLOURS[1], lw=2.2, label="cable")
        axes.plot(*line[0], "o", color=COLOURS[1], ms=7)
        axes.set(xlim=centre[0] + np.array([-280, 280]), ylim=centre[1] + np.array([-280, 280]), aspect="equal", title=title,
                 xlabel="x (m)", ylabel="y (m)")
        axes.grid(False)
        axes.legend(loc="upper right")
    quality = case.quantity("mesh_quality_min")
    figures.save(figure, "fig2_mesh", f"The mesh around the cable of case 2 before and after the tow (the paper's figure 2): the same cells, "
                 f"moved with the cable. The worst cell of the whole run has a quality of {quality:.2f} (1 is equilateral).", "png")


def vorticity(grid, velocity):
    """Of each triangle, 1/s, from its linear velocity."""
    p = grid.points[grid.cells]
    v = velocity[grid.cells]
    a, b = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    va, vb = v[:, 1] - v[:, 0], v[:, 2] - v[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    dv_dx = (va[:, 1] * b[:, 1] - vb[:, 1] * a[:, 1]) / area
    du_dy = (vb[:, 0] * a[:, 0] - va[:, 0] * b[:, 0]) / area
    return dv_dx - du_dy


def flow(case, name, title, figures):
    """Speed, pressure with its jump, vorticity around the cable."""
    grid = case.grid("flow")
    velocity = grid.fields["velocity"][:, :2]
    pressure = grid.fields["pressure"].ravel()
    if case.folder.joinpath("cable.csv").exists():
        cable = case.cable()
    else:  # a line that is held: from its angle
        angle = math.radians(case.value("angle"))
        cable = np.array([[0, 0], dt.LENGTH * np.array([math.sin(angle), -math.cos(angle)])])
    centre = cable.mean(axis=0) + [0, -40]
    half = 330
    near = np.all(np.abs(grid.points - centre) < 1.3 * half, axis=1)
    turning = vorticity(grid, velocity)
    near_cells = near[grid.cells].all(axis=1)
    figure, panels = plt.subplots(1, 3, figsize=(16.5, 5.2), sharey=True)
    speed = np.linalg.norm(velocity, axis=1)
    bound_p = np.percentile(np.abs(pressure[near] - np.median(pressure[near])), 99)
    bound_w = np.percentile(np.abs(turning[near_cells]), 99)
    middle = np.median(pressure[near])
    for axes, values, options, label in (
            (panels[0], speed, {"cmap": "viridis", "vmin": 0, "vmax": speed[near].max(), "shading": "gouraud"}, "flow speed (m/s)"),
            (panels[1], pressure - middle, {"cmap": "RdBu_r", "vmin": -bound_p, "vmax": bound_p, "shading": "gouraud"},
             "pressure less its median (Pa)"),
            (panels[2], turning, {"cmap": "PuOr", "vmin": -bound_w, "vmax": bound_w, "shading": "flat"}, "vorticity (1/s)")):
        image = axes.tripcolor(*grid.points.T, grid.cells, values, rasterized=True, **options)
        figure.colorbar(image, ax=axes, label=label, shrink=0.85)
        axes.plot(*cable.T, color="black", lw=1.6)
        axes.plot(*cable[0], "o", color="black", ms=5)
        axes.set(xlim=centre[0] + np.array([-half, half]), ylim=centre[1] + np.array([-half, half]), aspect="equal",
                 xlabel="x (m)")
        axes.grid(False)
    panels[0].set_ylabel("y (m)")
    figures.save(figure, name, title, "png")


def histories(tows, figures):
    """End error and tow force over time, a column per current."""
    figure, panels = plt.subplots(2, len(tows.currents), figsize=(4.6 * len(tows.currents), 6.4), sharex=True, squeeze=False)
    for column, current in enumerate(tows.currents):
        for i, angle in enumerate(tows.angles):
            table = tows.get(current, angle).table("history.csv")
            panels[0, column].plot(table["t_s"], table["end_error_m"], **line_style(i), label=f"θ = {angle:g} degrees")
            panels[1, column].plot(table["t_s"], table["tow_force_n_per_m"] / 1000, **line_style(i))
        late = max(tows.get(current, a).table("history.csv")["tow_force_n_per_m"][-20:].max() for a in tows.angles) / 1000
        panels[1, column].set_ylim(0, 2.2 * late)
        panels[0, column].set_title(f"U = {current:g} m/s")
        panels[1, column].set_xlabel("time (s)")
    panels[0, 0].set_ylabel("end error (m)")
    panels[1, 0].set_ylabel("tow force (kN per m of depth)")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.03), ncol=4)
    figures.save(figure, "histories", "End error and force at the tow point over time. The cable is held for 300 s; then its top is ramped to "
                 "the tow speed within 100 s. The force is cut off above: at the start of the tow it peaks.")


def held(points, figures):
    figure, axes = plt.subplots(figsize=(5.6, 4.2))
    angle, drag_coefficient, spread = np.array(points).T
    axes.errorbar(angle, drag_coefficient, yerr=spread, capsize=4, **style(0))
    axes.set(xlabel="angle of the held line to the current (degrees)", ylabel="drag / (ρ U² L / 2) (-)", xticks=angle, ylim=(0, None))
    figures.save(figure, "held", "A line held at an angle to the current at Re 100: a conjecture about the paper's figure 6, and no towed cable. Means "
                 "over the second half of each run; bars: standard deviation.")
