"""Runs a program until it ends or hangs: watched.py SECONDS PROGRAM ARGUMENT…

Prints what became of it as JSON. A process begins with the memory of the one that it was forked
from, which must be a small one to tell anything.
"""
import json
import resource
import subprocess
import sys

process = subprocess.Popen(sys.argv[2:], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
hung = False
try:
    out, errors = process.communicate(timeout=float(sys.argv[1]))
except subprocess.TimeoutExpired:
    hung = True
    process.kill()
    out, errors = process.communicate()
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(json.dumps({"hung": hung, "status": max(-1, process.returncode), "kb": used.ru_maxrss,
                  "seconds": used.ru_utime + used.ru_stime,
                  "out": out.decode(errors="replace"),
                  "errors": errors.decode(errors="replace")}))
