"""The page of a problem: its table, the orders that were observed, and a picture."""
import math

from chart import svg


def percent(error):
    return f"{100 * error:+.2f} %"


def order(coarse, fine):
    """Of two errors whose meshes differ by a factor of two; text."""
    if coarse == 0 or fine == 0:
        return "–"
    if coarse * fine < 0:
        return "changes sign"
    return f"{math.log2(coarse / fine):.2f}"


class Row:
    def __init__(self, variant, level, elements, values, ratio, seconds):
        self.variant, self.level, self.elements, self.values = variant, level, elements, values
        self.ratio, self.seconds = ratio, seconds

    def text(self):
        cells = [self.variant, str(self.level), f"{self.elements:,}"]
        for value in self.values:
            cells += [f"{value.measured:.4g}", f"{value.reference:.4g}", percent(value.error())]
        # Of a run that begins at rest without loads the ratio has no meaning.
        cells += [f"{self.ratio:.4f}" if 0.1 < self.ratio < 10 else "–", f"{self.seconds:.1f}"]
        return "| " + " | ".join(cells) + " |"


def by_variant(rows):
    found = {}
    for row in rows:
        found.setdefault(row.variant, []).append(row)
    return found


def table(rows, column):
    names = [v.name for v in rows[0].values]
    head = [column, "mesh", "elements"] + [c for n in names for c in (n, "reference", "error")] + ["energy ratio", "s"]
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + [row.text() for row in rows]) + "\n"


def orders(rows, column):
    """A line for each variant: the exponent of the error over the length of the edges, between meshes."""
    names = [v.name for v in rows[0].values]
    lines = [f"| {column} | " + " | ".join(names) + " |", "|---|" + "---:|" * len(names)]
    for variant, own in by_variant(rows).items():
        cells = [", ".join(order(a.values[i].error(), b.values[i].error()) for a, b in zip(own, own[1:]))
                 for i in range(len(names))]
        lines.append(f"| {variant} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def picture(rows):
    """Logarithm of the error of the first value over that of the number of elements; four curves at most."""
    curves = {}
    for variant, own in list(by_variant(rows).items())[:4]:
        points = [(math.log10(r.elements), math.log10(abs(r.values[0].error()))) for r in own if r.values[0].error()]
        if points:
            curves[variant] = points
    return svg(curves, "log10 of the number of elements", f"log10 of the error: {rows[0].values[0].name}") if curves else ""


def summary(rows):
    """The errors of the finest meshes."""
    parts = []
    for variant, own in by_variant(rows).items():
        parts.append(f"{variant}: " + ", ".join(f"{v.name} {percent(v.error())}" for v in own[-1].values))
    return "; ".join(parts)


def page(problem, rows, has_picture):
    text = f"""# {problem.title}

`data/benchmarks/{problem.name}.k` is the coarsest mesh; [how these pages are made](../solver-benchmarks.md).

Finest meshes: {summary(rows)}.

{problem.text}
{table(rows, problem.column)}"""
    if max(len(own) for own in by_variant(rows).values()) > 1:
        text += f"\nOrder of the error over the length of the edges, from mesh to mesh:\n\n{orders(rows, problem.column)}"
    if has_picture:
        text += f"\n![error over the number of elements]({problem.name}.svg)\n"
    return text + (f"\n{problem.cause}" if problem.cause else "")
