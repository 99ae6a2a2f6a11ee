"""Pages for the JSON schemas: a section for each object, a row for each key with its type and description."""
import json
import re

LIMITS = {"minimum": ">=", "maximum": "<=", "exclusiveMinimum": ">", "exclusiveMaximum": "<"}


def escaped(text):
    return text.replace("|", "\\|").replace("<", "&lt;").replace("\n", " ")


def anchor(path):
    return re.sub(r"\W+", "-", path).strip("-")


class Schema:
    def __init__(self, text):
        self.root = json.loads(text)
        self.sections = {}  # title: rows

    def resolved(self, schema):
        """A schema merged with what it refers to; its own entries win."""
        if not isinstance(schema, dict) or "$ref" not in schema:
            return schema if isinstance(schema, dict) else {}
        target = self.root
        for step in schema["$ref"].removeprefix("#/").split("/"):
            target = target[step]
        return {**self.resolved(target), **{key: value for key, value in schema.items() if key != "$ref"}}

    def parts(self, schema, words=("allOf", "oneOf", "anyOf", "then")):
        """A schema and its allOf, anyOf and oneOf alternatives."""
        schema = self.resolved(schema)
        yield schema
        for word in words:
            inner = schema.get(word, [])
            for part in inner if isinstance(inner, list) else [inner]:
                yield from self.parts(part, words)

    def type_of(self, schema):
        schema = self.resolved(schema)
        if "const" in schema:
            return f"`{json.dumps(schema['const'])}`"
        if "enum" in schema:
            return ", ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
        kinds = schema.get("type", [])
        kinds = [kinds] if isinstance(kinds, str) else list(kinds)
        for word in ("oneOf", "anyOf"):
            kinds += [self.type_of(part) for part in schema.get(word, [])]
        if "items" in schema:
            held = f"array of {self.type_of(schema['items']) or 'object'}"
            kinds = [held if kind == "array" else kind for kind in kinds]
        limits = [f"{sign} {schema[word]}" for word, sign in LIMITS.items() if word in schema]
        return ", ".join([" or ".join(dict.fromkeys(kind for kind in kinds if kind)), *limits]).strip(", ")

    def walk(self, schema, path):
        """Adds the section of an object and of the objects inside it."""
        rows, inner = {}, []
        parts = list(self.parts(schema))
        required = {key for part in self.parts(schema, ("allOf",)) for key in part.get("required", [])}
        for part in parts:
            for key, value in part.get("properties", {}).items():
                if not isinstance(value, dict) or not value or (key in rows and "const" in value):
                    continue
                if key in rows and not self.resolved(value).get("description"):
                    continue
                says = escaped(self.resolved(value).get("description", ""))
                rows[key] = (key in required, escaped(self.type_of(value)), says)
                inner.append((key, value))
        if rows:
            self.sections[path] = rows
        for key, value in inner:
            self.enter(value, f"{path}.{key}" if path else key)
        for part in parts:
            if isinstance(part.get("additionalProperties"), dict):
                self.enter(part["additionalProperties"], f"{path}.NAME" if path else "NAME")

    def enter(self, schema, path):
        for part in list(self.parts(schema)):
            if "properties" in part or isinstance(part.get("additionalProperties"), dict):
                self.walk(schema, path)
                return
        for part in self.parts(schema):
            if "items" in part:
                self.enter(part["items"], f"{path}[]")

    def page(self, file):
        self.walk(self.root, "")
        said = self.root.get("description", "")
        parts = [f"# {self.root['title']}", said, f"From the schema [{file}]({file}). Keys that are required are bold."]
        for path, rows in self.sections.items():
            parts.append(f"## `{path}` {{#{anchor(path)}}}" if path else "## The whole")
            lines = ["| key | type | says |", "|---|---|---|"]
            for key, (is_required, kind, says) in rows.items():
                name = f"**`{key}`**" if is_required else f"`{key}`"
                inner = f"{path}.{key}" if path else key
                deeper = next((each for each in (inner, f"{inner}[]", f"{inner}[][]", f"{inner}.NAME")
                               if each in self.sections), None)
                kind = kind.replace("object", f"[object](#{anchor(deeper)})") if deeper else kind
                lines.append(f"| {name} | {kind} | {says} |")
            parts.append("\n".join(lines))
        return "\n\n".join(part for part in parts if part) + "\n"


def write_pages(docs, out):
    """Writes a page for each schema in the folder `docs` to `out`. Returns [{title: page}] for the navigation."""
    entries = []
    for file in sorted(docs.glob("*.schema.json")):
        name = file.name.removesuffix(".json").replace(".", "-") + ".md"
        (out / name).write_text(Schema(file.read_text()).page(file.name))
        entries.append({f"JSON of {re.sub(r'[.]schema[.]json$', '', file.name)}": name})
    return entries
