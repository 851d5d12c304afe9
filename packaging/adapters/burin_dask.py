#!/usr/bin/env python3
"""A batch of studies through Dask distributed.

    burin_dask.py RECIPE.json --studies LIST.csv --into FOLDER --scheduler tcp://HOST:8786
    burin_dask.py RECIPE.json --studies LIST.csv --into FOLDER --workers 4    # on this machine

Each study is one task, `burin batch --only NAME`, with FOLDER on a file system that all workers see.
When a worker is lost, Dask gives its study to another one, which waits if the first is still at it,
and does nothing if the record says that it is finished. Ends with 1 if any study failed.
"""
import argparse
import json
import subprocess
import sys
import tempfile

from distributed import Client, LocalCluster, as_completed


def do_study(words, name):
    """Runs on a worker. Returns the exit status and what Burin says of a failure."""
    done = subprocess.run(words + ["--only", name], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return done.returncode, done.stderr.decode("utf-8", "replace").strip()


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("recipe")
    parser.add_argument("--studies", required=True)
    parser.add_argument("--into", required=True)
    parser.add_argument("--burin", default="burin", help="the program, as workers find it")
    parser.add_argument("--attempts", type=int, default=0, help="--retries of burin batch")
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--scheduler", help="the address of a Dask scheduler")
    where.add_argument("--workers", type=int, help="how many workers to start on this machine")
    return parser.parse_args()


def run(client, words, attempts):
    listed = subprocess.run(words + ["--list"], check=True, stdout=subprocess.PIPE, text=True)
    names = [json.loads(line)["name"] for line in listed.stdout.splitlines()]
    # Not pure: what a study's task did is in files, not in its result. Not all at one worker.
    futures = {client.submit(do_study, words + ["--retries", str(attempts)], name, pure=False,
                             retries=3): name for name in names}
    failed = 0
    for future in as_completed(list(futures)):
        try:
            status, said = future.result()
        except Exception as problem:  # the worker was lost too often, or the program is not there
            status, said = 1, str(problem)
        if status != 0:
            failed += 1
            print(f"{futures[future]}: {said or 'status ' + str(status)}", file=sys.stderr)
    table = subprocess.run(words + ["--table"], check=False).returncode
    return 1 if failed or table != 0 else 0


def main():
    asked = parse()
    words = [asked.burin, "batch", asked.recipe, "--studies", asked.studies, "--into", asked.into]
    if asked.scheduler:
        with Client(asked.scheduler) as client:
            return run(client, words, asked.attempts)
    # Workers would leave their scratch files in the current folder.
    with tempfile.TemporaryDirectory() as scratch, \
            LocalCluster(n_workers=asked.workers, threads_per_worker=1, processes=True,
                         dashboard_address=None, local_directory=scratch) as cluster, \
            Client(cluster) as client:
        return run(client, words, asked.attempts)


if __name__ == "__main__":
    sys.exit(main())
