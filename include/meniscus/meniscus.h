// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The C interface (C99), for C, Fortran, Julia, Rust, ctypes and WebAssembly: atoms to exact measures, meshes and
// signed distances.
//
// Everything is in Å, Å² and Å³. Objects are opaque; whoever makes one frees it with the function named ..._free, in
// any order: a surface keeps what it was made of. Arrays and texts that are returned belong to the object that was
// asked for them and stay valid until that object is freed; texts also only until the same function is called for it
// again. An object may be used by one thread at a time, different objects by several threads at once.
//
// Functions that can fail return a status, 0 for success, and leave their results untouched otherwise;
// meniscus_last_error() then says what is wrong and what to do. Nothing is printed and no exception leaves the library.
// docs/c.md has examples; docs/stability.md says what stays as it is.
#ifndef MENISCUS_MENISCUS_H
#define MENISCUS_MENISCUS_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(MENISCUS_SHARED)
#define MENISCUS_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MENISCUS_API __attribute__((visibility("default")))
#else
#define MENISCUS_API
#endif

// NOLINTBEGIN(readability-identifier-naming): names are those of C, where prefixes stand for namespaces.
#ifdef __cplusplus
extern "C" {
#endif

// How a call ended; the numbers are those of the program's exit codes.
typedef enum meniscus_status {
    MENISCUS_OK = 0,
    MENISCUS_FAILED = 1,    // a mistake in the library: please report it
    MENISCUS_USAGE = 2,     // an option or argument that makes no sense
    MENISCUS_INPUT = 3,     // a file that cannot be read, or whose content is not valid
    MENISCUS_OUTPUT = 4,    // a file that cannot be written; nothing half-written is left
    MENISCUS_LIMIT = 5,     // a computation that would need more memory than there is
    MENISCUS_STOPPED = 130  // the caller's progress function asked to stop
} meniscus_status;

// "0.1.0"
MENISCUS_API const char* meniscus_version(void);

// Why the last call of this thread that failed did so: one line in UTF-8, "FILE:LINE:COLUMN: what; what to do" for
// input. Empty if none has failed. Valid until the next call that fails.
MENISCUS_API const char* meniscus_last_error(void);

// Options: the names and words of the command line, without "--" and with "_" for "-"

typedef struct meniscus_options meniscus_options;

// All options with their default values; NULL stands for such options wherever they are asked for.
MENISCUS_API meniscus_options* meniscus_options_new(void);
MENISCUS_API void meniscus_options_free(meniscus_options* options);

// Sets one option from text: "spacing" to "0.4", "method" to "direct", "keep_ridges" to "true".
// Names: those of docs/reference/options.md for surfaces (probe, method, surface, spacing, edge, ...) and for reading
// (radii, hydrogens, hetero, waters, model, assembly, altloc, chains, select, strict_radii), threads, memory; further
// `exact` (true: a surface has exact measures in its report) and `between` (interfaces in reports: "A,B:C" or "all").
// Fails with MENISCUS_USAGE for an unknown name and a value out of range.
MENISCUS_API meniscus_status meniscus_options_set(meniscus_options* options, const char* name, const char* value);

// Structures: atoms with radii, and their names where they come from a file

typedef struct meniscus_structure meniscus_structure;

// Reads a file: PDB, mmCIF, BinaryCIF, GROMACS, PDBQT, PQR, xyzr, xyzrn; gzipped where the library has zlib.
MENISCUS_API meniscus_status meniscus_read(const char* path, const meniscus_options* options,
                                           meniscus_structure** structure);

// The same from the bytes of a file in memory; its name tells the format, "1abc.cif". NULL: the content tells it.
MENISCUS_API meniscus_status meniscus_parse(const void* bytes, size_t size, const char* name,
                                            const meniscus_options* options, meniscus_structure** structure);

// Spheres: n centres as x, y, z (3n numbers), n radii above 0.
MENISCUS_API meniscus_status meniscus_from_spheres(size_t n, const double* centres, const double* radii,
                                                   meniscus_structure** structure);
MENISCUS_API void meniscus_structure_free(meniscus_structure* structure);

MENISCUS_API size_t meniscus_atom_count(const meniscus_structure* structure);
MENISCUS_API const double* meniscus_atom_centres(const meniscus_structure* structure);  // 3n
MENISCUS_API const double* meniscus_atom_radii(const meniscus_structure* structure);    // n

// What is known of an atom; texts are empty where nothing is.
typedef struct meniscus_atom {
    const char* name;        // "CA"
    const char* element;     // "C"
    const char* residue;     // "ALA"
    const char* chain;       // author name
    int32_t residue_number;  // author number
    int32_t serial;          // as in the file
    char insertion_code;     // ' ' for none
    char altloc;             // ' ' for none
    double b_factor;         // Å², or pLDDT
    double occupancy;
    double charge;  // e
} meniscus_atom;
MENISCUS_API meniscus_status meniscus_atom_label(const meniscus_structure* structure, size_t atom,
                                                 meniscus_atom* label);

// JSON text: file, sha256, atoms, residues, radii, probe, dropped, notes, warnings, as "input" of the program's report.
MENISCUS_API meniscus_status meniscus_structure_report(meniscus_structure* structure, const char** json);

// The exact surface: analytic areas, volumes and distances

typedef struct meniscus_exact meniscus_exact;

// The surface of a structure; options: probe, surface (ses, sas, vdw: distances and meshes are of that one), threads.
// Computes nothing until it is asked.
MENISCUS_API meniscus_status meniscus_exact_new(const meniscus_structure* structure, const meniscus_options* options,
                                                meniscus_exact** exact);
MENISCUS_API void meniscus_exact_free(meniscus_exact* exact);

// Areas and volumes of a whole surface, or their absolute errors; cavities count negative in the volumes.
typedef struct meniscus_totals {
    double sas_area;
    double sas_volume;
    double ses_area;
    double ses_volume;
    double contact_area;
    double toroidal_area;
    double reentrant_area;
} meniscus_totals;

// The totals of SAS and SES of the atoms, with an error estimate for each number; errors may be NULL.
MENISCUS_API meniscus_status meniscus_measure(meniscus_exact* exact, meniscus_totals* totals, meniscus_totals* errors);

// SAS and SES areas of every atom, n numbers each; NULL for what is not wanted.
MENISCUS_API meniscus_status meniscus_atom_areas(meniscus_exact* exact, double* sas, double* ses);

// Signed distances of n points (3n numbers) from the surface, negative inside: exact inside and on the surface, outside
// a lower bound with the right zero set.
MENISCUS_API meniscus_status meniscus_signed_distance(meniscus_exact* exact, size_t n, const double* points,
                                                      double* distances);

// JSON text with the keys of `meniscus measure --report`: input, exact, components, cavities, and interfaces if the
// option `between` is set.
MENISCUS_API meniscus_status meniscus_measure_report(meniscus_exact* exact, const meniscus_options* options,
                                                     const char** json);

// Pockets: JSON text with the keys of `meniscus pockets --report`: input, options, total, pockets, checks. Options:
// large_probe, spacing (1 unless set), count, rank, threads; the probe is that of the exact surface. The ranking was
// fitted to structures read with radii = united and hetero = none.
MENISCUS_API meniscus_status meniscus_pockets_report(meniscus_exact* exact, const meniscus_options* options,
                                                     const char** json);

// Writes a table of measures; per: "atom", "residue", "chain" or "cavity"; .csv or .json.
MENISCUS_API meniscus_status meniscus_write_table(meniscus_exact* exact, const char* per, const char* path);

// Meshes

typedef struct meniscus_surface meniscus_surface;

// Called during a computation, on the calling thread, with the name of a stage and the fraction of it that is done; a
// result other than 0 stops the computation.
typedef int (*meniscus_progress)(void* user, const char* stage, double fraction);

// The mesh of an exact surface, by the options of `meniscus surface`; progress may be NULL. Kind of surface and probe
// radius are those of the exact surface.
MENISCUS_API meniscus_status meniscus_surface_new(const meniscus_exact* exact, const meniscus_options* options,
                                                  meniscus_progress progress, void* user, meniscus_surface** surface);
MENISCUS_API void meniscus_surface_free(meniscus_surface* surface);

MENISCUS_API size_t meniscus_vertex_count(const meniscus_surface* surface);
MENISCUS_API size_t meniscus_triangle_count(const meniscus_surface* surface);

// One entry per vertex: positions (3 numbers), unit normals that point into the solvent (3 numbers), the index of the
// nearest atom, the kind of patch (0 contact, 1 toroidal, 2 reentrant), the number of the closed piece (0 is the
// largest outer one).
MENISCUS_API const double* meniscus_vertex_positions(const meniscus_surface* surface);
MENISCUS_API const float* meniscus_vertex_normals(const meniscus_surface* surface);
MENISCUS_API const uint32_t* meniscus_vertex_atoms(const meniscus_surface* surface);
MENISCUS_API const uint8_t* meniscus_vertex_patches(const meniscus_surface* surface);
MENISCUS_API const uint32_t* meniscus_vertex_components(const meniscus_surface* surface);

// Values at the vertices: "mean_curvature" (Å^-1), "gaussian_curvature" (Å^-2), "shape_index", "area" (Å²); NULL for
// another name.
MENISCUS_API const float* meniscus_vertex_values(const meniscus_surface* surface, const char* name);

// Three vertices per triangle, counter-clockwise seen from the solvent.
MENISCUS_API const uint32_t* meniscus_triangles(const meniscus_surface* surface);

// JSON text with the keys of `meniscus surface --report`: input, options, exact and components (with the option
// `exact`, else null), mesh, flow, checks, expected; further `cavities`: a list of area, volume, centre, radius,
// component of the mesh, lining.
MENISCUS_API meniscus_status meniscus_surface_report(meniscus_surface* surface, const char** json);

// Writes the mesh; the suffix chooses the format: .ply .obj .stl .off .glb .vtp .vert, and .npz where the library has
// zlib.
MENISCUS_API meniscus_status meniscus_write_mesh(const meniscus_surface* surface, const char* path);

#ifdef __cplusplus
}
#endif
// NOLINTEND(readability-identifier-naming)

#endif
