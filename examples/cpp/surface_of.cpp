// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A program of its own that uses the library: surface_of STRUCTURE PICTURE.png
#include <cstdio>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/write.h"

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const meniscus::Structure structure = meniscus::read_structure(argv[1]);
    const meniscus::Surface surface = meniscus::compute_surface(structure.atoms);
    const std::vector<meniscus::Colour> colours = meniscus::colour_vertices(surface.mesh, structure);
    meniscus::write_picture(argv[2], meniscus::draw_picture(surface.mesh, colours, {.width = 400, .height = 300}));
    std::printf("%zu atoms, %.1f square angstroms\n", structure.atoms.size(), surface.measures.area);
}
