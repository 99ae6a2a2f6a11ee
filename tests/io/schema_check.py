#!/usr/bin/env python3
"""schema_check.py ROOT KIND: tests that docs/KIND.schema.json accepts the example and the sound cases of KIND_cases.json,
and refuses the others. Exits with 77 if python3-jsonschema is missing."""
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is absent")
    sys.exit(77)

root, kind = pathlib.Path(sys.argv[1]), sys.argv[2]
schema = json.loads((root / f"docs/{kind}.schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
cases = json.loads((root / f"tests/data/{kind}_cases.json").read_text())
cases.append({"what": "the example", "sound": True, kind: json.loads((root / f"docs/{kind}.example.json").read_text())})
wrong = [case["what"] for case in cases if validator.is_valid(case[kind]) != case["sound"]]
print(f"{len(cases)} cases; judged wrongly: {wrong}")
sys.exit(1 if wrong else 0)
