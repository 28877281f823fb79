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
