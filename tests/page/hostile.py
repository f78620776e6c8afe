# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A structure whose names would run as scripts wherever one of them were taken for anything but text."""

# Names are ASCII, or the reader refuses them; the name of the file may be anything.
# Each sets window.intruder, by one way that markup or script has; the last are what breaks out of quoted text.
PAYLOADS = (
    "</script><script>intruder=1</script>",
    "<img src=x onerror=intruder=1>",
    "<svg/onload=intruder=1>",
    "\"onmouseover=intruder=1 autofocus onfocus=intruder=1 x=\"",
    "'-(intruder=1)-'",
    "\"};intruder=1;({\"",
    "\\u2028intruder=1\\u2028",
    "\\u003cscript>intruder=1\\u003c/script>",
    "&lt;script&gt;intruder=1&lt;/script&gt;&#60;b",
    "]]><script>intruder=1</script><!--",
    "{{data}}{{title}}${intruder=1}",
    "javascript:intruder=1",
)
TAGS = ("group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id label_entity_id label_seq_id "
        "pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z occupancy B_iso_or_equiv auth_seq_id auth_asym_id "
        "pdbx_PDB_model_num").split()
# Folders cannot be in the name of a file, all else can.
FILE_NAME = "<img src=x onerror=intruder=1>\"'&{{data}}\u2028.cif"


def text(value):
    """As mmCIF has what neither kind of quotes can hold."""
    return f"\n;{value}\n;\n"


def mmcif(names=PAYLOADS):
    """A carbon atom per name, which is that of the atom, its residue and its chain, and names of the file besides."""
    rows = ["data_x", "_entry.id " + text(names[0]), "_struct.title " + text(names[0]), "loop_",
            *("_atom_site." + tag for tag in TAGS)]
    for i, name in enumerate(names):
        rows.append(f"ATOM {i + 1} C {text(name)} . {text(name)} {text(name)} 1 {i + 1} ? {3.0 * i:.3f} 0.000 0.000 1.0 "
                    f"{10 + i} {i + 1} {text(name)} 1")
    return "\n".join(rows) + "\n"
