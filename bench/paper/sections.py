"""The tables of docs/paper.md, each as its head and its rows."""

CAPS = ["1e-1", "3e-2", "1e-2", "3e-3", "1e-3", "3e-4", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-10", "1e-12"]


def number(x):
    return f"{x:,.0f}" if 100 <= x < 1e7 else f"{x:.3g}"


def share(x):
    return "-" if x is None else f"{x:.3f}"


def worst(runs, key):
    values = [r[key] for r in runs if key in r]
    return min(values) if len(values) == len(runs) and values else None


def mean(runs, key):
    values = [r[key] for r in runs if key in r]
    return sum(values) / len(values) if values else None


def has_truth(result):
    return bool(result.get("plateau"))


def is_base_rim(box):
    (x0, x1), (y0, y1), (z0, z1) = box
    return z1 <= 0.1 and x1 - x0 >= 0.98 and y1 - y0 >= 0.98


def outcome(entry, result):
    """Beside the caption: reproduced, or differs because."""
    form = result["forms"]["capped"]
    runs, path = form["runs"], form["paths"]["fittest"]
    if not has_truth(result):
        boxes = [r["box"] for r in runs if "box" in r]
        if entry.name == "distcap":
            right = sum(map(is_base_rim, boxes))
            return f"reproduced: the base rim over {right} of {len(runs)} seeds"
        same = sum(box == boxes[0] for box in boxes)
        return f"{entry.differs}; {same} of {len(runs)} seeds lie in the same place"
    covers, on_rim = worst(runs, "covers") or 0, worst(runs, "on_rim") or 0
    seen = f"covers {covers:.3f}, on the rim {on_rim:.3f} (worst of {len(runs)})"
    if covers >= min(0.95, path["covers"] - 0.02) and on_rim >= min(0.95, path["on_rim"] - 0.02) and covers > 0.6:
        beside = "" if min(covers, on_rim) >= 0.95 else f"; the best path {path['covers']:.3f}, {path['on_rim']:.3f}"
        return f"reproduced: {entry.expected or 'the rim'}; {seen}{beside}"
    because = f" because {entry.differs}" if entry.differs else ""
    return f"differs{because}; {seen}; the best path {path['covers']:.3f}, {path['on_rim']:.3f}"


def figure_row(entry, result):
    form = result["forms"]["capped"]
    first, paths = form["runs"][0], form["paths"]
    if "error" in first:
        return [entry.figures, entry.caption, entry.what, "", number(result["points"]), "", "", "", "", "", first["error"]]
    candidates = paths["starts"]
    return [entry.figures, entry.caption, f"{entry.name}: {entry.what}", f"40, 8, 0.10; {entry.path_k}, 100", f"{result['points']:,}", f"{candidates:,}",
            f"{paths['closed']:,}, {paths['distinct']:,}", f"{number(first['e_0'])}, {number(first['e_K'])}",
            f"{first['winner']:,}, e(C) {number(first['e_winner'])}", f"{first['loop']:,}", outcome(entry, result)]


def losers(results):
    """Sets where a path that covers the rim is there and loses."""
    lines = []
    for name, result in results.items():
        paths = result["forms"]["capped"]["paths"]
        widest, fittest = paths.get("widest"), paths["fittest"]
        if not widest or widest["covers"] < 0.9 or fittest["covers"] >= 0.9:
            continue
        per_form = ", ".join(
            f"{form} {number(result['forms'][form]['paths']['widest']['e'])} against "
            f"{number(result['forms'][form]['paths']['fittest']['e'])}" for form in ("printed", "capped", "log"))
        lines.append(f"\nOn {name} a path of {widest['points']} points that covers {widest['covers']:.3f} of the true rim is "
                     f"among the paths of Algorithm 3.1, and loses whatever the form of the score: e(C) {per_form}.\n")
    return "".join(lines)


def seeds_table(entries, results):
    head = ["set", "seeds", "K = 0: covers, on the rim", "K = 100: covers, worst (mean)", "on the rim, worst (mean)",
            "best path: covers, on the rim", "as it came"]
    rows = []
    for e in entries:
        form = results[e.name]["forms"]["capped"]
        runs, unbred, path = form["runs"], form["K0"][0], form["paths"]["fittest"]
        if not has_truth(results[e.name]) or worst(runs, "covers") is None:
            continue
        came = sum(r["from"] == "fittest chromosome" for r in runs)
        rows.append([e.name, str(len(runs)), f"{share(unbred.get('covers'))}, {share(unbred.get('on_rim'))}",
                     f"{share(worst(runs, 'covers'))} ({share(mean(runs, 'covers'))})",
                     f"{share(worst(runs, 'on_rim'))} ({share(mean(runs, 'on_rim'))})",
                     f"{share(path['covers'])}, {share(path['on_rim'])}", f"{came} of {len(runs)}"])
    return head, rows


def caps_table(entries, results):
    columns = CAPS + ["printed", "log"]
    rows = [[e.name] + [f"{results[e.name]['plateau'][c]:.2f}" for c in columns] for e in entries if
            has_truth(results[e.name])]
    return ["set"] + columns, rows


def forms_table(entries, results):
    rows = []
    for e in entries:
        if not has_truth(results[e.name]):
            continue
        row = [e.name]
        for form in ("printed", "capped", "log"):
            runs = results[e.name]["forms"][form]["runs"][:3]
            row.append(f"{share(worst(runs, 'covers'))}, {share(worst(runs, 'on_rim'))}")
        rows.append(row)
    return ["set", "`--score-form printed`", "`capped`", "`log`"], rows


def theory_table(entries, results):
    rows = []
    for e in entries:
        t = results[e.name].get("theory")
        if t:
            rows.append([e.name, f"{t['rim_points']:,}", share(t["recall"]), share(t["empty_sector"]), f"{t['delta']:.2g}",
                         f"{t['R']:.2f}", number(t["r"])])
    return ["set", "true boundary points", "detected", "with an empty sector", "delta", "R", "r"], rows


def undersampling_table(entries, results):
    rows = []
    for e in entries:
        u = results[e.name].get("undersampling")
        if u:
            rows.append([e.name, f"{u['undersampled']:,}", share(u["on_creases"]), share(u["creases"]), share(u["found"])])
    return ["set", "undersampled", "of them at creases", "of all at creases", "crease points that are candidates"], rows


def windows_table(entries, results):
    rows = []
    for e in entries:
        w = results[e.name].get("windows")
        if w and w["holes"]:
            rows.append([e.name, str(w["holes"]), str(w["filled"]), str(w["euler"]), str(w["loops"]),
                         f"{w['long_edges']:,} of {w['triangles']:,} triangles"])
    return ["set", "true holes", "filled", "Euler number", "loops of the mesh", "edges longer than 3 spacings"], rows


def variants_table(entries, results):
    named = [e for e in entries if results[e.name].get("variants")]
    if not named:
        return [], []
    rows = []
    for variant in results[named[0].name]["variants"]:
        row = [variant]
        for e in named:
            v = results[e.name]["variants"][variant]
            covers = worst(v["runs"], "covers")
            flags = f"{v['flags']:,}: " if v["flags"] else ""
            row.append(flags + (share(covers) if has_truth(results[e.name]) else
                                f"{sum(is_base_rim(r['box']) for r in v['runs'] if 'box' in r)} of {len(v['runs'])}"))
        rows.append(row)
    return ["change"] + [e.name for e in named], rows
