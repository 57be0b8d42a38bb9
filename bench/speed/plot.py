"""A log-log plot as SVG."""
import math

COLOURS = ["#1b6ca8", "#7fb3d9", "#c0392b", "#e67e22", "#27ae60", "#8e44ad", "#7f8c8d", "#2c3e50", "#d4ac0d", "#16a085"]
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 720, 420, 70, 210, 40, 50


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def log_log(title, lines):
    """lines: name -> [(points, seconds), ...]. Dotted: growth in proportion to n log n."""
    points = [p for line in lines.values() for p in line]
    if not points:
        return '<svg xmlns="http://www.w3.org/2000/svg"/>\n'
    (x0, x1), (y0, y1) = decades([p[0] for p in points]), decades([p[1] for p in points])
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)

    def place(n, s):
        x = LEFT + (math.log10(n) - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT)
        y = HEIGHT - BOTTOM - (math.log10(s) - y0) / (y1 - y0) * (HEIGHT - TOP - BOTTOM)
        return f"{x:.1f}", f"{y:.1f}"

    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           f'<text x="{LEFT}" y="22" font-size="15">{title}</text>']
    for d in range(x0, x1 + 1):
        x, y = place(10**d, 10**y0)
        svg += [f'<path d="M{x} {TOP}V{y}" stroke="#ddd"/>',
                f'<text x="{x}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{10**d:,}</text>']
    for d in range(y0, y1 + 1):
        x, y = place(10**x0, 10.0**d)
        svg += [f'<path d="M{x} {y}H{WIDTH - RIGHT}" stroke="#ddd"/>',
                f'<text x="{LEFT - 8}" y="{y}" text-anchor="end" dy="4">{10.0**d:g} s</text>']
    n0, n1 = 10.0**x0, 10.0**x1
    s1 = 10.0**y1
    svg.append('<path d="M{} {}L{} {}" stroke="#999" stroke-dasharray="2 4"/>'.format(
        *place(n0, max(10.0**y0, s1 * n0 * math.log(n0) / (n1 * math.log(n1)))), *place(n1, s1)))
    for i, (name, line) in enumerate(sorted(lines.items())):
        colour, line = COLOURS[i % len(COLOURS)], sorted(line)
        way = "L".join(" ".join(place(*p)) for p in line)
        svg.append(f'<path d="M{way}" fill="none" stroke="{colour}" stroke-width="2"/>')
        svg += ['<circle cx="{}" cy="{}" r="3" fill="{}"/>'.format(*place(*p), colour) for p in line]
        y = TOP + 18 * i
        svg += [f'<path d="M{WIDTH - RIGHT + 12} {y}h18" stroke="{colour}" stroke-width="2"/>',
                f'<text x="{WIDTH - RIGHT + 36}" y="{y + 4}">{name}</text>']
    return "\n".join(svg + ["</svg>"]) + "\n"
