"""Curves as an SVG picture: shared by the scripts that draw results."""

import math

# Dashed lines, so that a curve beneath is visible.
STROKES = ('stroke="#1f4e9c"', 'stroke="#c0392b"', 'stroke="#2e8b57" stroke-dasharray="10 4"',
           'stroke="#8e44ad" stroke-dasharray="4 4"')

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 380, 70, 20, 20, 50


def round_step(span):
    """A step of 1, 2 or 5 times a power of ten that divides the span into four to ten."""
    power = 10 ** math.floor(math.log10(span / 4))
    return max((m * power for m in (1, 2, 5) if span / (m * power) >= 4), default=power)


class Axis:
    def __init__(self, values, start, end):
        low, high = min(values), max(values)
        high = high if high > low else low + 1.0  # a constant
        step = round_step(high - low)
        self.first, self.last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
        self.step, self.start, self.end = step, start, end

    def __call__(self, value):
        share = (value - self.first * self.step) / ((self.last - self.first) * self.step)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        return [(self(i * self.step), f"{i * self.step:g}") for i in range(self.first, self.last + 1)]


def svg(curves, x_label, y_label, bands=(), legend=(LEFT + 10, TOP + 12)):
    """curves: {label: points}; bands: (from y, to y, label) shaded; legend: its upper left corner."""
    points = [p for curve in curves.values() for p in curve]
    x = Axis([p[0] for p in points], LEFT, WIDTH - RIGHT)
    y = Axis([p[1] for p in points] + [v for b in bands for v in b[:2]], HEIGHT - BOTTOM, TOP)
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
           f'font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for low, high, label in bands:
        out.append(f'<rect x="{LEFT}" y="{y(high):.1f}" width="{right - LEFT}" height="{y(low) - y(high):.1f}" '
                   f'fill="#eeeecc"/>')
        out.append(f'<text x="{right - 6}" y="{y(high) + 14:.1f}" text-anchor="end" fill="#666">{label}</text>')
    for place, text in x.ticks():
        out.append(f'<path d="M{place:.1f} {TOP}V{bottom}" stroke="#ddd"/>')
        out.append(f'<text x="{place:.1f}" y="{bottom + 16}" text-anchor="middle">{text}</text>')
    for place, text in y.ticks():
        out.append(f'<path d="M{LEFT} {place:.1f}H{right}" stroke="#ddd"/>')
        out.append(f'<text x="{LEFT - 6}" y="{place + 4:.1f}" text-anchor="end">{text}</text>')
    out.append(f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{bottom - TOP}" fill="none" stroke="#333"/>')
    for i, (label, curve) in enumerate(curves.items()):
        path = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in curve)
        out.append(f'<polyline points="{path}" fill="none" {STROKES[i]} stroke-width="1.6"/>')
        left, line = legend[0], legend[1] + 17 * i
        out.append(f'<path d="M{left} {line}h22" {STROKES[i]} stroke-width="2"/>')
        out.append(f'<text x="{left + 28}" y="{line + 4}">{label}</text>')
    out.append(f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 12}" text-anchor="middle">{x_label}</text>')
    out.append(f'<text transform="translate(16 {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle">{y_label}'
               "</text>")
    return "\n".join(out + ["</svg>"]) + "\n"
