"""The schemas of docs/schema, each with the definitions that it refers to."""

import json

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


def strict(schema):
    """The schema, whose objects may have no other keys than those it names."""
    wider = {node["$ref"] for node in within(schema) if type(node) is dict and {"$ref", "properties"} <= node.keys()}  # definitions with more keys there

    def closed(node, place):
        if type(node) is list:
            return [closed(one, None) for one in node]
        if type(node) is not dict:
            return node
        out = {key: closed(one, f"{place}/{key}" if place else None) for key, one in node.items()}
        whole = {"type", "$ref"} & node.keys() and not {"additionalProperties", "patternProperties"} & node.keys()  # no condition on another
        if whole and type(node.get("properties")) is dict and place not in wider:
            out["unevaluatedProperties"] = False
        return out
    return closed(schema, "#")


def strict_validators(source):
    """For records that Skyway itself writes: all of their keys stand in the schemas."""
    return {kind: jsonschema.Draft202012Validator(strict(one.schema)) for kind, one in validators(source).items()}
