"""The point sets of the paper's experiments: what figures 3, 4 and 5 show, and what stands for it here."""
from dataclasses import dataclass, field


@dataclass
class Entry:
    name: str                 # of the set
    figures: str = ""         # where the paper shows it
    caption: str = ""         # under which name
    what: str = ""            # of the two: found, or a stand-in and why
    expected: str = ""        # what the picture in the paper shows
    differs: str = ""         # why ours is another one, where it is
    path_k: int = 40
    seeds: int = 10
    variants: bool = True
    windows: bool = False
    picture: bool = True
    pixels: int = 230
    up: str = ""
    sample: list = field(default_factory=list)
    fetched: bool = False


# Named in figures 4 and 5, and not to be had by name from any source that states where it comes from.
NOT_FOUND = [("4 (b), 5 (d)", "Spock"), ("5 (f)", "Male 2"), ("5 (g)", "Monkey"), ("5 (h)", "Balljoint"),
             ("5 (i)", "Sofa")]

# Sets of a data folder (RIMLINE_DATA).
DATA = [
    Entry("mannequin", "3, 4 (a), 5 (a)", "Mannequin", "stand-in: the same head, not the same points; denser at the ears, eyes and mouth",
          "the neck", windows=True),
    Entry("mannequin_uniform", "3", "Mannequin", "stand-in: the same head, evenly sampled", "the neck"),
    Entry("mannequin_nonuniform", "3", "Mannequin, second set", "stand-in: the same head, denser at the features, as "
          "section 2.5 tells of the second set", "the neck"),
    Entry("mannequin_noisy", "", "", "mannequin_uniform with noise of a quarter of the spacing", "", picture=False),
    Entry("mannequin_devil", "3", "Mannequin, second set", "stand-in: a mannequin with horns, its spacings 34 : 1", "the neck",
          "a border of densities has the higher e(C); see below"),
    Entry("distcap", "4 (c)", "Distcap", "found: the same set", "the base rim", pixels=210),
    Entry("isis_front", "4 (d), 5 (c)", "Isis", "stand-in: the same statue, decimated, its front half", "the rim of the cut", variants=False),
    Entry("isis_open", "4 (d), 5 (c)", "Isis", "stand-in: the same statue, decimated, cut open below", "the rim below", variants=False),
    Entry("beetle", "4 (e)", "Nascar", "stand-in: a car body with open windows", "the outer rim, windows filled",
          "the true outline runs into slits between panels that are narrower than the neighbourhoods",
          windows=True, variants=False, seeds=3),
    Entry("head", "4 (f), 5 (e)", "Male", "stand-in: a male head", "the neck"),
    Entry("teapot", "4 (g)", "Teapot", "found: Newell's teapot, not known to be the same points", "a rim",
          "differs: no rim (the pot's and the lid's have rows on either side) but a whole row of the lid about its knob, where rows "
          "of 32 points end and rows of 16 begin: a border of densities", path_k=10, variants=False),
    Entry("seahorse_side", "5 (b)", "Seahorse", "stand-in: a seahorse, not known to be the same, cut in half",
          "the outline", "spines and narrow necks are as wide as the neighbourhoods, so that paths cut them off",
          variants=False),
    Entry("camelhead", "", "", "a camel's head, open at the neck", "", picture=False),
    Entry("bump_domain", "", "", "a flat square", "", picture=False),
    Entry("halftunnel", "", "", "rows of a half tunnel with two holes", "", windows=True, picture=False, variants=False),
    Entry("st_helens", "", "", "terrain on a grid, its outline oblique", "", picture=False, variants=False, seeds=3),
]

# What any Debian 12 has: the scan of scripts/fetch-scan, and built-in samples.
ANYWHERE = [
    Entry("debian_mannequin", "3", "Mannequin, second set", "stand-in: Debian's libcgal-demo; the points of mannequin_devil", "",
          "a border of densities has the higher e(C)", fetched=True, variants=False, seeds=3),
    Entry("bowl", "4 (a)", "", "stand-in: `hemisphere-cap -n 6000`, open at one side as a head is at the neck", "its rim",
          sample=["hemisphere-cap", "-n", "6000"]),
    Entry("bowl-density-step", "3", "", "stand-in: the same with `--sampling density-step`", "its rim",
          "the border of densities meets the rim, and the cheapest way turns off along it",
          sample=["hemisphere-cap", "-n", "6000", "--sampling", "density-step"]),
    Entry("bowl-random", "", "", "the same with `--sampling random`", "",
          sample=["hemisphere-cap", "-n", "6000", "--sampling", "random"], picture=False),
    Entry("windows", "4 (e)", "", "stand-in: `square-with-holes -n 6000`, a sheet with windows", "the outer rim, 0.61 of all true rims",
          sample=["square-with-holes", "-n", "6000"], variants=False),
    Entry("tunnel", "4 (c)", "", "stand-in: `half-tunnel -n 4000`", "its rim", sample=["half-tunnel", "-n", "4000"], variants=False),
]
