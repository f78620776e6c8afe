// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program's colours (src/colours/palettes.cpp, atom_colours.cpp and feature_colours.cpp have their sources); a test
// compares the two. All are 0xRRGGBB.

const row = text => text.trim().split(/\s+/).map(word => parseInt(word, 16));

/** Of a surface that shows nothing but itself, and of what a scheme knows nothing about. */
export const PLAIN = 0x77aadd;
export const NEUTRAL = 0xcccccc;

/** Contact, toroidal, reentrant. */
export const PATCHES = [0x77aadd, 0xeedd88, 0xee8866];

/** Of chains and cavities; the row begins again where it ends. */
export const DISTINCT = row(
  "77aadd ee8866 eedd88 ffaabb 994455 0072b2 997700 99ddff ee3377 bbcc33 009988 aaaa00 5424fc 00fc9c 306c00 c078fc " +
  "0cb400 908484 3c6060 6c5490 c018b4 cc3c00 90a884 84fc0c 3c78fc ccb4f0 f0a800 00fcfc 6c6048 c0e4b4 a86c9c 6c9024 " +
  "c0a884 608490 a86c54 fc6ccc 30c0cc 8484b4 3cc084 607854 84540c fcd8c0 fcd8f0 00903c 006c48 78606c 606000 0054d8 " +
  "9054e4 c09ca8 f00cfc cc780c 546078 90cc60 cc7884 909cfc 0090f0 b40c24 84d8c0 fcb484 90b4b4 fca8f0 009cc0 fc5400 " +
  "a8a8c0 ccd8fc 908454 00e43c f0cc00 007878 903c84 ccf078 c02478 cccca8 fc00b4 006084 c090cc c09c3c 00c0fc fc183c " +
  "606cb4 48603c 9c3c00 9cf090 787800 c0e4e4 a8a89c 84b400 b4b46c 609c6c 6c6c6c 9078d8 c05454 788478 9030c0 845448");

export const RED_BLUE = row("2166ac 4393c3 92c5de d1e5f0 f7f7f7 fddbc7 f4a582 d6604d b2182b");
export const GREEN_BROWN = row("01665e 35978f 80cdc1 c7eae5 f5f5f5 f6e8c3 dfc27d bf812d 8c510a");

export const ELEMENTS = {
  H: 0xffffff, D: 0xffffff, C: 0xc8c8c8, N: 0x8f8fff, O: 0xf00000, S: 0xffc832, P: 0xffa500, F: 0xdaa520, SI: 0xdaa520,
  AU: 0xdaa520, CL: 0x00ff00, B: 0x00ff00, NA: 0x0000ff, MG: 0x228b22, BR: 0xa52a2a, ZN: 0xa52a2a, CU: 0xa52a2a,
  NI: 0xa52a2a, FE: 0xffa500, BA: 0xffa500, CA: 0x808090, MN: 0x808090, AL: 0x808090, TI: 0x808090, CR: 0x808090,
  AG: 0x808090, I: 0xa020f0, LI: 0xb22222, HE: 0xffc0cb,
};

export const RESIDUES = {
  ALA: 0x7fbc8b, CYS: 0x05d560, ASP: 0xc4853a, GLU: 0xb18953, PHE: 0x0acbf4, GLY: 0xdcabbb, HIS: 0xccaadf, ILE: 0x08cab9,
  LYS: 0xd0b57a, LEU: 0x0fcfc6, MET: 0x05a396, ASN: 0xe8aa86, PRO: 0x96c756, GLN: 0xa58c6a, ARG: 0xaf8687, SER: 0x93a37d,
  THR: 0x669e5f, VAL: 0x26cdad, TRP: 0x1696ff, TYR: 0x6fbff9, A: 0xee6677, C: 0xccbb44, G: 0x228833, T: 0x4477aa,
  U: 0x66ccee,
};

/** Kyte and Doolittle 1982. */
export const HYDROPATHIES = {
  ILE: 4.5, VAL: 4.2, LEU: 3.8, PHE: 2.8, CYS: 2.5, MET: 1.9, ALA: 1.8, GLY: -0.4, THR: -0.7, SER: -0.8, TRP: -0.9,
  TYR: -1.3, PRO: -1.6, HIS: -3.2, GLU: -3.5, GLN: -3.5, ASP: -3.5, ASN: -3.5, LYS: -3.9, ARG: -4.5,
};

const ALIASES = new Map(Object.entries({
  HIS: "HID HIE HIP HSD HSE HSP HISD HISE HISH", CYS: "CYX CYM CYS2 CYSH SEC", ASP: "ASH ASPP", GLU: "GLH GLUP",
  LYS: "LYN LYSH", TYR: "TYM", MET: "MSE", A: "ADE RA A3 A5 DA3 DA5 DA +A", C: "CYT RC C3 C5 DC3 DC5 DC +C",
  G: "GUA RG G3 G5 DG3 DG5 DG +G", T: "THY DT3 DT5 DT", U: "URA RU U3 U5 DU +U",
}).flatMap(([name, others]) => others.split(" ").map(other => [other, name])));

/** One name for a kind of residue: DA and ADE are A, HIE is HIS, selenomethionine MET. */
export const kindOfResidue = name => ALIASES.get(name) ?? name;

/** Colours between those of a ramp are linear in sRGB; value from 0 to 1, beyond as the ends. */
export function rampColour(ramp, value) {
  const place = Math.min(Math.max(value, 0), 1) * (ramp.length - 1), i = Math.min(Math.trunc(place), ramp.length - 2);
  const between = shift => Math.round((1 - place + i) * (ramp[i] >> shift & 255) + (place - i) * (ramp[i + 1] >> shift & 255));
  return between(16) << 16 | between(8) << 8 | between(0);
}
