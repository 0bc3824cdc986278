"""Plots on logarithmic axes as SVG text."""

import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 430, 70, 180, 20, 50


class Axis:
    """Maps values to places, decade by decade; what lies below the first one is shown on it."""

    def __init__(self, low, high, start, end):
        self.low, self.high = math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9)
        self.high = max(self.high, self.low + 1)
        self.start, self.end = start, end

    def __call__(self, value):
        decade = math.log10(value) if value > 0 else self.low
        share = (min(max(decade, self.low), self.high) - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        step = math.ceil((self.high - self.low) / 10)
        return [(self(10.0 ** i), f"1e{i}" if i < -2 or i > 3 else f"{10.0 ** i:g}")
                for i in range(self.low, self.high + 1, step)]

    def minor(self):
        """Places between the decades, if there are few decades."""
        if self.high - self.low > 4:
            return []
        return [(self(m * 10.0 ** i), f"{m * 10.0 ** i:g}" if m in (2, 5) else "")
                for i in range(self.low, self.high) for m in range(2, 10)]


def svg(series, x_label, y_label, y_low, y_high, x_low=None, x_high=None):
    """series: list of dictionaries with label, colour, points [(x, y, text)], and optionally line (True: joined),
    dash (True: broken), hollow (True: empty markers), marker (False: none)."""
    places = [point for one in series for point in one["points"]]
    x = Axis(x_low or min(p[0] for p in places), x_high or max(p[0] for p in places), LEFT, WIDTH - RIGHT)
    y = Axis(y_low, y_high, HEIGHT - BOTTOM, TOP)
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
           f'font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for place, text in x.ticks() + x.minor():
        out.append(f'<path d="M{place:.1f} {TOP}V{bottom}" stroke="{"#ddd" if text else "#f0f0f0"}"/>')
        out.append(f'<text x="{place:.1f}" y="{bottom + 16}" text-anchor="middle">{text}</text>')
    for place, text in y.ticks():
        out.append(f'<path d="M{LEFT} {place:.1f}H{right}" stroke="#ddd"/>')
        out.append(f'<text x="{LEFT - 6}" y="{place + 4:.1f}" text-anchor="end">{text}</text>')
    out.append(f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{bottom - TOP}" fill="none" stroke="#333"/>')
    for i, one in enumerate(series):
        colour, level = one["colour"], TOP + 12 + 18 * i
        dash = ' stroke-dasharray="5 4"' if one.get("dash") else ""
        marker = f'r="4.5" stroke="{colour}" stroke-width="1.5" fill="{"white" if one.get("hollow") else colour}"'
        if one.get("line"):
            path = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b, _ in one["points"])
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.4"{dash}/>')
            out.append(f'<path d="M{right + 8} {level}h22" stroke="{colour}" stroke-width="1.4"{dash}/>')
        if one.get("marker", True):
            for a, b, text in one["points"]:
                out.append(f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" {marker}/>')
                out.append(f'<text x="{x(a) + 7:.1f}" y="{y(b) - 5:.1f}" fill="{colour}">{text}</text>')
            out.append(f'<circle cx="{right + 19}" cy="{level}" {marker}/>')
        out.append(f'<text x="{right + 36}" y="{level + 4}">{one["label"]}</text>')
    out.append(f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 12}" text-anchor="middle">{x_label}</text>')
    out.append(f'<text transform="translate(16 {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle">{y_label}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"
