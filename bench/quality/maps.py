#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps beside what people use, of the same triangles: angles, areas, stretch, turned triangles, seconds. Called by bench/quality/maps.

   maps.py --tool RIMLINE --peers FOLDER [--only NAME ...] [--most-points N] [--markdown docs/maps.md] [--json OUT]

Meshes are made by rimline (--domain none) of built-in samples and of the files in the folders that RIMLINE_DATA names; of each, the
largest component is taken where it is a disc with holes. A peer that is not there is left out, aloud. Needs numpy; libigl needs scipy.
"""
import argparse
import importlib.util
import json
import os
import resource
import signal
import statistics
import subprocess
import sys
import tempfile

import numpy as np

import map_files
import map_measures

ONE_THREAD = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
SAMPLES = ["half-tunnel", "curled-strip", "hemisphere-cap", "sphere-minus-cap", "wavy-saddle", "square-with-holes", "capped-tube"]
OURS = [("rimline, auto", "auto"), ("rimline, one chart", "one"), ("rimline, disc", "disc")]
CGAL = [("CGAL LSCM", "lscm"), ("CGAL ARAP", "arap"), ("CGAL discrete conformal, circle", "discrete-conformal"),
        ("CGAL discrete authalic, circle", "discrete-authalic")]
IGL = [("libigl LSCM", "lscm"), ("libigl ARAP", "arap"), ("libigl SLIM", "slim")]


def methods_of(folder):
    """(name, command) of all that are there."""
    found = []
    for program, methods in (("rimline_maps", OURS), ("rimline_peer_cgal_maps", CGAL)):
        path = os.path.join(folder, program)
        if os.path.exists(path):
            found += [(name, [path, method]) for name, method in methods]
        else:
            print(f"left out: {path} was not built", file=sys.stderr)
    if importlib.util.find_spec("igl") and importlib.util.find_spec("scipy"):
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "map_igl.py")
        found += [(name, [sys.executable, script, method]) for name, method in IGL]
    else:
        print(f"left out: libigl (pip install libigl scipy, for {sys.executable})", file=sys.stderr)
    print("left out: boundary first flattening: no package registry has it (potpourri3d's geometry-central is without it)", file=sys.stderr)
    return found


def sets_of(only):
    """(name, path or None for a sample)."""
    sets = [("sample/" + shape, None) for shape in SAMPLES]
    for folder in filter(None, os.environ.get("RIMLINE_DATA", "").split(":")):
        for file in sorted(os.listdir(folder)):
            base, ending = os.path.splitext(file)
            if ending in (".ply", ".xyz") and "." not in base:
                sets.append((os.path.basename(os.path.normpath(folder)) + "/" + base, os.path.join(folder, file)))
    return [s for s in sets if not only or any(part in s[0] for part in only)]


def largest_piece(points, triangles):
    """The component of the most triangles, with its own points."""
    label = np.arange(len(points))
    while True:
        least = label[triangles].min(1)
        after = label.copy()
        np.minimum.at(after, triangles.ravel(), np.repeat(least, 3))
        after = after[after]
        if (after == label).all():
            break
        label = after
    names, counts = np.unique(label[triangles[:, 0]], return_counts=True)
    triangles = triangles[label[triangles[:, 0]] == names[counts.argmax()]]
    used, index = np.unique(triangles, return_inverse=True)
    return points[used], index.reshape(-1, 3)


def mesh_of(options, path, name, folder):
    """Nothing where there is no mesh to compare, with the reason."""
    if path is None:
        path = os.path.join(folder, "sample.ply")
        subprocess.run([options.tool, "sample", name.split("/")[1], "-n", str(options.sample_points), "-o", path, "--quiet"], check=True)
    mesh = os.path.join(folder, "mesh.ply")
    told = subprocess.run([options.tool, "reconstruct", path, "-o", mesh, "--domain", "none", "--quiet"], capture_output=True, text=True)
    if told.returncode:
        return None, told.stderr.strip()
    points, triangles = largest_piece(*map_files.read_mesh(mesh))
    if len(points) > options.most_points:
        return None, f"{len(points)} points"
    if not map_measures.is_disc_with_holes(triangles):
        return None, "no disc with holes"
    return (points, triangles), None


def ask(command, mesh, folder, limit):
    question, answer = (os.path.join(folder, name) for name in ("question", "answer"))
    map_files.write_question(question, *mesh)
    if os.path.exists(answer):
        os.remove(answer)
    try:
        done = subprocess.run(command + [question, answer], capture_output=True, text=True, timeout=20 * limit, env=ONE_THREAD,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5)))
    except subprocess.TimeoutExpired:
        return {"failure": f"not done after {20 * limit:.0f} s"}
    if done.returncode == -signal.SIGXCPU:
        return {"failure": f"not done after {limit:.0f} s"}
    if done.returncode or not os.path.exists(answer):
        return {"failure": (done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1]}
    seconds, corners, chart = map_files.read_answer(answer)
    return {"seconds": seconds, **map_measures.measure(*mesh, corners, chart)}


def kept(path):
    """What an earlier run measured, by set."""
    if not path:
        return {}
    with open(path) as file:
        return {row["set"]: row for row in json.load(file)}


def measured(options, folder):
    methods = methods_of(options.peers)
    before = kept(options.keep)
    for name, path in sets_of(options.only):
        mesh, why = mesh_of(options, path, name, folder)
        if mesh is None:
            print(f"left out: {name}: {why}", file=sys.stderr)
            continue
        row = {"set": name, "points": len(mesh[0]), "least": map_measures.least_angle_error(*mesh), "maps": {}}
        old = before.get(name, {"points": 0, "maps": {}})
        same = old["points"] == row["points"] and old.get("least") == row["least"]
        for method, command in methods:
            keeps = same and method in old["maps"] and not method.startswith("rimline")
            row["maps"][method] = old["maps"][method] if keeps else ask(command, mesh, folder, options.limit)
        print(name, {m: r.get("failure") or round(r.get("angle", 9), 4) for m, r in row["maps"].items()}, file=sys.stderr, flush=True)
        yield row


def is_whole(result):
    return "failure" not in result and result["turned"] == 0


def cells(values):
    return "| " + " | ".join(values) + " |"


def table(head, rows):
    return [cells(head), cells(["---"] * len(head))] + [cells(row) for row in rows]


def summary(rows):
    """One row a method; medians over the meshes that all but the failing have in common would favour the failing: over its own."""
    lines = []
    for method in rows[0]["maps"]:
        results = [row["maps"][method] for row in rows]
        whole = [r for r in results if is_whole(r)]
        mapped = [r for r in results if "failure" not in r]
        def median(key, digits):
            return f"{statistics.median(r[key] for r in whole):.{digits}f}" if whole else "-"
        lines.append([method, f"{len(mapped)} of {len(rows)}", str(sum(r["turned"] > 0 for r in mapped)),
                      str(sum(bool(r.get("crossings")) for r in mapped)), median("charts", 0), median("angle", 4), median("area", 3),
                      median("mean", 3), f"{max((r['mean'] for r in whole), default=0):.3g}",
                      f"{max((r['worst'] for r in whole), default=0):.3g}", f"{sum(r['seconds'] for r in mapped):.1f}"])
    return table(["method", "mapped", "with turned triangles", "outline crosses itself", "charts", "angle error, rad", "area error",
                  "L2 stretch", "worst L2", "worst Linf", "CPU seconds, all"], lines)


def by_set(rows, key, digits):
    """A row a mesh; ! where triangles are turned, - where there is no map."""
    def cell(result):
        if "failure" in result:
            return "-"
        return f"{result[key]:.{digits}f}" + ("!" if result["turned"] else "") if key in result else "!"
    return table(["mesh", "points", "least angle error"] + list(rows[0]["maps"]),
                 [[row["set"], str(row["points"]), f"{row['least']:.4f}"] + [cell(r) for r in row["maps"].values()] for row in rows])


def page(rows, commit, command):
    missing = sorted({f"{name}: {row['maps'][name]['failure']}" for row in rows for name in row["maps"] if "failure" in row["maps"][name]})
    return "\n".join([
        "# Maps beside others", "",
        "Maps of the same triangles, those of rimline's meshes. Written by `bench/quality/maps`; what the columns mean is in",
        "[bench/README.md](../bench/README.md#maps). geometry-central's boundary first flattening is not here: no package registry has it.", "",
        *table(["command", "commit"], [[f"`{command}`", commit]]), "",
        "## All meshes", "", *summary(rows), "", "Medians and worst are over each method's maps without turned triangles.", "",
        "## Angle error, radians", "", "`!`: with turned triangles. `-`: no map.", "", *by_set(rows, "angle", 4), "",
        "## Seconds of CPU, on one thread", "", *by_set(rows, "seconds", 3), "",
        "## Why there is none", "", *([f"- {line}" for line in missing] or ["Each method has a map of each mesh."]), ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", required=True)
    parser.add_argument("--peers", required=True, help="the folder of rimline_maps and rimline_peer_cgal_maps")
    parser.add_argument("--only", nargs="*", default=[], help="parts of names of sets")
    parser.add_argument("--most-points", type=int, default=60000)
    parser.add_argument("--sample-points", type=int, default=3000)
    parser.add_argument("--limit", type=float, default=120, help="seconds of CPU that a method may take on one mesh")
    parser.add_argument("--keep", help="JSON of an earlier run: others' maps of the same mesh are not made again")
    parser.add_argument("--commit", default="unknown")
    parser.add_argument("--markdown")
    parser.add_argument("--json")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for row in measured(options, folder):
            rows.append(row)
            if options.json:
                with open(options.json, "w") as file:
                    json.dump(rows, file, indent=1)
    if not rows:
        sys.exit("no mesh to map")
    command = " ".join(["bench/quality/maps", "--most-points", str(options.most_points), "--limit", f"{options.limit:g}"] +
                       (["--only", *options.only] if options.only else []))
    text = page(rows, options.commit, command)
    map_files.put_page(text, options.markdown)


if __name__ == "__main__":
    main()
