"""Makes sources and documents from the table of options, include/quadrille/compiled/options.def.

    python3 option_table.py manual    the tables of doc/manual/options.md
    python3 option_table.py python    _table.py of the Python package
    python3 option_table.py types     option_table.d.ts of the npm package
    python3 option_table.py names     option_table.js of the npm package
    python3 option_table.py schema    the schema of the options in a report of the program

What is made goes to standard output, or to the file that follows; in the manual it replaces what is behind
the line <!-- options.def -->.
"""

import json
import pathlib
import re
import sys
import textwrap
from typing import List, NamedTuple

TABLE = pathlib.Path(__file__).resolve().parents[2] / "include/quadrille/compiled/options.def"


class Word(NamedTuple):
    name: str
    short_form: str
    sentence: str


class Row(NamedTuple):
    """A row of the table with its words. `scope` is "", "JOB" or "CHANNEL"."""

    scope: str
    group: str
    kind: str
    name: str
    range: str
    fallback: str
    unit: str
    places: List[str]
    short_form: str
    sentence: str
    words: List[Word]

    def is_array(self):
        return self.kind in ("numbers", "point_numbers", "point_flags", "face_flags")


def rows():
    """Reads the table."""
    result, group = [], ""
    call = re.compile(r'^QUADRILLE_(?:(GROUP)|(?:(JOB|CHANNEL)_)?(OPTION|WORD))\((.*?)\)$(?=\n\n|\nQUADRILLE|\n//)',
                      re.MULTILINE | re.DOTALL)
    for match in call.finditer(TABLE.read_text(encoding="utf-8")):
        fields = [text if text else name for text, name in
                  re.findall(r'"((?:[^"\\]|\\.)*)"|(\w+)(?=\s*,)', match[4])]
        if match[1]:
            group = fields[0]
        elif match[3] == "WORD":
            result[-1].words.append(Word(*fields[1:]))
        else:
            kind, name, range_, fallback, unit, places, short_form, sentence = fields
            result.append(Row(match[2] or "", group, kind, name, range_, fallback, unit, places.split(), short_form,
                              sentence, []))
    return result


def of(scopes, place=None):
    """The rows of these scopes that an interface has."""
    return [row for row in rows() if row.scope in scopes and (place is None or place in row.places)]


def spelled(text, spell):
    """A sentence with its names as a language spells them."""
    return re.sub(r"`(\w+)`", lambda match: spell(match[1]), text)


def full_sentence(row, word, spell):
    """The sentence of a row with its words, unit and default."""
    text = row.sentence
    if row.words:
        text += ": " + ", ".join(f"{word(known.name)} ({known.sentence})" for known in row.words)
    return spelled(text, spell)


# --- The manual


def manual():
    kinds = {"count": "integer", "number": "number", "flag": "true or false", "word": "word", "numbers": "numbers",
             "point_numbers": "number for each point", "point_flags": "flag for each point",
             "face_flags": "flag for each triangle"}
    head = "| option | value | default | what it is | where |\n|---|---|---|---|---|\n"
    text, group = "", None
    for row in rows():
        if row.group != group:
            group, (title, _, rest) = row.group, row.group.partition(": ")
            text += "\n" + ("## Options of a channel of attributes" if row.scope == "CHANNEL" else f"### {title}") + "\n\n"
            text += (rest[0].upper() + rest[1:] + ".\n\n" if rest else "") + head
        value = kinds[row.kind] + (f" in {row.range}" if row.range else "")
        value += f", {row.unit}" if row.unit not in ("", "factor", "weight") else ""
        sentence = full_sentence(row, "`{}`".format, "`{}`".format)
        sentence += f". Short form in the program: `--{row.short_form}`" if row.short_form else ""
        fallback = f"`{row.fallback}`" if row.fallback else ""
        text += f"| `{row.name}` | {value} | {fallback} | {sentence} | {', '.join(row.places)} |\n"
    return text


# --- Python

_OWN = ("cost", "split_vertices", "region_boundary_weight")  # are arguments of simplify() by themselves


def pascal(name):
    return "".join(part.capitalize() for part in name.split("_"))


def python_type(row):
    if row.is_array():
        return "Optional[ArrayLike]"
    plain = {"count": "int", "number": "float", "flag": "bool", "word": pascal(row.name) + "Name"}[row.kind]
    return plain if row.fallback else f"Optional[{plain}]"


def python_default(row, enumerator):
    if row.is_array():
        return "()"
    if not row.fallback:
        return "None"
    if row.kind == "word":
        return f"{pascal(row.name)}.{row.fallback}" if enumerator else repr(row.fallback)
    return {"count": int, "number": float, "flag": lambda text: text == "true"}[row.kind](row.fallback).__repr__()


def python_sentence(row):
    """Says what an option is, with its range and default."""
    text = full_sentence(row, "'{}'".format, lambda name: name if name in names else f"'{name}'")
    text += {"point_numbers": "; a number for each point", "point_flags": "; booleans for each point, or indices",
             "face_flags": "; booleans for each triangle, or indices"}.get(row.kind, "")
    if row.unit.startswith(("degrees", "standard deviation", "unit of the points")):
        text += f", in {row.unit}" if row.unit == "degrees" else f", in the {row.unit}" if row.unit[0] == "u" else f"; {row.unit}"
    text += f"; in {row.range}" if row.range not in ("", "[0, inf)", "[0, 4294967295]") else ""
    return text + (f" (default: {row.fallback})" if row.fallback not in ("", "false") else "")


names = {row.name for row in rows()}


def python_document(group):
    """The lines of a group for the documentation of simplify()."""
    lines = []
    for row in of(("", "JOB"), "Python"):
        if row.group == group and row.name not in ("maps", "calibrated"):  # are told there
            lines += textwrap.wrap(python_sentence(row), 116, initial_indent="    " + row.name.ljust(17) + " ",
                                   subsequent_indent=" " * 22, break_long_words=False)
    return "\n".join(lines)


def python():
    calls, channels = of(("", "JOB")), of(("CHANNEL",))
    every = of(("", "JOB", "CHANNEL"))
    out = ['"""The options of simplify() and of channels. Made from options.def by option_table.py."""\n',
           "from __future__ import annotations\n",
           "import enum",
           "from typing import Any, Dict, Literal, NamedTuple, Optional, Type, TypedDict\n",
           "from numpy.typing import ArrayLike\n"]
    for row in every:
        if row.words:
            listed = ", ".join(f'"{word.name}"' for word in row.words)
            out.append(f"{pascal(row.name)}Name = Literal[{listed}]")
    for row in every:
        if row.words:
            out += [f"\n\nclass {pascal(row.name)}(enum.Enum):", f'    """The words of {row.name}."""\n']
            out += [f"    {word.name} = {number}" for number, word in enumerate(row.words)]
    for title, about, chosen in (
            ("Options", "The options of a call. Those that are as in the class are not set.", calls),
            ("ChannelOptions", "The options of a channel, in the same manner.", channels)):
        out += [f"\n\nclass {title}:", f'    """{about}"""\n']
        for row in chosen:
            kind = "Any" if row.is_array() else python_type(row).replace(pascal(row.name) + "Name", pascal(row.name))
            out.append(f"    {row.name}: {kind} = {python_default(row, True)}")
    shared = [row for row in of(("",), "Python") if row.name not in _OWN and not row.is_array()]
    arrays = [row for row in of(("",), "Python") if row.is_array()]
    for title, about, chosen in (
            ("SharedOptions", "The options of simplify() and simplify_gltf().", shared),
            ("ArrayOptions", "The options with a value for each point or triangle.", arrays)):
        out += [f"\n\nclass {title}(TypedDict, total=False):", f'    """{about}"""\n']
        out += [f"    {row.name}: {python_type(row)}" for row in chosen]
    out += ["\n\nclass Row(NamedTuple):", '    """A row of the table: the kind of an option, its default and words."""\n',
            "    kind: str", "    fallback: Any", "    words: Optional[Type[enum.Enum]] = None\n\n",
            "ROWS: Dict[str, Row] = {"]
    for row in of(("",), "Python"):
        words = f", {pascal(row.name)}" if row.words else ""
        fallback = "None" if row.is_array() else python_default(row, False)
        out.append(f'    "{row.name}": Row("{row.kind}", {fallback}{words}),')
    out.append("}")
    out.append("DOCUMENTS: Dict[str, str] = {")
    for group in dict.fromkeys(row.group for row in of(("", "JOB"), "Python")):
        out.append(f'    "{group.partition(": ")[0]}": """\\\n{python_document(group)}""",')
    return "\n".join(out + ["}"]) + "\n"


# --- JavaScript


def camel(name):
    return re.sub(r"_(\w)", lambda match: match[1].upper(), name)


def types():
    kinds = {"count": "number", "number": "number", "flag": "boolean", "numbers": "ArrayLike<number>",
             "point_numbers": "Reals", "point_flags": "Integers", "face_flags": "Integers"}
    out = ["// Made from options.def by option_table.py.\n", 'import type { Integers, Reals } from "./index.js";']
    for title, about, scope in (("CallOptions", "The options of a call. Those that are undefined have their defaults.", ""),
                                ("ChannelOptions", "The options of an attribute.", "CHANNEL")):
        out += [f"\n/** {about} */", f"export interface {title} {{"]
        group = None
        for row in of((scope,), "web"):
            if row.group != group and scope == "":
                group = row.group
                out.append(f"  // {group}.")
            text = full_sentence(row, '`"{}"`'.format, lambda name: f"`{camel(name)}`" if name in names else f'`"{name}"`')
            if row.kind in ("point_flags", "face_flags"):
                text += ": bytes are a mask with one for each, wider integers are indices"
            text += f"; in {row.range}" if row.range not in ("", "[0, 4294967295]") else ""
            text += f", {row.unit}" if row.unit in ("degrees", "unit of the points") else ""
            text += f". Default: {row.fallback}" if row.fallback not in ("", "false") else ""
            lines = textwrap.wrap(f"/** {text[0].upper()}{text[1:]}. */", 118, initial_indent="  ",
                                  subsequent_indent="   *  ", break_long_words=False)
            kind = kinds.get(row.kind) or " | ".join(f'"{word.name}"' for word in row.words)
            out += [*lines, f"  {camel(row.name)}?: {kind};"]
        out.append("}")
    out += ["\nexport declare const callOptions: Record<keyof CallOptions, string>;",
            "export declare const channelOptions: Record<keyof ChannelOptions, string>;"]
    return "\n".join(out) + "\n"


def names_of_web():
    out = ["// The kinds of options. Made from options.def by option_table.py.\n"]
    for title, scope in (("callOptions", ""), ("channelOptions", "CHANNEL")):
        out.append(f"export const {title} = {{")
        out += [f'  {camel(row.name)}: "{row.kind}",' for row in of((scope,), "web")]
        out.append("};")
    return "\n".join(out) + "\n"


# --- JSON


def schema():
    """JSON Schema of the options in a report of the program, by the names of the table."""
    def value(row):
        if row.is_array():
            return {"type": "string"}  # the name of a scalar of the vertices
        if row.kind == "word":
            return {"enum": [word.name for word in row.words]}
        if row.kind == "flag":
            return {"type": "boolean"}
        low, high = row.range[1:-1].split(", ")
        result = {"type": "integer" if row.kind == "count" else "number",
                  "minimum" if row.range[0] == "[" else "exclusiveMinimum": json.loads(low)}
        if high != "inf":
            result["maximum" if row.range[-1] == "]" else "exclusiveMaximum"] = json.loads(high)
        return result

    properties = {}
    for row in rows():
        if "program" in row.places or row.name == "relative_error":
            properties[row.name] = {**value(row), "description": full_sentence(row, "{}".format, "{}".format)}
            if row.fallback:
                properties[row.name]["default"] = row.fallback if row.kind == "word" else json.loads(row.fallback)
    return json.dumps({"$schema": "https://json-schema.org/draft/2020-12/schema",
                       "title": "Options of the program quadrille in its reports", "type": "object",
                       "properties": properties, "additionalProperties": False}, indent=2) + "\n"


def main():
    makers = {"manual": manual, "python": python, "types": types, "names": names_of_web, "schema": schema}
    if len(sys.argv) not in (2, 3) or sys.argv[1] not in makers:
        sys.exit(__doc__)
    made = makers[sys.argv[1]]()
    if len(sys.argv) == 3:
        file = pathlib.Path(sys.argv[2])
        if sys.argv[1] == "manual":
            mark = "<!-- options.def -->\n"
            made = file.read_text(encoding="utf-8").partition(mark)[0] + mark + made
        file.write_text(made, encoding="utf-8")
    else:
        sys.stdout.write(made)


if __name__ == "__main__":
    main()
