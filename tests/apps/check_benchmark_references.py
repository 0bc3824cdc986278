"""Compares closed forms that scripts/benchmark_decks gives as references with slow numerical solutions.

    check_benchmark_references.py ROOT

Exit code 1 if one differs.
"""

import math
import pathlib
import sys


def solved(matrix, right):
    """Gauss' elimination with pivots."""
    rows = [row[:] + [r] for row, r in zip(matrix, right)]
    count = len(rows)
    for i in range(count):
        best = max(range(i, count), key=lambda n: abs(rows[n][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for below in rows[i + 1:]:
            if factor := below[i] / rows[i][i]:
                for k in range(i, count + 1):
                    below[k] -= factor * rows[i][k]
    found = [0.0] * count
    for i in reversed(range(count)):
        found[i] = (rows[i][count] - sum(rows[i][k] * found[k] for k in range(i + 1, count))) / rows[i][i]
    return found


class Strip:
    """Half of the strip by finite differences: the minimum of E I / 2 ∫ w''² + E A / 2 L (δ - ½ ∫ w'²)² with w ≤ h."""

    def __init__(self, strip, count):
        self.strip, self.count = strip, count
        step = strip.LENGTH / 2 / count
        bend, self.stretch = [[[0.0] * count for _ in range(count)] for _ in range(2)]

        def add(matrix, weight, terms):
            # w = 0 at the hinge, odd beyond it, even beyond the middle.
            row = [0.0] * count
            for place, factor in terms:
                sign, place = (-1, -place) if place < 0 else (1, 2 * count - place if place > count else place)
                if place > 0:
                    row[place - 1] += sign * factor
            for i, a in enumerate(row):
                for k, b in enumerate(row):
                    matrix[i][k] += weight * a * b

        for i in range(count + 1):
            weight = 2 * strip.STIFFNESS * step * (0.5 if i in (0, count) else 1.0)
            add(bend, weight, [(i - 1, step ** -2), (i, -2 * step ** -2), (i + 1, step ** -2)])
        for i in range(count):
            add(self.stretch, 2 * step, [(i, -1 / step), (i + 1, 1 / step)])
        self.bend = bend

    def load(self, w, shortening):
        slopes = [sum(a * b for a, b in zip(row, w)) for row in self.stretch]
        length = sum(a * b for a, b in zip(slopes, w))
        return self.strip.THICKNESS / self.strip.LENGTH * (shortening - length / 2), slopes

    def gradient(self, w, shortening):
        load, slopes = self.load(w, shortening)
        return [sum(a * b for a, b in zip(row, w)) - load * s for row, s in zip(self.bend, slopes)]

    def settle(self, w, free, shortening):
        """Newton's method for the points that are free."""
        axial = self.strip.THICKNESS / self.strip.LENGTH
        for _ in range(60):
            load, slopes = self.load(w, shortening)
            residual = self.gradient(w, shortening)
            tangent = [[self.bend[i][k] - load * self.stretch[i][k] + axial * slopes[i] * slopes[k] for k in free] for i in free]
            step = solved(tangent, [-residual[i] for i in free])
            for i, change in zip(free, step):
                w[i] += change
            if max(map(abs, step)) < 1e-14:
                return
        raise RuntimeError("Newton's method does not converge")

    def answer(self, shortening):
        """Load, force on the plate, place of the first point on it."""
        gap, held = self.strip.GAP, {self.count - 1}
        w = [gap * math.sin(math.pi / 2 * (i + 1) / self.count) for i in range(self.count)]
        for _ in range(200):
            for i in held:
                w[i] = gap
            self.settle(w, [i for i in range(self.count) if i not in held], shortening)
            residual = self.gradient(w, shortening)
            beyond = {i for i in range(self.count) if i not in held and w[i] > gap * (1 + 1e-9)}
            pulled = {i for i in held if residual[i] > 1e-9 * max(map(abs, residual))}
            if not beyond and not pulled:
                break
            # One at a time, the one nearest the end of the line.
            held = held | {max(beyond)} if beyond else held - {min(pulled)}
        else:
            raise RuntimeError("the points in contact do not settle")
        first = self.strip.LENGTH / 2 * (min(held) + 1) / self.count
        return self.load(w, shortening)[0], -sum(residual[i] for i in held), first


def check_strip(strip):
    """Finite differences of order 2, extrapolated from two meshes."""
    cases = [("point", strip.POINT, *strip.point_contact(strip.POINT)),
             ("line", strip.LINE, *strip.line_contact(strip.LINE)[:2])]
    for name, load, shortening, push in cases:
        coarse, fine = (Strip(strip, count).answer(shortening) for count in (20, 40))
        for what, c, f, closed in zip(("load", "force on the plate"), coarse, fine, (load * strip.EULER, push)):
            extrapolated = (4 * f - c) / 3
            print(f"strip, {name} contact, {what}: {extrapolated / closed - 1:+.2e} from the closed form, "
                  f"{c / closed - 1:+.2e} and {f / closed - 1:+.2e} before extrapolation")
            if abs(extrapolated / closed - 1) > 3e-4:
                yield f"strip, {name} contact: {what} is {closed}, by finite differences {extrapolated}"
        first = strip.LENGTH / 2 if name == "point" else (strip.LENGTH - strip.line_contact(load)[2]) / 2
        if abs(fine[2] - first) > 1e-9:
            yield f"strip, {name} contact begins at {first}, by finite differences at {fine[2]}"


def main():
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "scripts"))
    from benchmark_decks import strip
    problems = list(check_strip(strip))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
