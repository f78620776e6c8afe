# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The part of JSON Schema that docs/report.schema.json uses. Any other keyword is an error, so none is ignored."""

KINDS = {
    "object": lambda v: isinstance(v, dict),
    "array": lambda v: isinstance(v, list),
    "string": lambda v: isinstance(v, str),
    "boolean": lambda v: isinstance(v, bool),
    "null": lambda v: v is None,
    "number": lambda v: isinstance(v, (int, float)) and not isinstance(v, bool),
    "integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
}
SILENT = {"$schema", "$id", "$defs", "title", "description"}


def problems(value, rules, root=None, where="report"):
    """Lines that say where `value` breaks `rules`; empty if it does not."""
    root = root or rules
    if "$ref" in rules:
        return problems(value, root["$defs"][rules["$ref"].removeprefix("#/$defs/")], root, where)
    found = []
    for keyword, rule in rules.items():
        if keyword not in SILENT:
            found += CHECKS[keyword](value, rule, rules, root, where)
    return found


def check_type(value, rule, _rules, _root, where):
    kinds = [rule] if isinstance(rule, str) else rule
    return [] if any(KINDS[kind](value) for kind in kinds) else [f"{where}: {value!r} is not {' or '.join(kinds)}"]


def check_required(value, rule, _rules, _root, where):
    return [f"{where}: lacks {key}" for key in rule if isinstance(value, dict) and key not in value]


def check_properties(value, rule, _rules, root, where):
    if not isinstance(value, dict):
        return []
    return [line for key in value if key in rule for line in problems(value[key], rule[key], root, f"{where}.{key}")]


def check_additional(value, rule, rules, root, where):
    if not isinstance(value, dict):
        return []
    others = [key for key in value if key not in rules.get("properties", {})]
    if rule is False:
        return [f"{where}: {key} is not described" for key in others]
    return [line for key in others for line in problems(value[key], rule, root, f"{where}.{key}")]


def check_items(value, rule, _rules, root, where):
    if not isinstance(value, list):
        return []
    return [line for i, item in enumerate(value) for line in problems(item, rule, root, f"{where}[{i}]")]


def check_any_of(value, rule, _rules, root, where):
    branches = [problems(value, branch, root, where) for branch in rule]
    return [] if any(not branch for branch in branches) else min(branches, key=len)


CHECKS = {
    "type": check_type,
    "required": check_required,
    "properties": check_properties,
    "additionalProperties": check_additional,
    "items": check_items,
    "anyOf": check_any_of,
    "enum": lambda v, rule, *rest: [] if v in rule else [f"{rest[-1]}: {v!r} is not one of {rule}"],
    "const": lambda v, rule, *rest: [] if v == rule else [f"{rest[-1]}: {v!r} is not {rule}"],
    "minimum": lambda v, rule, *rest: [f"{rest[-1]}: {v} is below {rule}"]
               if KINDS["number"](v) and v < rule else [],
}
