"""docs/benchmarks.md and its plots, from what bench/speed/run measured."""
import math
import statistics

import plot

# For each stage what it must do at least, by any method: bytes that pass the memory a point, and the reason.
LIMITS = {
    "read": (40, "the file once, the points once"),
    "arrange": (3 * 24 + 6 * 16, "points read twice and written; 16-byte places written, put into cells and sorted there"),
    "neighbours": (24 + 40 * 4 * 2, "40 ids written, by way of the cache; about 400 distances are "
                                     "compared a point, up to sixteen at a time: 400 x 8 operations"),
    "boundary": (40 * 4 + 24 + 16, "40 ids read, 16 bytes written; 40 neighbours x 20 operations"),
    "survey": (40 * 4 + 2 * (80 + 24 + 6 * 4 + 2 * 44), "lists, frames, stars, two triangles a point, written and read "
                                                     "once; about 16 bisectors x 6 corners a cell"),
    "loops": (17 * 4 + 33 + 2 * 44 + 8, "the lists of 16 neighbours, a row of levels a star, the triangles once; the search "
                                        "itself is where triangles are in doubt"),
    "parameterize": (7 * 12 * 40, "some 40 products of a matrix of 7 entries a row"),
    "triangulate": (2 * 44 * 4, "triangles and their neighbours, a few times"),
    "refine": (7 * 12 * 80, "maps and flips again"),
    "measure": (2 * 44 + 24, "the mesh once"),
    "write": (24 + 2 * 26 + 16, "the result once, in the order of the input, and the file once"),
}


def seconds(value):
    return f"{value:.3f}" if value < 0.1 else f"{value:.2f}" if value < 10 else f"{value:.1f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


class Results:
    def __init__(self, data):
        self.data = data

    def find(self, work, program, cloud, points, threads=None):
        for row in self.data["runs"]:
            if (row["work"], row["program"], row["cloud"], row["points"]) == (work, program, cloud, points) and \
                    threads in (None, row["threads"]):
                return row
        return None

    def wall(self, *key):
        row = self.find(*key)
        return statistics.median(row["wall"]) if row else None

    def stage_seconds(self, work, cloud, points, threads):
        """Median seconds and greatest peak of each stage, in their order."""
        row = self.find(work, "rimline", cloud, points, threads)
        found = {}
        for run in row["stages"] if row else []:
            for stage in run:
                found.setdefault(stage["stage"], ([], []))
                found[stage["stage"]][0].append(stage["seconds"])
                found[stage["stage"]][1].append(stage["peak_bytes"])
        return {name: (statistics.median(s), max(p)) for name, (s, p) in found.items()}

    def bench(self, name, points, threads=None):
        """Median wall seconds of a Google benchmark."""
        for b in self.data["stages"]["benchmarks"]:
            parts = b["run_name"].split("/")
            numbers = [int(p.split(":")[-1]) for p in parts[1:] if p.split(":")[-1].isdigit()]
            if b.get("aggregate_name") == "median" and parts[0] == name and numbers[:1] == [points] and \
                    (threads is None or numbers[1:2] == [threads]):
                return b["real_time"] * {"ms": 1e-3, "us": 1e-6, "ns": 1e-9, "s": 1}[b["time_unit"]]
        return None

    def cloud_at(self, points):
        return "head_1m" if points == 1_000_000 and self.find("boundary", "rimline", "head_1m", points) else "sheet"

    def bandwidth(self):
        copy = self.bench("memory_copy", 1 << 28)
        return 2 * (1 << 28) / copy if copy else None


def ratio_row(what, aim, numerator, denominator, least=True):
    if numerator is None or denominator is None:
        return [what, aim, "not measured", ""]
    ratio = numerator / denominator
    bound = float(aim.split()[-1])
    digits = 3 if bound < 1.1 else 2
    return [what, aim, f"{ratio:.{digits}f}", "yes" if (ratio >= bound if least else ratio <= bound) else "**no**"]


def cloud_aims(r, cloud, points):
    """What is asked of one cloud; peers may not have run on it."""
    at = f"{cloud}, {points:,}"
    ours, mesh = (r.wall(work, "rimline", cloud, points, 2) for work in ("boundary", "reconstruct"))
    parts = r.stage_seconds("boundary", cloud, points, 2)
    whole = sum(s for s, _ in parts.values()) or None
    return [
        ratio_row(f"boundary, {at}: PCL / rimline", "at least 12",
                  r.wall("boundary", "PCL normals + boundary", cloud, points), ours),
        ratio_row(f"loops, after the survey / whole of boundary, {at}", "at most 0.2",
                  parts["loops"][0] if parts else None, whole, False),
        ratio_row(f"boundary, {at}: one thread / two", "at least 1.7",
                  r.wall("boundary", "rimline", cloud, points, 1), ours),
        ratio_row(f"reconstruct, {at}: CGAL advancing front / rimline", "at least 3.5",
                  r.wall("reconstruct", "CGAL advancing front", cloud, points), mesh),
        ratio_row(f"reconstruct, {at}: Co3Ne / rimline", "at least 2.5",
                  r.wall("reconstruct", "geogram Co3Ne", cloud, points), mesh),
        ratio_row(f"reconstruct, {at}: one thread / two", "at least 1.7",
                  r.wall("reconstruct", "rimline", cloud, points, 1), mesh),
    ]


def aims(r):
    million, tenth, ten = 1_000_000, 100_000, 10_000_000
    rows = cloud_aims(r, "sheet", million)
    rows += [row for row in cloud_aims(r, "head_1m", million) if row[-1]]
    search = [r.bench(name, million, 1) for name in ("arrange_stage", "neighbours_stage")]
    rows += [
        ratio_row("k nearest, 1,000,000 in input order, one thread: nanoflann's loop / arrange + neighbours",
                  "at least 3", r.bench("nanoflann_in_input_order", million), sum(search) if all(search) else None),
        ratio_row("reconstruct, sheet, 100,000: Co3Ne / rimline", "at least 1",
                  r.wall("reconstruct", "geogram Co3Ne", "sheet", tenth),
                  r.wall("reconstruct", "rimline", "sheet", tenth, 2)),
        ratio_row("start of the tool, milliseconds", "at most 30", 1000 * statistics.median(r.data["start"]), 1, False),
    ]
    rows += python_rows(r)
    big = r.find("reconstruct", "rimline", "sheet", ten)
    rows.append(ratio_row("reconstruct, 10,000,000: peak memory, GB", "at most 16",
                          max(big["peak_mb"]) / 1024 if big else None, 1, False))
    bound = 10 * math.log(ten) / math.log(million)
    before, after = (r.stage_seconds("reconstruct", "sheet", n, 2) for n in (million, ten))
    for name in before:
        if name in after and after[name][0] > 1:
            rows.append(ratio_row(f"{name}: time at 10,000,000 / at 1,000,000", f"n log n: at most {bound:.1f}",
                                  after[name][0], before[name][0], False))
    return table(["what", "aim", "measured", "met"], rows)


def python_rows(r):
    """What the binding adds to the stages of the same call, and the call beside the tool's own stages."""
    rows = []
    python = r.data.get("python") or {}
    for work in ("boundary", "reconstruct"):
        runs = python.get(work, [])
        middle = {name: statistics.median(run[name] for run in runs) for name in (runs[0] if runs else {})}
        name = f"{work} from Python, sheet, {python.get('points', 0):,}: the call / "
        if middle:
            rows.append(ratio_row(name + "the stages in it", "at most 1.03", middle["call"], middle["stages"], False))
        if "tool" in middle:
            rows.append(ratio_row(name + "the tool's own stages, without write", "at most 1.03", middle["method"], middle["tool"], False))
    return rows


def processes(r):
    rows = []
    for row in sorted(r.data["runs"], key=lambda x: (x["work"], x["cloud"], x["points"], x["program"] != "rimline",
                                                     x["program"], x["threads"])):
        ours = r.wall(row["work"], "rimline", row["cloud"], row["points"], 2)
        wall = statistics.median(row["wall"])
        rows.append([row["work"], row["cloud"], f"{row['points']:,}", row["program"], row["threads"], seconds(wall),
                     seconds(statistics.median(row["cpu"])), f"{max(row['peak_mb']):,.0f}", len(row["wall"]),
                     f"{wall / ours:.2f}" if ours else ""])
    return table(["work", "cloud", "points", "program", "threads", "wall s", "CPU s", "peak MB", "runs",
                  "wall / rimline on 2"], rows)


def where(r, work, points):
    cloud = r.cloud_at(points)
    parts, single = (r.stage_seconds(work, cloud, points, threads) for threads in (2, 1))
    if not parts:
        return ""
    whole, rate = sum(s for s, _ in parts.values()), r.bandwidth()
    rows = []
    for name, (time, peak) in parts.items():
        traffic, why = LIMITS.get(name, (None, ""))
        limit = traffic * points / rate if traffic and rate else None
        rows.append([name, seconds(time), f"{100 * time / whole:.0f} %",
                     f"{single[name][0] / time:.2f}" if name in single and time > 0 else "", f"{peak / 2**20:,.0f}",
                     seconds(limit) if limit else "", why])
    return table(["stage", "s, 2 threads", "share", "1 thread / 2", "peak MB", "memory limit s", "what it must do"], rows)


def stage_table(r):
    rows = []
    for b in r.data["stages"]["benchmarks"]:
        if b.get("aggregate_name") != "median":
            continue
        parts = b["run_name"].split("/")
        numbers = [p.split(":")[-1] for p in parts[1:] if p.split(":")[-1].isdigit()]
        scale = {"ms": 1, "us": 1e-3, "ns": 1e-6, "s": 1e3}[b["time_unit"]]
        rows.append([parts[0], f"{int(numbers[0]):,}" if numbers else "", numbers[1] if len(numbers) > 1 else 1,
                     f"{b['real_time'] * scale:,.1f}", f"{b['cpu_time'] * scale:,.1f}"])
    return table(["stage", "points", "threads", "wall ms", "CPU ms"], rows)


def series(r, work):
    lines = {}
    for row in r.data["runs"]:
        if row["work"] == work and row["cloud"] == "sheet":
            name = row["program"] + (f", {row['threads']} threads" if row["program"] == "rimline" else "")
            lines.setdefault(name.replace("1 threads", "1 thread"), []).append(
                (row["points"], statistics.median(row["wall"])))
    return lines


def stage_series(r):
    lines = {}
    for points in sorted({row["points"] for row in r.data["runs"]}):
        for name, (time, _) in r.stage_seconds("reconstruct", "sheet", points, 2).items():
            lines.setdefault(name, []).append((points, max(time, 1e-4)))
    return lines


def write(data, folder):
    r = Results(data)
    for name, title, lines in (("boundary", "boundary: seconds over points", series(r, "boundary")),
                               ("reconstruct", "reconstruct: seconds over points", series(r, "reconstruct")),
                               ("stages", "stages of reconstruct on 2 threads", stage_series(r))):
        (folder / f"benchmarks-{name}.svg").write_text(plot.log_log(title, lines))
    m, rate = data["machine"], r.bandwidth()
    rimline = data["versions"]["rimline"]
    others = ", ".join(f"{k} {v}" for k, v in data["versions"].items() if k != "rimline")
    text = f"""# How fast it is

Written by `{data["command"]}` at {rimline} on {data["date"]}, in {data["minutes"]:.0f} minutes; do not edit.

Machine: {m["processor"]}, {m["cores"]} cores, {m["memory_gb"]} GB, {m["system"]}; load before the first run
{m["load_before"]:.1f}{f"; copying runs at {rate / 1e9:.1f} GB/s, read and written" if rate else ""}.
Beside it: {others}.

Times are medians of the number of runs given, of whole processes, file to file with a warm cache, with all defaults on.
Programs take turns. Peers read plain arrays, which costs them less than a PLY file, and write nothing but ids. *sheet*:
`rimline sample wavy-saddle --sampling random --seed 7`, in the order it is drawn; *head_1m*: a data set of a million
points. PCL: 30 neighbours for normals, 40 for the boundary.

## Aims

{aims(r)}
![boundary](benchmarks-boundary.svg)
![reconstruct](benchmarks-reconstruct.svg)
![stages](benchmarks-stages.svg)

## Whole processes

{processes(r)}
## Where the time goes at a million points

The memory limit is what the bytes that a stage must move cost at the speed of a copy: no method of this kind is faster.

The stage *survey* finds the triangles between neighbours, which flags and probabilities rest on as much as loops do; the
stage *loops* decides which of them are of the surface, and orders, rates and labels what they end at.

`rimline boundary`:

{where(r, "boundary", 1_000_000)}
`rimline reconstruct`:

{where(r, "reconstruct", 1_000_000)}
What stays on one core: in *survey* the queue that fills notches, smallest first; in *loops* the walks along rims and
the search within one group of doubtful triangles (groups are searched at the same time). Sums of numbers are taken in
a fixed order, so that bytes do not depend on threads.

## Stages alone

`rimline_bench_speed`, Google Benchmark, on a random sheet; *in input order* means points in random order.

{stage_table(r)}"""
    (folder / "benchmarks.md").write_text(text)
