#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dirt that is added to clean points, and what becomes of it, beside what people use. Called by bench/quality/dirt.

   dirt.py --tool RIMLINE --peers FOLDER [--kinds NAME ...] [--seeds N] [--sets N] [--no-peers] [--markdown docs/dirt.md] [--json OUT]

A method is compared with itself on the clean points, so that its dealing with dirt is seen alone. Clean points are built-in samples and,
of the folders that RIMLINE_DATA names, --sets of the smallest sets that say nothing of noise. Needs numpy.
"""
import argparse
import collections
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import dirt_kinds
import map_files

SAMPLES = [("flat-disc", "blue-noise"), ("bumpy-square", "blue-noise"), ("hemisphere-cap", "blue-noise"), ("half-tunnel", "grid"),
           ("square-with-holes", "random")]
OURS = "rimline"
PEERS = [("greedy projection", "rimline_peer_pcl", "greedy-projection"), ("Co3Ne", "rimline_peer_geogram", "co3ne"),
         ("advancing front", "rimline_peer_cgal", "advancing-front")]
Answer = collections.namedtuple("Answer", "triangles stray loops intersections seconds status")


def ask_rimline(tool, points, folder):
    cloud, mesh, report, marks = (os.path.join(folder, name) for name in ("cloud.npy", "mesh.ply", "report.json", "marks.ply"))
    np.save(cloud, points)
    if os.path.exists(mesh):
        os.remove(mesh)
    start = time.perf_counter()
    done = subprocess.run([tool, "reconstruct", cloud, "-o", mesh, "--report", report, "--domain", "none", "--quiet"], capture_output=True)
    seconds = time.perf_counter() - start
    triangles = map_files.read_mesh(mesh)[1] if os.path.exists(mesh) else np.zeros((0, 3), int)
    if not os.path.exists(report):
        return Answer(triangles, 0, [], 0, seconds, done.returncode)
    with open(report) as file:
        told = json.load(file)
    loops = [loop["probability"] for loop in told["loops"]]
    return Answer(triangles, told["points"]["stray"], loops, told.get("mesh", {}).get("self_intersections", 0), seconds, done.returncode)


def ask_peer(command, points, folder, limit):
    question, answer = (os.path.join(folder, name) for name in ("question", "answer"))
    with open(question, "wb") as file:
        np.array([len(points)], "<i8").tofile(file)
        np.ascontiguousarray(points, "<f8").tofile(file)
    if os.path.exists(answer):
        os.remove(answer)
    try:
        status = subprocess.run(command + [question, answer], capture_output=True, timeout=limit).returncode
    except subprocess.TimeoutExpired:
        status = 124
    if status or not os.path.exists(answer):
        return Answer(np.zeros((0, 3), int), 0, [], 0, limit, status)
    with open(answer, "rb") as file:
        seconds = float(np.fromfile(file, "<f8", 1)[0])
        np.fromfile(file, "<i4", int(np.fromfile(file, "<i8", 1)[0]))
        triangles = np.fromfile(file, "<i4", 3 * int(np.fromfile(file, "<i8", 1)[0])).reshape(-1, 3).astype(int)
    return Answer(triangles, 0, [], 0, seconds, 0)


def methods_of(options, folder):
    methods = {OURS: lambda points: ask_rimline(options.tool, points, folder)}
    for name, program, method in [] if options.no_peers else PEERS:
        path = os.path.join(options.peers, program)
        if os.path.exists(path):
            methods[name] = lambda points, command=[path, method]: ask_peer(command, points, folder, options.limit)
        else:
            print(f"left out: {path} was not built", file=sys.stderr)
    return methods


def sample(tool, shape, sampling, points, seed, folder):
    path = os.path.join(folder, "sample.ply")
    subprocess.run([tool, "sample", shape, "-n", str(points), "--sampling", sampling, "--seed", str(seed), "-o", path, "--quiet"], check=True)
    return map_files.read_points(path)


def clean_sets(options, folder):
    """(name, points)."""
    sets = [(f"{shape}, {sampling}", sample(options.tool, shape, sampling, options.points, 1, folder)) for shape, sampling in SAMPLES]
    files = []
    for path in filter(None, os.environ.get("RIMLINE_DATA", "").split(":")):
        index = os.path.join(path, "index.json")
        if os.path.exists(index):
            with open(index) as file:
                found = json.load(file)
            found = found["sets"] if isinstance(found, dict) else found
            files += [(s["points"], s["name"], os.path.join(path, s["name"] + ".ply")) for s in found
                      if s["loops"] and s["points"] >= 1000 and not {"hard", "noise", "scan", "jagged"} & set(s["tags"])]
    files.sort()
    return sets + [(name, map_files.read_points(path)) for _, name, path in files[::max(1, len(files) // max(1, options.sets))][:options.sets]]


def spacing_of(points):
    """Median distance to the sixth nearest, over a sample of points, for six around each: about that of a triangular grid."""
    chosen = np.random.default_rng(0).choice(len(points), min(300, len(points)), replace=False)
    far = np.linalg.norm(points[chosen][:, None] - points[None], axis=2)
    return float(np.median(np.sort(far, 1)[:, 1:7].mean(1)))


def keys(triangles):
    return {tuple(sorted(t)) for t in triangles.tolist()}


def rims(triangles):
    """The open edges as sets of ids, a set for each connected part."""
    edges = np.sort(np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), 1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    parent = {}
    def root(v):
        while parent.setdefault(v, v) != v:
            parent[v] = v = parent[parent[v]]
        return v
    once = [tuple(e) for e in unique[counts == 1].tolist()]
    for a, b in once:
        parent[root(a)] = root(b)
    parts = collections.defaultdict(set)
    for a, b in once:
        parts[root(a)].add((a, b))
    return {frozenset(part) for part in parts.values()}


def agreement(a, b):
    """F1 of two sets."""
    return 2 * len(a & b) / (len(a) + len(b)) if a or b else 1.0


def compare(clean, dirty, count, added):
    """An answer on dirty points beside that on the `count` clean ones."""
    before, after = keys(clean.triangles), keys(dirty.triangles)
    rims_before, rims_after = rims(clean.triangles), rims(dirty.triangles)
    on_rim = [{v for part in parts for edge in part for v in edge} for parts in (rims_before, rims_after)]
    used_before, used_after = (set(np.unique(a.triangles).tolist()) for a in (clean, dirty))
    dirt_used = sum(v >= count for v in used_after)
    surprise = len(dirty.loops) != len(clean.loops) and any(p is not None and p > 0.8 for p in dirty.loops)
    return {"status": dirty.status, "count_right": len(rims_before) == len(rims_after), "same_loops": rims_before == rims_after,
            "rim_points": agreement(*on_rim), "common": len(before & after) / max(len(before), len(after), 1),
            "found": 1 - dirt_used / added if added else None,
            "false": len({v for v in used_before if v < count} - used_after) / count,
            "intersections": dirty.intersections, "sure": surprise, "seconds": dirty.seconds, "of_clean": dirty.seconds / max(clean.seconds, 1e-9)}


def of_kind(options, table, sets, methods, seeds):
    for name, points in sets:
        spacing = spacing_of(points)
        clean = {method: ask(points) for method, ask in methods.items()}
        for kind, (soil, amounts) in table.items():
            if options.kinds and kind not in options.kinds:
                continue
            for amount in amounts:
                for seed in range(seeds):
                    dirty = soil(np.random.default_rng([seed, len(points)]), points, spacing, amount)
                    for method, ask in methods.items():
                        row = compare(clean[method], ask(dirty), len(points), len(dirty) - len(points))
                        yield {"kind": kind, "amount": amount, "set": name, "seed": seed, "method": method, **row}


def of_layers(options, methods, folder):
    if options.kinds and "two layers" not in options.kinds:
        return
    for shape in ("flat-disc", "bumpy-square"):
        for seed in range(options.seeds):
            first, second = (sample(options.tool, shape, "blue-noise", options.points, 2 * seed + k, folder) for k in (1, 2))
            spacing = spacing_of(first)
            clean = {method: ask(first) for method, ask in methods.items()}
            for gap in dirt_kinds.LAYERS:
                dirty = dirt_kinds.layers(None, first, second, spacing, gap)
                for method, ask in methods.items():
                    answer = ask(dirty)
                    upper = (answer.triangles >= len(first)).sum(1)
                    mixed = float(((upper > 0) & (upper < 3)).mean()) if len(upper) else 0.0
                    loops = len(rims(answer.triangles))
                    right = len(rims(clean[method].triangles))
                    yield {"kind": "two layers", "amount": gap, "set": shape, "seed": seed, "method": method, "status": answer.status,
                           "mixed": mixed, "parted": mixed == 0 and loops == 2 * right, "one": loops == right and len(upper) > 0,
                           "sure": mixed > 0.01 and any(p and p > 0.8 for p in answer.loops),
                           "none": answer.status == 3, "intersections": answer.intersections, "seconds": answer.seconds}


def of_hopeless(options, methods, folder):
    healthy = sample(options.tool, "bumpy-square", "blue-noise", options.hopeless_points, 1, folder)
    base = {method: ask(healthy) for method, ask in methods.items()}
    for kind, make in dirt_kinds.HOPELESS.items():
        if options.kinds and kind not in options.kinds:
            continue
        for method, ask in methods.items():
            answer = ask(make(np.random.default_rng(0), options.hopeless_points))
            yield {"kind": kind, "amount": options.hopeless_points, "set": "-", "seed": 0, "method": method, "status": answer.status,
                   "triangles": len(answer.triangles), "seconds": answer.seconds, "of_clean": answer.seconds / base[method].seconds}


def cells(values):
    return "| " + " | ".join(values) + " |"


def table(head, rows):
    return [cells(head), cells(["---"] * len(head))] + [cells(row) for row in rows]


def grouped(rows):
    groups = collections.defaultdict(list)
    for row in rows:
        groups[row["kind"], row["amount"], row["method"]].append(row)
    return groups


def mean(rows, key, digits=3):
    values = [r[key] for r in rows if r.get(key) is not None]
    return f"{statistics.fmean(values):.{digits}f}" if values else "-"


def share(rows, key):
    return f"{sum(bool(r[key]) for r in rows)} of {len(rows)}"


def added_table(rows):
    return table(["dirt", "amount", "method", "same loops", "loop count right", "triangles in common", "stray found", "falsely found",
                  "time, of clean"],
                 [[kind, f"{amount:g}", method, share(g, "same_loops"), share(g, "count_right"), mean(g, "common", 4), mean(g, "found"),
                   mean(g, "false", 5), mean(g, "of_clean", 1)] for (kind, amount, method), g in grouped(rows).items()])


def moved_table(rows):
    return table(["steps", "spacings", "method", "loop count right", "rim points, F1", "triangles in common", "points lost",
                  "self-intersections", "sure though wrong", "time, of clean"],
                 [[kind, f"{amount:g}", method, share(g, "count_right"), mean(g, "rim_points"), mean(g, "common"), mean(g, "false", 4),
                   mean(g, "intersections", 0) if method == OURS else "-", share(g, "sure") if method == OURS else "-",
                   mean(g, "of_clean", 1)] for (kind, amount, method), g in grouped(rows).items()])


def layers_table(rows):
    return table(["gap, spacings", "method", "parted", "one surface", "triangles across", "status 3", "sure though wrong", "self-intersections"],
                 [[f"{amount:g}", method, share(g, "parted"), share(g, "one"), mean(g, "mixed"), share(g, "none"),
                   share(g, "sure") if method == OURS else "-", mean(g, "intersections", 0) if method == OURS else "-"]
                  for (kind, amount, method), g in grouped(rows).items()])


def hopeless_table(rows):
    return table(["cloud", "points", "method", "status", "triangles", "seconds", "times a healthy set"],
                 [[kind, str(amount), method, str(g[0]["status"]), str(g[0]["triangles"]), mean(g, "seconds", 2), mean(g, "of_clean", 1)]
                  for (kind, amount, method), g in grouped(rows).items()])


def page(parts, options, command):
    return "\n".join([
        "# Dirt", "",
        "What a scanner adds to a surface, and what becomes of it. Written by `bench/quality/dirt`; what the columns mean is in",
        "[bench/README.md](../bench/README.md#dirt). A method is compared with itself on the clean points.", "",
        *table(["command", "commit"], [[f"`{command}`", options.commit]]), "",
        "## Points added", "", *added_table(parts["added"]), "",
        "## Coordinates in steps", "", *moved_table(parts["moved"]), "",
        "## Two layers", "", *layers_table(parts["layers"]), "",
        "## Hopeless clouds", "", *hopeless_table(parts["hopeless"]), ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", required=True)
    parser.add_argument("--peers", default="", help="the folder of the peers' programs")
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--kinds", nargs="*", default=[], help="names of kinds; all where none is given")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--sets", type=int, default=5, help="number of sets of RIMLINE_DATA")
    parser.add_argument("--points", type=int, default=2000, help="of a sample")
    parser.add_argument("--hopeless-points", type=int, default=20000)
    parser.add_argument("--limit", type=float, default=120, help="seconds that a peer may take")
    parser.add_argument("--commit", default="unknown")
    parser.add_argument("--markdown")
    parser.add_argument("--json")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        methods = methods_of(options, folder)
        sets = clean_sets(options, folder)
        scenes = [(f"plate before a wall {k}", dirt_kinds.plate_before_wall(np.random.default_rng(k), options.points)) for k in range(3)]
        parts = {"added": list(of_kind(options, dirt_kinds.ADDED, sets, methods, options.seeds))
                 + list(of_kind(options, dirt_kinds.FLYING, scenes, methods, options.seeds)),
                 "moved": list(of_kind(options, dirt_kinds.MOVED, sets, methods, 1)),
                 "layers": list(of_layers(options, methods, folder)),
                 "hopeless": list(of_hopeless(options, methods, folder))}
    if options.json:
        with open(options.json, "w") as file:
            json.dump(parts, file, indent=1)
    text = page(parts, options, f"bench/quality/dirt --seeds {options.seeds} --sets {options.sets} --points {options.points} "
                f"--hopeless-points {options.hopeless_points} --limit {options.limit:g}")
    map_files.put_page(text, options.markdown)


if __name__ == "__main__":
    main()
