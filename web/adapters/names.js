// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What to call an atom of a surface, where a viewer has a line for it.

/**
 * Chain, residue and atom, as in "A LYS 48 NZ"; for atoms without names (given as positions) their number from 1.
 * @param {import("meniscus-surface").Surface} surface
 * @param {number} atom index among surface.atoms
 */
export function atomName({atoms}, atom) {
  const words = [atoms.chain?.[atom], atoms.residue?.[atom], atoms.residue?.[atom] && atoms.number?.[atom],
                 atoms.name?.[atom] || atoms.element?.[atom]];
  return words.filter(word => word || word === 0).join(" ") || `atom ${atom + 1}`;
}
