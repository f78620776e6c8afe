// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The C interface from C: closed forms, what is refused and how, and who owns what.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meniscus/meniscus.h"

static int failures = 0;

#define EXPECT(condition)                                                     \
    do {                                                                      \
        if (!(condition)) {                                                   \
            printf("line %d: %s does not hold\n", __LINE__, #condition);      \
            ++failures;                                                       \
        }                                                                     \
    } while (0)

static const double kPi = 3.14159265358979323846;

// What the last error begins with.
static int error_begins(const char* text) { return strncmp(meniscus_last_error(), text, strlen(text)) == 0; }

static meniscus_structure* one_sphere(double radius) {
    const double centre[3] = {1, 2, 3};
    meniscus_structure* structure = NULL;
    EXPECT(meniscus_from_spheres(1, centre, &radius, &structure) == MENISCUS_OK);
    return structure;
}

static void a_sphere_has_the_area_of_a_sphere(void) {
    meniscus_structure* structure = one_sphere(2);
    meniscus_exact* exact = NULL;
    meniscus_totals totals, errors;
    double sas = 0, ses = 0, distances[2];
    const double points[6] = {1, 2, 3, 1, 2, 8};
    EXPECT(meniscus_exact_new(structure, NULL, &exact) == MENISCUS_OK);
    meniscus_structure_free(structure);  // what was made of it stays
    EXPECT(meniscus_measure(exact, &totals, &errors) == MENISCUS_OK);
    EXPECT(fabs(totals.ses_area - 4 * kPi * 4) < 1e-9);
    EXPECT(fabs(totals.ses_volume - 4.0 / 3.0 * kPi * 8) < 1e-9);
    EXPECT(fabs(totals.sas_area - 4 * kPi * 3.4 * 3.4) <= errors.sas_area);
    EXPECT(errors.sas_area > 0 && errors.sas_area < 1e-6);
    EXPECT(meniscus_measure(exact, &totals, NULL) == MENISCUS_OK);
    EXPECT(meniscus_atom_areas(exact, &sas, &ses) == MENISCUS_OK);
    EXPECT(sas == totals.sas_area && ses == totals.ses_area);
    EXPECT(meniscus_atom_areas(exact, NULL, &ses) == MENISCUS_OK);
    EXPECT(meniscus_signed_distance(exact, 2, points, distances) == MENISCUS_OK);
    EXPECT(fabs(distances[0] + 2) < 1e-9 && fabs(distances[1] - 3) < 1e-9);
    meniscus_exact_free(exact);
}

static int stop_at_once(void* user, const char* stage, double fraction) {
    ++*(int*)user;
    return stage[0] != '\0' && fraction >= 0;
}

static void a_mesh_outlives_what_it_was_made_of(void) {
    meniscus_options* options = meniscus_options_new();
    meniscus_structure* structure = one_sphere(3);
    meniscus_exact* exact = NULL;
    meniscus_surface* surface = NULL;
    const char* json = NULL;
    size_t v, t;
    double farthest = 0;
    EXPECT(meniscus_options_set(options, "method", "direct") == MENISCUS_OK);
    EXPECT(meniscus_options_set(options, "spacing", "0.7") == MENISCUS_OK);
    EXPECT(meniscus_exact_new(structure, options, &exact) == MENISCUS_OK);
    EXPECT(meniscus_surface_new(exact, options, NULL, NULL, &surface) == MENISCUS_OK);
    meniscus_structure_free(structure);
    meniscus_exact_free(exact);
    meniscus_options_free(options);
    const size_t vertices = meniscus_vertex_count(surface), triangles = meniscus_triangle_count(surface);
    EXPECT(vertices > 100 && triangles == 2 * vertices - 4);
    for (v = 0; v < vertices; ++v) {
        const double* p = meniscus_vertex_positions(surface) + 3 * v;
        const float* n = meniscus_vertex_normals(surface) + 3 * v;
        const double r = sqrt(pow(p[0] - 1, 2) + pow(p[1] - 2, 2) + pow(p[2] - 3, 2));
        farthest = fmax(farthest, fabs(r - 3));
        EXPECT(fabs(n[0] * (p[0] - 1) + n[1] * (p[1] - 2) + n[2] * (p[2] - 3) - r) < 1e-5);
        EXPECT(meniscus_vertex_atoms(surface)[v] == 0 && meniscus_vertex_patches(surface)[v] == 0);
        EXPECT(meniscus_vertex_components(surface)[v] == 0);
    }
    EXPECT(farthest < 1e-6);
    for (t = 0; t < 3 * triangles; ++t) EXPECT(meniscus_triangles(surface)[t] < vertices);
    EXPECT(fabs(meniscus_vertex_values(surface, "mean_curvature")[0] - 1.0F / 3) < 1e-5);
    EXPECT(meniscus_vertex_values(surface, "beauty") == NULL);
    EXPECT(meniscus_surface_report(surface, &json) == MENISCUS_OK && strstr(json, "\"method\":\"direct\"") != NULL);
    EXPECT(meniscus_write_mesh(surface, "no/such/folder/x.ply") == MENISCUS_OUTPUT);
    EXPECT(meniscus_write_mesh(surface, "x.beauty") == MENISCUS_USAGE);
    meniscus_surface_free(surface);
}

static void whoever_asks_to_stop_is_heard(void) {
    meniscus_structure* structure = one_sphere(3);
    meniscus_exact* exact = NULL;
    meniscus_surface* surface = NULL;
    int calls = 0;
    EXPECT(meniscus_exact_new(structure, NULL, &exact) == MENISCUS_OK);
    EXPECT(meniscus_surface_new(exact, NULL, stop_at_once, &calls, &surface) == MENISCUS_STOPPED);
    EXPECT(calls == 1 && surface == NULL);
    meniscus_exact_free(exact);
    meniscus_structure_free(structure);
}

static void mistakes_have_a_status_and_a_line(void) {
    const char* line = "ATOM      1  N   MET A   1      27.340  24.430   2.x14  1.00  9.67           N\n";
    const double nowhere[3] = {0, 0, NAN};
    const double here[3] = {0, 0, 0};
    const double radius = 1, nothing = 0;
    meniscus_options* options = meniscus_options_new();
    meniscus_structure* structure = NULL;
    EXPECT(meniscus_options_set(options, "spacing", "-1") == MENISCUS_USAGE && error_begins("spacing: must be"));
    EXPECT(meniscus_options_set(options, "spacing", "wide") == MENISCUS_USAGE && error_begins("spacing: 'wide'"));
    EXPECT(meniscus_options_set(options, "threads", "1.5") == MENISCUS_USAGE && error_begins("threads: must be"));
    EXPECT(meniscus_options_set(options, "method", "magic") == MENISCUS_USAGE && error_begins("method: "));
    EXPECT(meniscus_options_set(options, "keep_ridges", "maybe") == MENISCUS_USAGE && error_begins("keep_ridges: "));
    EXPECT(meniscus_options_set(options, "beauty", "1") == MENISCUS_USAGE && error_begins("there is no option 'beauty'"));
    EXPECT(meniscus_options_set(options, NULL, "1") == MENISCUS_USAGE && error_begins("name: must not be NULL"));
    EXPECT(meniscus_read("no such file.pdb", NULL, &structure) == MENISCUS_INPUT && structure == NULL);
    EXPECT(meniscus_parse(line, strlen(line), "x.pdb", NULL, &structure) == MENISCUS_INPUT && error_begins("x.pdb:1:47: "));
    EXPECT(meniscus_read("no\nsuch file.pdb", NULL, &structure) == MENISCUS_INPUT);
    EXPECT(strchr(meniscus_last_error(), '\n') == NULL);
    EXPECT(meniscus_from_spheres(1, nowhere, &radius, &structure) == MENISCUS_USAGE && error_begins("centres: "));
    EXPECT(meniscus_from_spheres(1, here, &nothing, &structure) == MENISCUS_USAGE && error_begins("radii: "));
    EXPECT(meniscus_from_spheres(0, here, &radius, &structure) == MENISCUS_USAGE && error_begins("n: "));
    EXPECT(meniscus_from_spheres((size_t)-1 / 8, here, &radius, &structure) == MENISCUS_LIMIT && error_begins("n: "));
    EXPECT(meniscus_parse(line, (size_t)-1, "x.pdb", NULL, &structure) == MENISCUS_LIMIT && structure == NULL);
    meniscus_options_free(options);
}

static void options_without_effect_are_refused(void) {
    meniscus_options* options = meniscus_options_new();
    meniscus_structure* structure = one_sphere(3);
    meniscus_exact* exact = NULL;
    meniscus_surface* surface = NULL;
    EXPECT(meniscus_options_set(options, "keep_ridges", "true") == MENISCUS_OK);
    EXPECT(meniscus_exact_new(structure, options, &exact) == MENISCUS_OK);
    EXPECT(meniscus_surface_new(exact, options, NULL, NULL, &surface) == MENISCUS_USAGE && error_begins("keep_ridges "));
    EXPECT(meniscus_options_set(options, "edge", "1") == MENISCUS_OK);
    EXPECT(meniscus_surface_new(exact, options, NULL, NULL, &surface) == MENISCUS_OK);
    meniscus_surface_free(surface);
    meniscus_exact_free(exact);
    meniscus_structure_free(structure);
    meniscus_options_free(options);
}

static void totals_are_of_both_surfaces_whichever_is_asked_for_distances(void) {
    meniscus_options* options = meniscus_options_new();
    meniscus_structure* structure = one_sphere(2);
    meniscus_exact* exact = NULL;
    meniscus_totals totals;
    double distance = 0;
    const double centre[3] = {1, 2, 3};
    EXPECT(meniscus_options_set(options, "surface", "sas") == MENISCUS_OK);
    EXPECT(meniscus_exact_new(structure, options, &exact) == MENISCUS_OK);
    EXPECT(meniscus_measure(exact, &totals, NULL) == MENISCUS_OK);
    EXPECT(fabs(totals.ses_area - 4 * kPi * 4) < 1e-6 && fabs(totals.sas_area - 4 * kPi * 3.4 * 3.4) < 1e-6);
    EXPECT(meniscus_signed_distance(exact, 1, centre, &distance) == MENISCUS_OK && fabs(distance + 3.4) < 1e-9);
    meniscus_exact_free(exact);
    meniscus_structure_free(structure);
    meniscus_options_free(options);
}

static void nothing_comes_of_nothing(void) {
    const char* json = NULL;
    EXPECT(meniscus_atom_count(NULL) == 0 && meniscus_vertex_count(NULL) == 0 && meniscus_triangle_count(NULL) == 0);
    EXPECT(meniscus_atom_centres(NULL) == NULL && meniscus_atom_radii(NULL) == NULL);
    EXPECT(meniscus_vertex_positions(NULL) == NULL && meniscus_vertex_normals(NULL) == NULL);
    EXPECT(meniscus_vertex_atoms(NULL) == NULL && meniscus_vertex_patches(NULL) == NULL);
    EXPECT(meniscus_vertex_components(NULL) == NULL && meniscus_triangles(NULL) == NULL);
    EXPECT(meniscus_vertex_values(NULL, "area") == NULL);
    EXPECT(meniscus_surface_report(NULL, &json) == MENISCUS_USAGE && json == NULL);
}

static void names_of_atoms_are_told(void) {
    const char* lines =
        "ATOM      7  CA  MET A   1B     27.340  24.430   2.614  0.50  9.67           C\n"
        "ATOM      8  O   HIS A   2      29.340  24.430   2.614  1.00  9.67           O\n";
    meniscus_options* options = meniscus_options_new();
    meniscus_structure* structure = NULL;
    meniscus_atom atom;
    const char* json = NULL;
    EXPECT(meniscus_options_set(options, "radii", "bondi") == MENISCUS_OK);
    EXPECT(meniscus_parse(lines, strlen(lines), "two.pdb", options, &structure) == MENISCUS_OK);
    EXPECT(meniscus_atom_count(structure) == 2 && meniscus_atom_radii(structure)[0] == 1.7);
    EXPECT(meniscus_atom_centres(structure)[3] == 29.34);
    EXPECT(meniscus_atom_label(structure, 0, &atom) == MENISCUS_OK);
    EXPECT(strcmp(atom.name, "CA") == 0 && strcmp(atom.element, "C") == 0 && strcmp(atom.residue, "MET") == 0);
    EXPECT(strcmp(atom.chain, "A") == 0 && atom.residue_number == 1 && atom.insertion_code == 'B');
    EXPECT(atom.serial == 7 && atom.altloc == ' ' && atom.b_factor == 9.67 && atom.occupancy == 0.5 && atom.charge == 0);
    EXPECT(meniscus_atom_label(structure, 2, &atom) == MENISCUS_USAGE);
    EXPECT(meniscus_structure_report(structure, &json) == MENISCUS_OK && strstr(json, "\"atoms\":2") != NULL);
    meniscus_structure_free(structure);
    meniscus_options_free(options);
}

int main(void) {
    EXPECT(meniscus_version()[0] != '\0' && meniscus_last_error()[0] == '\0');
    a_sphere_has_the_area_of_a_sphere();
    a_mesh_outlives_what_it_was_made_of();
    whoever_asks_to_stop_is_heard();
    mistakes_have_a_status_and_a_line();
    names_of_atoms_are_told();
    options_without_effect_are_refused();
    totals_are_of_both_surfaces_whichever_is_asked_for_distances();
    nothing_comes_of_nothing();
    meniscus_structure_free(NULL);
    meniscus_exact_free(NULL);
    meniscus_surface_free(NULL);
    meniscus_options_free(NULL);
    if (failures > 0) printf("%d expectations failed\n", failures);
    return failures > 0;
}
