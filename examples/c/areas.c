/* SPDX-FileCopyrightText: 2026 The Meniscus authors
 * SPDX-License-Identifier: Apache-2.0
 * Areas, volumes and a mesh from C: areas STRUCTURE MESH.ply */
#include <meniscus/meniscus.h>
#include <stdio.h>
#include <stdlib.h>

static void check(meniscus_status status) {
    if (status == MENISCUS_OK) return;
    fprintf(stderr, "%s\n", meniscus_last_error());
    exit(status);
}

int main(int argc, char** argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: areas STRUCTURE MESH.ply\n");
        return MENISCUS_USAGE;
    }
    meniscus_options* options = meniscus_options_new();
    check(meniscus_options_set(options, "method", "direct"));

    meniscus_structure* structure = NULL;
    check(meniscus_read(argv[1], options, &structure));
    printf("%zu atoms\n", meniscus_atom_count(structure));

    meniscus_exact* exact = NULL;
    meniscus_totals totals, errors;
    check(meniscus_exact_new(structure, options, &exact));
    check(meniscus_measure(exact, &totals, &errors));
    printf("SES area %.4f +- %.0e, volume %.4f +- %.0e\n", totals.ses_area, errors.ses_area, totals.ses_volume,
           errors.ses_volume);

    double distance = 0;
    check(meniscus_signed_distance(exact, 1, meniscus_atom_centres(structure), &distance));
    printf("the first atom lies %.3f below the surface\n", -distance);

    meniscus_surface* surface = NULL;
    check(meniscus_surface_new(exact, options, NULL, NULL, &surface));
    printf("%zu vertices, %zu triangles\n", meniscus_vertex_count(surface), meniscus_triangle_count(surface));
    check(meniscus_write_mesh(surface, argv[2]));

    meniscus_surface_free(surface);
    meniscus_exact_free(exact);
    meniscus_structure_free(structure);
    meniscus_options_free(options);
    return 0;
}
