#!/usr/bin/env python3
"""docs/project.schema.json accepts the example and the sound projects of project_cases.json, and refuses the others.
Exits with 77 where python3-jsonschema is absent."""
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is absent")
    sys.exit(77)

root = pathlib.Path(sys.argv[1])
schema = json.loads((root / "docs/project.schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
cases = json.loads((root / "tests/data/project_cases.json").read_text())
cases.append({"what": "the example", "sound": True, "project": json.loads((root / "docs/project.example.json").read_text())})
wrong = [case["what"] for case in cases if validator.is_valid(case["project"]) != case["sound"]]
print(f"{len(cases)} projects; judged wrongly: {wrong}")
sys.exit(1 if wrong else 0)
