"""Runs the tools of a folder, and reads and writes files of records. The folder is the first argument of the program."""

import json
import os
import subprocess
import sys


def tool(name, *arguments, codes=(0,)):
    done = subprocess.run([os.path.join(sys.argv[1], name), *arguments], capture_output=True, text=True)
    assert done.returncode in codes, (done.returncode, done.stderr)
    return done


def write(name, records):
    with open(name, "w", encoding="utf-8") as file:
        file.write("".join(json.dumps(r) + "\n" for r in records))
    return name


def read(name):
    with open(name, encoding="utf-8") as file:
        return [json.loads(line) for line in file]
