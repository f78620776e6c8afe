// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
import type {Surface} from "meniscus-surface";

/** Chain, residue and atom, as in "A LYS 48 NZ"; for atoms without names their number from 1. */
export function atomName(surface: Surface, atom: number): string;
