"""Tables of an HTML page."""
import html
import math


def cell(value, form=None, kind=""):
    if form is not None:
        return f'<td class="n">{form.format(value) if math.isfinite(value) else "–"}</td>'
    return f'<td{" class=" + chr(34) + kind + chr(34) if kind else ""}>{html.escape(str(value))}</td>'


def table(head, rows):
    head = "".join(f"<th>{html.escape(name)}</th>" for name in head)
    return f"<table><tr>{head}</tr>\n" + "\n".join(rows) + "</table>\n"
