# SPDX-License-Identifier: GPL-3.0-or-later
"""Logistic regressions over what rimline_features measures; tools/fit/fit runs it.

Each set weighs the root of its lines, all of its lines alike. Left out are sets, model by model: the model of a set is its
name up to the first underscore (the corpus has several sets of one), or the set itself.
"""

import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys

import numpy as np

import model_table

# Of each term: the struct of model.h, its coefficients in the order of the columns, and the columns from the measures.
TERMS = ("rims", "range_rims", "ears", "points_on", "points_behind", "range_points", "triangles")


def read_model():
    values = {}
    for _, struct, name, number, _ in model_table.coefficients(model_table.read_headers()):
        values[struct, name] = float(number.rstrip("fF"))
    return values


def log_odds(p):
    return np.log(p / (1 - p))


def columns(term, x, model):
    """The regressors of a term (after the constant), from the lines of rimline_features."""
    if term == "rims":
        size = np.log(np.minimum(x[:, 0], model["RimModel", "most_points"]) / model["RimModel", "usual_points"])
        ball = np.minimum(x[:, 2], model["RimModel", "most_ball"])
        return np.column_stack([size, x[:, 1], ball])
    if term == "range_rims":
        size = np.log(np.minimum(x[:, 0], model["RangeRimModel", "most_points"]) / model["RangeRimModel", "usual_points"])
        return np.column_stack([size, x[:, 1]])
    if term in ("ears", "triangles"):
        return x
    if term == "range_points":
        return np.log1p(x)
    struct = "PointOnRimModel" if term == "points_on" else "PointBehindRimModel"
    ear = np.clip(x[:, 0], model[struct, "least_ear"], model[struct, "most_ear"])
    rim = log_odds(np.clip(x[:, 2], model["", "rim_least"], model["", "rim_most"]))
    return np.column_stack([ear, np.log1p(x[:, 1]), rim])


def today(term, model):
    """Name and value of each coefficient as model.h has it."""
    if term == "range_points":
        return [("range_point_constant", model["", "range_point_constant"]), ("range_point_chi", model["", "range_point_chi"])]
    struct, names = {
        "rims": ("RimModel", ("constant", "size", "thickness", "empty_ball")),
        "range_rims": ("RangeRimModel", ("constant", "size", "one_sided")),
        "ears": ("FalseEarModel", ("constant", "angle", "log_tail", "jaggedness")),
        "triangles": ("RimFitnessModel", ("open", "size", "own", "tip", "spread", "even", "slight", "moderate", "sharp",
                                          "even_slight", "even_moderate", "even_sharp", "contrast", "pinch",
                                          "one_sided", "least_one_sided", "toward", "least_toward")),
        "points_on": ("PointOnRimModel", ("constant", "ear", "chi", "rim")),
        "points_behind": ("PointBehindRimModel", ("constant", "ear", "chi", "rim")),
    }[term]
    return [(f"{struct}::{name}", model[struct, name]) for name in names]


def regress(a, y, w):
    """Logistic regression by iteratively reweighted least squares, with a ridge of a millionth of the weight."""
    ridge = 1e-6 * w.sum() * np.eye(a.shape[1])
    beta = np.zeros(a.shape[1])
    for _ in range(100):
        p = 1 / (1 + np.exp(-np.clip(a @ beta, -30, 30)))
        gradient = a.T @ (w * (y - p)) - ridge @ beta
        hessian = (a * (w * p * (1 - p) + 1e-12)[:, None]).T @ a + ridge
        step = np.linalg.solve(hessian, gradient)
        beta = beta + step * min(1, 2 / max(np.abs(step).max(), 1e-12))
        if np.abs(step).max() < 1e-8:
            break
    return beta


def judge(z, y, w):
    """Log loss, share on the wrong side of a half, and Brier score."""
    p = np.clip(1 / (1 + np.exp(-np.clip(z, -30, 30))), 1e-9, 1 - 1e-9)
    share = w / w.sum()
    return (-(share * (y * np.log(p) + (1 - y) * np.log(1 - p))).sum(), (share * ((p >= 0.5) != (y == 1))).sum(),
            (share * (p - y) ** 2).sum())


def measure(tool, sets, out):
    """The lines of each set: a dictionary from set to text."""

    def run(file):
        kept = out / (file.stem + ".csv") if out else None
        if kept and kept.exists():
            return kept.read_text()
        done = subprocess.run([tool, str(file)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(f"left out: {done.stderr.strip()}", file=sys.stderr)
            return ""
        if kept:
            kept.write_text(done.stdout)
        return done.stdout

    with concurrent.futures.ThreadPoolExecutor(max_workers=max(1, (os.cpu_count() or 2) // 2)) as pool:
        return dict(zip(sets, pool.map(run, sets)))


def table(term, lines):
    """Measures, truth, weight and model of all lines of a term."""
    x, y, w, group = [], [], [], []
    for file, text in lines.items():
        rows = [line.split(",")[1:] for line in text.splitlines() if line.startswith(term + ",")]
        for row in rows:
            y.append(float(row[0]))
            x.append([float(v) for v in row[1:]])
            w.append(len(rows) ** -0.5)
            group.append(file.stem.split("_")[0])
    return np.array(x), np.array(y), np.array(w), np.array(group)


def report(term, lines, model):
    x, y, w, group = table(term, lines)
    models = sorted(set(group))
    print(f"\n## {term}: {len(y)} lines of {len(models)} models, {y.mean() if len(y) else 0:.3f} true")
    if len(y) < 50 or y.min() == y.max() or len(models) < 2:
        print("too few to fit")
        return
    a = np.column_stack([np.ones(len(y)), columns(term, x, model)])
    beta = regress(a, y, w)
    held_out, folds = np.zeros(len(y)), []
    for m in models:
        rest = group != m
        if y[rest].min() == y[rest].max():
            continue
        fold = regress(a[rest], y[rest], w[rest])
        folds.append(fold)
        held_out[~rest] = a[~rest] @ fold
    spread = np.std(folds, axis=0) if folds else np.zeros(a.shape[1])
    names = today(term, model)
    print(f"{'coefficient':34} {'today':>9} {'fitted':>9} {'folds +-':>9}")
    for (name, value), fitted, s in zip(names, beta, spread):
        print(f"{name:34} {value:9.3f} {fitted:9.3f} {s:9.3f}")
    print(f"{'':34} {'log loss':>9} {'wrong':>9} {'Brier':>9}")
    current = a @ np.array([value for _, value in names])
    for title, z in (("today", current), ("fitted, all sets", a @ beta), ("fitted, a model left out each time", held_out)):
        print(f"{title:34} {judge(z, y, w)[0]:9.4f} {judge(z, y, w)[1]:9.4f} {judge(z, y, w)[2]:9.4f}")


def main():
    parser = argparse.ArgumentParser(prog="tools/fit/fit", description=__doc__)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--features", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--out", type=pathlib.Path, help="folder that keeps the measurements of each set")
    parser.add_argument("--term", choices=TERMS, action="append", help="fit this one alone; may be given again")
    parser.add_argument("--most-points", type=int, default=50000, help="larger files of more points are left out")
    args = parser.parse_args()
    sets = [f for folder in args.folders for f in sorted(folder.glob("*.ply"))
            if not f.name.endswith((".truth.ply", ".flipped.ply")) and f.stat().st_size <= 40 * args.most_points]
    if not sets:
        sys.exit("no SET.ply in these folders")
    if args.out:
        args.out.mkdir(parents=True, exist_ok=True)
    lines = measure(args.features, sets, args.out)
    print(f"{sum(bool(t) for t in lines.values())} of {len(sets)} sets measured")
    model = read_model()
    for term in args.term or TERMS:
        report(term, lines, model)


if __name__ == "__main__":
    main()
