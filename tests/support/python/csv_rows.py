# SPDX-License-Identifier: Apache-2.0
"""The rows of a CSV file as a JSON list of objects, by Python's own reader.

usage: csv_rows.py FILE
"""
import csv
import json
import sys

with open(sys.argv[1], newline="", encoding="utf-8") as file:
    print(json.dumps(list(csv.DictReader(file))))
