"""The schemas of docs/schema, each with the definitions that it refers to."""

import json
import re

import jsonschema

SHARED = "definitions.schema.json"


def definitions(source):
    return json.loads((source / "docs/schema" / SHARED).read_text(encoding="utf-8"))["$defs"]


def written(source):
    """Each schema as its file has it, by the kind of its records."""
    files = sorted(path for path in (source / "docs/schema").glob("*.schema.json") if path.name != SHARED)
    return {path.name.split(".")[0]: json.loads(path.read_text(encoding="utf-8")) for path in files}


def validators(source):
    """Of each kind of records. The definitions are put into the schema, so that any version of jsonschema finds them."""
    out = {}
    for kind, schema in written(source).items():
        whole = json.loads(json.dumps(schema).replace(f'"{SHARED}#/', '"#/'))
        whole["$defs"] = definitions(source) | whole.get("$defs", {})
        jsonschema.Draft202012Validator.check_schema(whole)
        out[kind] = jsonschema.Draft202012Validator(whole)
    return out


def within(node):
    """The node and all that it holds."""
    yield node
    for inner in node.values() if type(node) is dict else node if type(node) is list else ():
        yield from within(inner)


def unknown_keys(schema, record):
    """The keys of a record that Skyway itself writes which its schema does not name, as places. An object of which the schema names no key may
    have any. A branch counts even if its condition does not hold. jsonschema checks the values, but not every version of it can check the keys."""
    def parts(node):
        if type(node) is not dict:
            return
        yield node
        inner = [schema["$defs"][node["$ref"].removeprefix("#/$defs/")]] if "$ref" in node else []
        inner += [one for word in ("allOf", "anyOf", "oneOf") for one in node.get(word, ())]
        inner += [node[word] for word in ("then", "else") if word in node]
        for one in inner:
            yield from parts(one)

    def look(nodes, value, place):
        known = [part for node in nodes for part in parts(node)]
        if type(value) is list:
            for i, one in enumerate(value):
                first = [part["prefixItems"][i] for part in known if i < len(part.get("prefixItems", ()))]
                yield from look(first or [part["items"] for part in known if "items" in part], one, f"{place}[{i}]")
        if type(value) is not dict:
            return
        for key, one in value.items():
            named = [part["properties"][key] for part in known if key in part.get("properties", ())]
            named += [inner for part in known for pattern, inner in part.get("patternProperties", {}).items() if re.search(pattern, key)]
            named = named or [part["additionalProperties"] for part in known if type(part.get("additionalProperties")) is dict]
            if not named and any("properties" in part for part in known):
                yield f"{place}.{key}"
            yield from look(named, one, f"{place}.{key}")
    return list(look([schema], record, record.get("type", "")))
