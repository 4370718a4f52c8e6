"""The shared library shows what the headers export, and no function beside.

usage: exports_test.py LIBRARY INCLUDES
"""
import pathlib
import re
import subprocess
import sys

library, includes = sys.argv[1], pathlib.Path(sys.argv[2])
headers = "".join(path.read_text() for path in includes.rglob("*.hpp"))
text = re.sub(r"^#.*$", "", headers, flags=re.MULTILINE)
functions = {f"taut::{name}" for name in re.findall(r"TAUT_EXPORT [\w:<>\s]*?(\w+)\(", text)}
errors = {f"typeinfo for taut::{name}" for name in re.findall(r"class TAUT_EXPORT (\w+) :", text)}
classes = {f"taut::{name}" for name in re.findall(r"class TAUT_EXPORT (\w+) {", text)}

lines = subprocess.run(["nm", "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
symbols = [line.split(maxsplit=2)[1:] for line in lines.splitlines()]
strong = {name.split("[")[0].split("(")[0] for kind, name in symbols if kind == "T" and "::" in name}
shown = {name for _, name in symbols}

members = {name for name in strong if name.rpartition("::")[0] in classes}
wrong = [f"{name} is exported, but no header says so" for name in strong - functions - members]
wrong += [f"no function of {name} is exported" for name in classes - {name.rpartition("::")[0] for name in members}]
wrong += [f"{name} is not exported" for name in (functions - strong) | (errors - shown)]
print("\n".join(wrong) or f"{len(functions)} functions and {len(errors)} errors exported")
sys.exit(1 if wrong or not functions or not errors else 0)
