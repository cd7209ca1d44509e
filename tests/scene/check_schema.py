#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the JSON Schema of scenes to the reader: same good scenes, same bad ones.

usage: check_schema.py TEST_SCENE   (the test program, which writes the schema and the cases)
"""
import datetime
import json
import os
import subprocess
import sys
import tempfile
import tomllib

import jsonschema


def written_cases(program):
    """Lets the test program write its schema and cases, and reads them."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "cases.json")
        subprocess.run(
            [program, "--gtest_filter=Schema.IsWrittenForTheValidator"],
            env=dict(os.environ, POLHODE_SCHEMA_CASES=file),
            check=True,
            stdout=subprocess.DEVNULL,
        )
        with open(file, encoding="utf-8") as text:
            return json.load(text)


def parsed(text):
    """A scene text as an editor's plug-in sees it; dates become text, as JSON has none."""
    tree = tomllib.loads(text.removeprefix("\ufeff"))
    return json.loads(json.dumps(tree, default=lambda date: datetime.date.isoformat(date)))


def main():
    cases = written_cases(sys.argv[1])
    jsonschema.Draft202012Validator.check_schema(cases["schema"])
    validator = jsonschema.Draft202012Validator(cases["schema"])
    failures = []
    for case in cases["good"]:
        for form, tree in (("text", parsed(case["text"])), ("canonical form", case["canonical"])):
            for error in validator.iter_errors(tree):
                failures.append(f"good scene '{case['name']}' ({form}): {error.json_path}: {error.message}")
    for case in cases["bad"]:
        if validator.is_valid(parsed(case["text"])):
            failures.append(f"bad scene '{case['name']}' passes")
    print("\n".join(failures) or f"{len(cases['good'])} good and {len(cases['bad'])} bad scenes agree")
    return 1 if failures or not cases["good"] or not cases["bad"] else 0


sys.exit(main())
