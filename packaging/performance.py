#!/usr/bin/env python3
"""Writes the page of the manual that says how fast Burin is, from the figures of burin_bench.

    performance.py FIGURES.json GRAPHICS.txt > performance.md

FIGURES.json is the output of `burin_bench --json`, GRAPHICS.txt that of `burin info --gl` on the
same machine. packaging/bench.sh --performance does all of it.
"""
import json
import platform
import re
import sys

# Work that has a goal: the figures that tell of it, what it is, and its goal, which is a ratio to a
# peer (of a figure that has several, the one that is named) or milliseconds.
AT_LEAST = "at least {} times as fast"
AT_MOST = "at most {:g} ms"
NO_MORE = "no more than that"
GOALS = [
    (r"frame\.(surface|dvr)", "VTK GPU mapper", "picture at full quality", AT_LEAST, 20),
    (r"frame\.mip", "VTK GPU mapper", "picture at full quality", AT_LEAST, 6),
    (r"frame\.(surface|dvr|mip)", "VTK fixed-point mapper", "picture at full quality", AT_LEAST, 2),
    (r"frame\.\w+\.opened", "before the cut", "the same, carved", AT_LEAST, 1 / 1.2),
    (r"frame\.\w+\.pieces", "no pieces", "the same, with four pieces", AT_LEAST, 1 / 1.2),
    (r"frame\.moving\..*", None, "moving picture", AT_MOST, 1000 / 15),
    (r"frame\.settled\..*dvr", None, "volume rendering after letting go", AT_MOST, 5000),
    (r"grow\.(ball|cube|cylinder)\w*", "ITK ConnectedThreshold", "growth of a shape", AT_LEAST, 3),
    (r"grow\.(closure|skull|abdomen|brain)", "ITK ConnectedThreshold", "growth in a study",
     AT_LEAST, 1),
    (r"steer\.slider", None,
     "an event of the interval slider, 10 million voxels, without the picture", AT_MOST, 100),
    (r"steer\.slider\.picture", None, "the same, to the first picture", AT_MOST, 100),
    (r"steer\.recovery", None, "recovering what was suspended around them", AT_MOST, 100),
    (r"steer\.generation\.512", "128 cubed", "a generation in 512 cubed", AT_LEAST, 1 / 1.2),
    (r"steer\.sketch", None, "sketch of seeds", AT_MOST, 6),
    (r"sculpt\.\w+\.(256|512)", "128 cubed", "a tick of a stroke", AT_LEAST, 1 / 1.2),
    (r"sculpt\.\w+\.512", "whole volume", "a tick of a stroke", AT_LEAST, 20),
    (r"mask\.lasso", None, "making a mask", AT_MOST, 5),
    (r"history\.drill\.undo", None, "undo of a drill stroke, without the picture", AT_MOST, 16),
    (r"history\.drill\.(undo|redo)\.picture", None, "undo of a drill stroke, to the 3D picture",
     AT_MOST, 1000 / 15),
    (r"refine\.chunks\.click", None, "click on a chunk, without the pictures", AT_MOST, 50),
    (r"refine\.chunks\.click\.picture", None, "click on a chunk, to the pictures of all views",
     AT_MOST, 50),
    (r"refine\.step\..*", None, "step of a deformation", AT_LEAST, 10),
    (r"segment\.large\..*\.picture", None,
     "margin or smoothing in 512 × 512 × 400, to the first pictures", AT_MOST, 1000),
    (r"segment\.large\.\w+\.margin", "ITK SignedMaurerDistanceMap",
     "the whole of a margin in 512 × 512 × 400", AT_LEAST, 1),
    (r"plane\.(linear|cubic)", "vtkImageReslice + vtkCutter", "oblique plane with contour",
     AT_LEAST, 10),
    (r"memory\.segments", None, "memory of 512 cubed with 20 segments", NO_MORE, 1),
    (r"load\.\w+\.warm", None, "450 slices, warm", AT_LEAST, 2),
    (r"load\.window\.longestStall", None, "the window while they open", AT_MOST, 50),
]


def fits(goal, figure):
    """Whether a goal is one of this figure: of the same work, kind of figure and peer."""
    pattern, peer, _, kind, _ = goal
    if not re.fullmatch(pattern, figure["id"]):
        return False
    if kind is AT_MOST:
        return "oursMs" in figure
    return "ratio" in figure and peer in (None, figure["peer"])


def is_met(goal, figure):
    _, _, _, kind, bound = goal
    return figure["oursMs"] <= bound if kind is AT_MOST else figure["ratio"] >= bound


def number(value):
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def cells(figure):
    """What was measured, of Burin and of the peer."""
    unit = next(key[4:] for key in figure if key.startswith("ours"))
    name = {"Ms": "ms"}.get(unit, unit.lower())
    ours = f"{number(figure['ours' + unit])} {name}"
    if "peer" not in figure:
        return [ours, "", ""]
    theirs = f"{figure['peer']}: {number(figure['peer' + unit])} {name}"
    return [ours, theirs, f"{figure['ratio']:.2f}"]


def row(*words):
    return "| " + " | ".join(words) + " |"


def machine():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            text = file.read()
        models = re.findall(r"^model name\s*: (.*)$", text, re.MULTILINE)
        with open("/proc/meminfo", encoding="utf-8") as file:
            kibibytes = int(re.search(r"MemTotal:\s*(\d+)", file.read()).group(1))
    except (OSError, AttributeError):
        return platform.machine()
    model = models[0] if models else platform.machine()
    return f"{len(models) or 1} × {model}, {kibibytes / 2**20:.0f} GiB of memory"


def page(figures, graphics):
    driver = dict(re.findall(r"^(GL_\w+)\s+(.*)$", graphics, re.MULTILINE))
    lines = ["# How fast it is", "",
             "Written by `packaging/bench.sh --performance`; all figures are medians of one run, "
             "and nothing was timed before the results were found equal.", "",
             f"- machine: {machine()}",
             f"- graphics: {driver.get('GL_RENDERER', 'unknown')}, OpenGL "
             f"{driver.get('GL_VERSION', 'unknown')}", "",
             "## Goals", "",
             row("work", "figure", "Burin", "peer", "ratio", "goal", "met"),
             row(*["---"] * 7)]
    known = set()
    absent = []
    for goal in GOALS:
        _, _, work, kind, bound = goal
        found = [(i, figure) for i, figure in enumerate(figures) if fits(goal, figure)]
        if not found:
            absent.append(f"{work}: `{goal[0]}`" + (f", {goal[1]}" if goal[1] else ""))
        for i, figure in found:
            known.add(i)
            lines.append(row(work, f"`{figure['id']}`", *cells(figure),
                             kind.format(round(bound, 2)), "yes" if is_met(goal, figure) else "no"))
    if absent:
        lines += ["", "Not measured in this run:", ""]
        lines += [f"- {work}" for work in absent]
    others = [figure for i, figure in enumerate(figures) if i not in known]
    if others:
        lines += ["", "## Other figures", "", row("figure", "Burin", "peer", "ratio"),
                  row(*["---"] * 4)]
        lines += [row(f"`{figure['id']}`", *cells(figure)) for figure in others]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: performance.py FIGURES.json GRAPHICS.txt")
    with open(sys.argv[1], encoding="utf-8") as file:
        figures = json.load(file)
    with open(sys.argv[2], encoding="utf-8") as file:
        graphics = file.read()
    sys.stdout.write(page(figures, graphics))


if __name__ == "__main__":
    main()
