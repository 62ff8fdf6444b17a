"""The paper's sentences on its results, what the runs say to each, and a verdict that follows from the numbers."""
import numpy as np

import deep_tow as dt

FORCE, END, TOTAL, ARC = "tow_force_n_per_m", "end_error_m", "total_error_m", "total_error_arc_m"


def listed(values, form="{:.2f}"):
    return " / ".join(form.format(value) for value in values)


def verdict(holds):
    return "yes" if holds else "no"


def shape(tows):
    case = tows.get(0.5, 30)
    if case is None:
        return []
    bow, length = dt.straightness(case.cable()), case.quantity("cable_length_m")
    flap = case.quantity("end_error_change_last_quarter_m")
    return [
        ("Case 2: the cable is approximately linear in the ocean current.",
         f"No node lies further than {bow:.2f} m from the chord of {length:.1f} m.", verdict(bow < 0.01 * length)),
        ("The end of the cable is slightly flapped by the ocean current.",
         f"In the last quarter of case 2 the end error changes by {flap:.3f} m; "
         f"{'the tail flaps' if flap > 1 else 'the tail is at rest'}.",
         verdict(flap > 1.0)),
        ("This behaviour causes the increase in the positioning error.",
         f"The end error is that of a straight cable to {abs(case.quantity(END) - case.quantity('end_error_exact_m')):.2f} m; flapping adds "
         "nothing to it. It comes from the direction of the relative flow.", verdict(flap > 1)),
        ("Case 2: the positioning error at the end of the cable is 154.7 m.",
         f"{case.quantity(END):.2f} m at a tow speed of {dt.SPEED} m/s; a straight cable of the stretched length has "
         f"{case.quantity('end_error_exact_m'):.2f} m. The tow speed stands in a figure that is not at hand: see below.",
         verdict(abs(case.quantity(END) - dt.PAPER_END_ERROR) < 1.5)),
        ("The positioning error in a practical marine area can be severe, considering that the cable length is 420 m.",
         f"It is {100 * case.quantity(END) / length:.0f} % of the cable's length in case 2, and at most "
         f"{100 * max(c.quantity(END) for c in tows.cases.values()) / length:.0f} % in the twelve cases.",
         verdict(case.quantity(END) > 0.1 * length)),
    ]


def errors(tows):
    fits = [dt.straight_line_fit(tows.angles, tows.row(u, TOTAL))[2] for u in tows.currents]
    by_angle = max(np.ptp(tows.row(u, TOTAL)) for u in tows.currents)
    by_current = max(np.ptp([tows.get(u, a).quantity(TOTAL) for u in tows.currents]) for a in tows.angles)
    slow = tows.row(tows.currents[0], TOTAL)
    currents = listed(tows.currents, "{:g}")
    return [
        ("The total positioning error increases approximately linearly with the angle in each velocity.",
         f"R² of a line: {listed(fits, '{:.3f}')} for U = {currents} m/s; the curve flattens toward 90 degrees.",
         "about" if min(fits) > 0.9 else "no"),
        ("The velocity of the ocean current has less effect than the angle.",
         f"Largest change of the total error with U at one angle: {by_current:.1f} m; with the angle at one U: {by_angle:.1f} m.",
         verdict(by_current < by_angle)),
        ("The angle is important even if the speed of the ocean current is slow.",
         f"At U = {tows.currents[0]:g} m/s the total error grows from {slow[0]:.1f} to {slow[-1]:.1f} m.",
         verdict(slow[-1] - slow[0] > 100)),
    ]


def forces(tows):
    currents = listed(tows.currents, "{:g}")
    rows = {u: tows.row(u, FORCE) for u in tows.currents}
    grows_with_current = all(rows[a][i] < rows[b][i] for a, b in zip(tows.currents, tows.currents[1:])
                             for i in range(len(tows.angles)))
    speeds = [dt.relative_speed(u, a) for u in tows.currents for a in tows.angles]
    exponent = np.polyfit(np.log(speeds), np.log(np.concatenate([rows[u] for u in tows.currents])), 1)[0]
    falls = all((np.diff(rows[u]) < 0).all() for u in tows.currents)
    grows = all((np.diff(rows[u]) > 0).all() for u in tows.currents)
    ratios = [rows[u][-1] / rows[u][0] for u in tows.currents]
    formula = [dt.plate_force(dt.relative_speed(u, tows.angles[-1])) / dt.plate_force(dt.relative_speed(u, tows.angles[0]))
               for u in tows.currents]
    largest = [int(np.argmax(np.abs(np.diff(rows[u])))) for u in tows.currents]
    steps = " / ".join(f"{tows.angles[i]:g} to {tows.angles[i + 1]:g}" for i in largest)
    return [
        ("The drag force at the towing point increases with the velocity of the ocean current.",
         f"It grows at every angle, as the relative speed to the power {exponent:.2f}.", verdict(grows_with_current)),
        ("The drag force increases with the angle.",
         "It falls with the angle at every U: the cable lies along the relative flow and feels friction alone, and the relative "
         "speed falls with the angle." if falls else f"Forces over the angles: {', '.join(listed(rows[u], '{:.0f}') for u in tows.currents)}.",
         verdict(grows)),
        ("In each velocity the drag force at 90 degrees is about six times larger than at 0 degrees.",
         f"F(90)/F(0) = {listed(ratios)} for U = {currents} m/s; boundary-layer friction gives {listed(formula)}. "
         "A six-fold growth does not hold for a freely towed cable.", verdict(all(4 < ratio < 8 for ratio in ratios))),
        ("The increment is step-like, and largest from 30 to 60 degrees.",
         f"The largest change, a fall, is from {steps} degrees for U = {currents} m/s.",
         verdict(grows and all(tows.angles[i] == 30 for i in largest))),
    ]


def frame(tows):
    u = tows.currents[0]
    angles = tows.row(u, "cable_angle_deg")
    bow = max(dt.straightness(tows.get(u, a).cable()) for a in tows.angles)
    forces = tows.row(u, FORCE)
    return [
        ("Cases 1-4: the angle of the cable against the current direction increases with the towing angle.",
         f"{listed(np.abs(angles), '{:.1f}')} degrees.", verdict((np.diff(np.abs(angles)) > 0).all())),
        ("This will lead to an increment of the acting force, due to the curvature of the cable.",
         f"The cable is straight to {bow:.2f} m in all of cases 1-4, and the force falls.",
         verdict(bow > 4 and (np.diff(forces) > 0).all())),
        ("The drag force as well as the positioning is influenced by the angle.",
         f"Both are: from 0 to 90 degrees at U = {u:g} m/s the force changes by {100 * (forces[-1] / forces[0] - 1):+.0f} %, the end error "
         f"by {np.ptp(tows.row(u, END)):.0f} m.", verdict(abs(forces[-1] / forces[0] - 1) > 0.05 and np.ptp(tows.row(u, END)) > 10)),
    ]


def conclusions(tows, on_errors, on_forces):
    ends = [tows.get(u, a).quantity(END) - tows.get(u, a).quantity("end_error_exact_m")
            for u in tows.currents for a in tows.angles]
    rows = [tows.row(u, TOTAL) for u in tows.currents]
    growth = min(r[-1] - r[0] for r in rows)
    fall = [1 - tows.row(u, FORCE)[-1] / tows.row(u, FORCE)[0] for u in tows.currents]
    rise = [tows.get(tows.currents[-1], a).quantity(FORCE) / tows.get(tows.currents[0], a).quantity(FORCE) for a in tows.angles]
    (_, linear, about), (_, current, less), _ = on_errors
    *_, (_, step, stepped) = on_forces
    return [
        ("Conclusion: the simulation reproduces the cable feathering phenomenon.",
         f"The cable feathers to within {max(map(abs, ends)):.2f} m of the exact straight cable at its end, in all of "
         f"{len(ends)} cases.", verdict(max(map(abs, ends)) < 1.5)),
        ("Conclusion: the positioning error is severely influenced by the angle between the axis of the tow and the current.",
         f"From 0 to 90 degrees the total error grows from {listed([r[0] for r in rows], '{:.1f}')} to "
         f"{listed([r[-1] for r in rows], '{:.1f}')} m.", verdict(growth > 100)),
        ("Conclusion: the velocity of the ocean current has less influence on it than the angle.", current, less),
        ("Conclusion: the total positioning error increases approximately linearly with the angle.", linear, about),
        ("Conclusion: the drag force at the towing point is also influenced by the angle.",
         f"It falls by {listed([100 * f for f in fall], '{:.0f}')} % from 0 to 90 degrees.", verdict(min(map(abs, fall)) > 0.05)),
        ("Conclusion: the trend of the drag force is step-like, and largest from 30 to 60 degrees.", step, stepped),
        ("Abstract: drag force and positioning error depend strongly not only on the current's speed but also on the angle.",
         f"The position does, on the angle. The force depends on the current, {min(rise):.1f} to {max(rise):.1f}-fold from U = {tows.currents[0]:g} "
         f"to {tows.currents[-1]:g} m/s, and much less on the angle.", "about" if growth > 100 else "no"),
    ]


def claims(tows):
    """(sentence, finding, verdict) of each."""
    if not tows.complete:
        return []
    on_errors, on_forces = errors(tows), forces(tows)
    return [*shape(tows), *on_errors, *on_forces, *frame(tows), *conclusions(tows, on_errors, on_forces)]


def held(sweep):
    """(angle, coefficient of the drag along the current, standard deviation): means over the second half of each run."""
    result = []
    for case in sweep.finished:
        history = case.table("history.csv")
        late = history["t_s"] >= 0.5 * history["t_s"][-1]
        load = 0.5 * dt.DENSITY * dt.HELD_SPEED ** 2 * dt.LENGTH
        force = history["line_force_along_n_per_m"][late] / load
        result.append((case.value("angle"), float(force.mean()), float(force.std())))
    return sorted(result)
