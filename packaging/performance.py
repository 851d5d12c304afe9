#!/usr/bin/env python3
"""Writes the page of the manual that says how fast Burin is, from the figures of burin_bench.

    performance.py FIGURES.json GRAPHICS.txt [--pacing PACING.json] [--profile PROFILE.json]
                   [--tried TRIED.json] > performance.md

FIGURES.json is the output of `burin_bench --json`, GRAPHICS.txt that of `burin info --gl` on the
same machine, PACING.json that of `burin_pacing` (its picture must lie beside the page as
frame-pacing.png), and PROFILE.json what `burin_bench --profile` has written. TRIED.json says what was
tried for rows that miss their goals: lists of sentences by the figure's name, in which * stands for
anything. packaging/bench.sh --performance does all of it.
"""
import argparse
import fnmatch
import json
import os
import platform
import re
import sys

TRIED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "benchmarks",
                     "tried.json")

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
    (r"refine\.chunks\.large", None, "division of 17 million voxels into chunks", AT_MOST, 5000),
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
    (r"pacing\.(orbit|drill|grow|scrub|undo)", None, "between pictures of a scripted minute, median",
     AT_MOST, 1000 / 15),
    (r"pacing\.longestStall", None, "the window in a scripted minute", AT_MOST, 50),
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


def bytes_text(count):
    for unit, size in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if count >= size:
            return f"{number(count / size)} {unit}"
    return f"{count:.0f} bytes"


def pass_table(profiled):
    """The passes of a row by their share, and what of its time none of them explains."""
    turn = profiled["milliseconds"]
    passes = sorted(profiled["passes"], key=lambda one: -one["milliseconds"])
    drawn = sum(one["milliseconds"] for one in passes if one["kind"] == "gpu")
    lines = [row("where the time goes", "ms of a turn", "share"), row(*["---"] * 3)]
    shown = [one for one in passes if one["milliseconds"] >= 0.01 * turn][:10]
    for one in shown:
        kind = "kernel or draw" if one["kind"] == "gpu" else "task beside it"
        name = one["name"].replace("|", "/")
        name = name if len(name) <= 60 else name[:59] + "…"
        lines.append(row(f"{kind} `{name}`", number(one["milliseconds"]),
                         f"{100 * one['milliseconds'] / turn:.0f} %"))
    rest = sum(one["milliseconds"] for one in passes if one["kind"] == "gpu" and one not in shown)
    if rest >= 0.005 * turn:
        lines.append(row("other kernels and draws", number(rest), f"{100 * rest / turn:.0f} %"))
    without = max(0.0, turn - drawn)
    lines.append(row("no kernel or draw: the processor works, fetches or waits", number(without),
                     f"{100 * without / turn:.0f} %"))
    return lines


def bound(profiled, triad):
    """What a row moves by estimate, against what memory would move in that time."""
    if not profiled["bytes"] or not triad:
        return []
    speed = profiled["bytes"] / (profiled["milliseconds"] / 1000)
    share = 100 * speed / triad
    verdict = ("memory is what bounds it" if share >= 50 else
               "memory bounds it in part" if share >= 20 else "these bytes are not what bounds it")
    return ["", f"It moves about {bytes_text(profiled['bytes'])} ({profiled['moved']}): "
            f"{bytes_text(speed)} a second, {number(share)} % of what memory moves, so {verdict}."]


def missed_rows(missed, profile, tried):
    """A section for each figure that misses its goal: where its time goes, and what was tried."""
    if not missed or not profile:
        return []
    triad = profile["triadBytesPerSecond"]
    told = {}  # where the sentences of a pattern stand
    profiled = {one["id"]: one for one in profile["rows"]}
    lines = ["", "## Rows that miss their goals", "",
             "From a run of its own with the program's trace (`burin open --trace` writes the same "
             "one), whose stamps cost time: turns are longer than in the table above, shares are what "
             f"counts. Memory moved {bytes_text(triad)} a second (*a = b + s · c* on all "
             f"processors; a copy {bytes_text(profile['copyBytesPerSecond'])}). What a row "
             "moves is an estimate, no counter: its input read once and its output written once. It "
             "is less where cells are skipped, and more where caches do not hold what is read "
             "again."]
    for name, words in missed.items():
        lines += ["", f"### `{name}`", "", "; ".join(words) + ".", ""]
        one = profiled.get(name)
        if one:
            lines += [f"A turn took {number(one['milliseconds'])} ms (mean of {one['turns']}).", ""]
            lines += pass_table(one) + bound(one, triad)
        elif name.startswith("pacing."):
            lines.append("See *A minute in the window*.")
        else:
            lines.append("Not profiled.")
        for pattern, sentences in tried.items():
            if not fnmatch.fnmatchcase(name, pattern):
                continue
            if pattern in told:
                lines += ["", f"- tried: see `{told[pattern]}`"]
                continue
            told[pattern] = name
            lines += [""] + [f"- tried: {sentence}" for sentence in sentences]
    return lines


def pacing_part(pacing):
    if not pacing:
        return []
    longest = pacing["longest"]
    event = f" (*{longest['event']}*, {number(longest['eventMs'])} ms)" if longest["event"] else ""
    return ["", "## A minute in the window", "",
            "A hand that works by a script, on a real CT, twelve seconds each: it orbits, drills, "
            "grows step by step, scrubs through slices, undoes and redoes. A new step is asked for "
            "when the one before is seen, 30 times a second at most; the mouse moves 60 times a "
            f"second. Longest stall of the window: {number(longest['ms'])} ms, in the part "
            f"*{longest['phase'] or 'end'}*{event}.", "",
            "![Milliseconds between pictures over a minute of orbiting, drilling, growing, scrubbing "
            "and undoing](frame-pacing.png)"]


def page(figures, graphics, pacing=None, profile=None, tried=None):
    if pacing:
        figures = figures + pacing["figures"]
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
    missed = {}
    for goal in GOALS:
        _, _, work, kind, bound_of_goal = goal
        found = [(i, figure) for i, figure in enumerate(figures) if fits(goal, figure)]
        if not found:
            absent.append(f"{work}: `{goal[0]}`" + (f", {goal[1]}" if goal[1] else ""))
        for i, figure in found:
            known.add(i)
            words = kind.format(round(bound_of_goal, 2))
            met = is_met(goal, figure)
            lines.append(row(work, f"`{figure['id']}`", *cells(figure), words,
                             "yes" if met else "no"))
            if not met:
                ours, theirs, ratio = cells(figure)
                beside = f" ({theirs}, {ratio})" if theirs else ""
                missed.setdefault(figure["id"], []).append(f"{ours}{beside}, goal: {words}")
    if absent:
        lines += ["", "Not measured in this run:", ""]
        lines += [f"- {work}" for work in absent]
    lines += pacing_part(pacing)
    lines += missed_rows(missed, profile, tried or {})
    others = [figure for i, figure in enumerate(figures) if i not in known]
    if others:
        lines += ["", "## Other figures", "", row("figure", "Burin", "peer", "ratio"),
                  row(*["---"] * 4)]
        lines += [row(f"`{figure['id']}`", *cells(figure)) for figure in others]
    return "\n".join(lines) + "\n"


def read_json(name):
    if not name:
        return None
    with open(name, encoding="utf-8") as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser(description="Writes the page of the manual on speed.")
    parser.add_argument("figures")
    parser.add_argument("graphics")
    parser.add_argument("--pacing")
    parser.add_argument("--profile")
    parser.add_argument("--tried", default=TRIED)
    options = parser.parse_args()
    with open(options.graphics, encoding="utf-8") as file:
        graphics = file.read()
    sys.stdout.write(page(read_json(options.figures), graphics, read_json(options.pacing),
                          read_json(options.profile), read_json(options.tried)))


if __name__ == "__main__":
    main()
