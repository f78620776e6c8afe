# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Stand-ins of packages that cannot be installed here, with the attributes that their documentation names."""
import sys
import types

import numpy as np


def _class(module, name, **attributes):
    """A class that says that it belongs to another package."""
    return type(name, (), {"__module__": module, **attributes})


class _Biotite:
    """AtomArray and AtomArrayStack: annotations are attributes."""

    def __init__(self, structure, coord, further=()):
        self.coord = np.asarray(coord, dtype=np.float32)
        self._known = {"chain_id": structure.chain, "res_id": structure.resnum, "res_name": structure.resname,
                       "ins_code": np.char.strip(structure.icode), "atom_name": structure.name,
                       "element": structure.element, "hetero": np.zeros(len(structure), bool)}
        self._known.update({name: values for name, values in (("b_factor", structure.b_factor),
                                                              ("atom_id", structure.serial)) if name in further})
        self.__dict__.update(self._known)

    def get_annotation_categories(self):
        return list(self._known)

    def array_length(self):
        return self.coord.shape[-2]


AtomArray = _class("biotite.structure", "AtomArray", __init__=_Biotite.__init__,
                   get_annotation_categories=_Biotite.get_annotation_categories)
AtomArrayStack = _class("biotite.structure", "AtomArrayStack", __init__=_Biotite.__init__,
                        get_annotation_categories=_Biotite.get_annotation_categories)


class _Quantity:
    def __init__(self, values, unit):
        self._values = np.asarray(values, dtype=float)
        self._unit = unit

    def __len__(self):
        return len(self._values)

    def value_in_unit(self, unit):
        values = self._values * (self._unit / unit)
        return tuple(values) if values.ndim == 1 else [tuple(row) for row in values]


Quantity = _class("openmm.unit", "Quantity", **{name: _Quantity.__dict__[name]
                                               for name in ("__init__", "__len__", "value_in_unit")})


def openmm_unit():
    """The module that a program with OpenMM has; lengths in nm."""
    unit = types.ModuleType("openmm.unit")
    unit.nanometer, unit.angstrom = 1.0, 0.1
    package = types.ModuleType("openmm")
    package.unit = unit
    return {"openmm": package, "openmm.unit": unit}


class _Topology:
    def __init__(self, structure):
        spaces = types.SimpleNamespace
        chains = {name: spaces(id=name) for name in structure.chain}
        residues = {r: spaces(name=structure.resname[i], id=str(structure.resnum[i]), index=int(r),
                              insertionCode=structure.icode[i], chain=chains[structure.chain[i]])
                    for i, r in enumerate(structure.residue)}
        self._atoms = [spaces(name=structure.name[i], element=spaces(symbol=structure.element[i]), index=i,
                              id=str(structure.serial[i]), residue=residues[structure.residue[i]])
                       for i in range(len(structure))]

    def atoms(self):
        return iter(self._atoms)


Topology = _class("openmm.app.topology", "Topology", __init__=_Topology.__init__, atoms=_Topology.atoms)
Modeller = _class("openmm.app.modeller", "Modeller")
PDBFile = _class("openmm.app.pdbfile", "PDBFile")
Simulation = _class("openmm.app.simulation", "Simulation")


def modeller(structure):
    """With positions in nm."""
    made = Modeller()
    made.topology = Topology(structure)
    made.positions = Quantity(structure.xyz / 10, 1.0)
    return made


def pdb_file(structure, frames):
    """A file of OpenMM with several frames."""
    made = PDBFile()
    made.topology = Topology(structure)
    made.getNumFrames = lambda: len(frames)
    made.getPositions = lambda frame=0: Quantity(np.asarray(frames[frame]) / 10, 1.0)
    return made


def simulation(structure):
    """Of which only the current positions are asked."""
    made = Simulation()
    made.topology = Topology(structure)
    state = types.SimpleNamespace(getPositions=lambda: Quantity(structure.xyz / 10, 1.0))
    made.context = types.SimpleNamespace(getState=lambda getPositions=False: state)
    return made


assert "biotite" not in sys.modules and "openmm" not in sys.modules
