"""docs/paper.md from what bench/paper/run measured. Sections that need a data folder lie between two marks, so that
a run without one leaves them as they are."""
from entries import ANYWHERE, DATA, NOT_FOUND
from sections import (caps_table, figure_row, forms_table, losers, seeds_table, theory_table, undersampling_table,
                      variants_table, windows_table)

BEGIN, END = "<!-- begin: needs RIMLINE_DATA -->", "<!-- end: needs RIMLINE_DATA -->"

INTRODUCTION = """# The paper, reproduced

Written by `bench/paper/run`, which repeats the experiments of Maes and Bultheel, *A Genetic Approach to Detect Boundaries
for Meshless Parameterization and Surface Reconstruction* (TW 384, 2004), with the preset `paper`: k = 40, r = 8,
alpha = 0.10, k = 40 in Algorithm 3.1 (10 for the teapot), K = 100, and the score 1 / max(p, 0.001). Section 3.3 says: "In our
implementation we have used an approximation of the following formula", eq. (2), and not which one. Which forms of it give
figure 4 is [measured below](#the-form-of-the-score).

*Covers* is the share of the points of the true rim that have a point of the loop within their spacing (the mean distance to
the six nearest), *on the rim* the share of the loop's points that have one of the true rim. e(C) is eq. (3).
"""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def section(title, text, head, rows):
    return f"\n## {title}\n\n{text}\n\n" + table(head, rows) if rows else ""


def figures(entries, results):
    head = ["figure", "name there", "set here", "k, r, alpha; k, K of section 3", "points", "candidates", "paths found, distinct", "best e(C), generation 0 and 100",
            "winner", "loop", "outcome"]
    return table(head, [figure_row(e, results[e.name]) for e in entries if e.figures and e.name in results])


def pictures(entries, results):
    text = ""
    for e in entries:
        if not results.get(e.name, {}).get("picture"):
            continue
        title = f"Figure {e.figures}: {e.caption or e.what}" if e.figures else e.what
        text += f"\n**{title}** ({e.name})\n\n![{e.name}](paper/{e.name}.png)\n"
    return text


def figure_3(results):
    pair = [n for n in ("mannequin_uniform", "mannequin_nonuniform") if n in results]
    if len(pair) < 2:
        return ""
    counts = [results[n]["theory"]["candidates"] for n in pair]
    return f"""
## Figure 3

The two mannequins of section 2.5: among even points the candidates are the rim ({counts[0]:,} of them, the second panel of
the first row), where densities change they are the borders too ({counts[1]:,}, the second row). The third panel is what
section 3 makes of them.

![mannequin_uniform](paper/mannequin_uniform.png)
![mannequin_nonuniform](paper/mannequin_nonuniform.png)
"""


def missing():
    names = ", ".join(f"{name} (figure {figure})" for figure, name in NOT_FOUND)
    return (f"\nNot found: {names}. No source that says what they are was found for these; \"Balljoint\" and \"Sofa\" are names "
            "of other sets, too, and nothing tells which ones these are.\n")


def part(entries, results, anywhere):
    have = {e.name: results[e.name] for e in entries if e.name in results and "error" not in results[e.name]}
    named = [e for e in entries if e.name in have]
    suffix = ", without the data folder" if anywhere else ""
    title = "What any Debian 12 has" if anywhere else "Figures 4 and 5"
    text = f"\n## {title}\n\n" + figures(named, have)
    if not anywhere:
        text += missing()
        text += losers(have)
        text += figure_3(have)
    text += f"\n### Pictures{suffix}\n\nPoints, candidates, the winning chromosome, the mesh.\n" + pictures(
        [e for e in named if anywhere or e.name not in ("mannequin_uniform", "mannequin_nonuniform")], have)
    text += section("Ten seeds" + suffix, "The worst and the mean over the seeds; K = 0 is the best path of Algorithm 3.1 that closes, "
                    "put in order. \"As it came\" counts the runs in which the fittest chromosome had a loop that closes; "
                    "in the others it is a later one or an initial path, and the run says so.", *seeds_table(named, have))
    text += section("The form of the score" + suffix, "What the fittest path of Algorithm 3.1 covers of the true rim, by the "
                    "cap c of 1 / max(p, c). From 1e-3 to 1e-6 every set of the figures has what its paths can give: that is the plateau. Above "
                    "it too many points have the same score for density borders to lose; below it, and as printed, one "
                    "corner decides. The default is 1e-3, the end of the plateau at which crossover breaks the fewest rims.",
                    *caps_table(named, have))
    text += section("The other forms" + suffix, "Loops over three seeds, worst coverage of the rim and of the loop by it.",
                    *forms_table(named, have))
    text += section("Section 2.4" + suffix, "Theorem 2.8: all boundary points are detected if r > 4 pi / (delta cos gamma R). "
                    "By Assumption 2.4 delta is below 1/2, and R, the narrowest opening at a boundary point, is at most pi: so r "
                    "must be above 8 on every surface, and r = 8 never meets the condition. *r* is what it asks for with the "
                    "least delta of the points, the least opening seen at a true boundary point, and gamma = 0.",
                    *theory_table(named, have))
    text += section("Section 6: undersampling" + suffix, "Candidates farther than a spacing from the true rim. Those that lie at a "
                    "crease (an edge of the true mesh that folds by more than 30 degrees), beside the share of all such points "
                    "that do; and how many of the points at creases are candidates.", *undersampling_table(named, have))
    text += section("Section 6: windows" + suffix, "The mesh of the paper has one loop, and fills what else is open: holes of the "
                    "true mesh that have triangles with all corners on their rims.", *windows_table(named, have))
    text += section("Robustness" + suffix, "One thing changed at a time, three seeds: flags of section 2.3 that change, then worst "
                    "coverage of the rim by the loop.", *variants_table(named, have))
    return text


def write(results, old):
    data = part(DATA, results, False) if any(e.name in results for e in DATA) else ""
    if not data and BEGIN in old:
        data = old[old.index(BEGIN) + len(BEGIN):old.index(END)].rstrip("\n") + "\n"
    return INTRODUCTION + f"\n{BEGIN}\n{data}\n{END}\n" + part(ANYWHERE, results, True)
