// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "meniscus/errors.h"
#include "meniscus/file_words.h"
#include "meniscus/pocket_chemistry.h"
#include "meniscus/threads.h"
#include "meniscus/write.h"
#include "objects.h"

namespace meniscus::c {
namespace {

meniscus_totals totals_of(const SurfaceTotals& t) {
    return {t.sas_area, t.sas_volume, t.ses_area, t.ses_volume, t.contact_area, t.toroidal_area, t.reentrant_area};
}

/// With the depths of atoms, which tables have.
Measures with_depths(const ExactSurface& exact) {
    Measures measures = ses_measures(exact);
    const std::vector<double> distances =
        exact.of_same_atoms({.kind = SurfaceKind::Ses, .probe = measures.options.probe})
            .signed_distance(exact.atoms().centres);
    for (std::size_t i = 0; i < distances.size(); ++i) measures.atoms[i].depth = -distances[i];
    measures.options.depth = true;
    return measures;
}

}  // namespace

const Measures& ses_measures(const ExactSurface& exact) {
    const double probe = exact.options().kind == SurfaceKind::Vdw ? 0.0 : exact.options().probe;
    return exact.of_same_atoms({.kind = SurfaceKind::Ses, .probe = probe}).measures();
}

}  // namespace meniscus::c

using namespace meniscus::c;

meniscus_status meniscus_exact_new(const meniscus_structure* structure, const meniscus_options* given,
                                   meniscus_exact** exact) {
    return guarded([&] {
        need(structure, "structure");
        need(exact, "exact");
        const Options& options = options_of(given);
        const bool is_vdw = options.surface.surface == meniscus::SurfaceKind::Vdw;
        const meniscus::ExactOptions kind{.kind = options.surface.surface,
                                          .probe = is_vdw ? 0.0 : options.surface.probe};
        *exact = new meniscus_exact{structure->structure, meniscus::ExactSurface(structure->structure->atoms, kind),
                                    options.run.threads};
    });
}

void meniscus_exact_free(meniscus_exact* exact) { delete exact; }

meniscus_status meniscus_measure(meniscus_exact* exact, meniscus_totals* totals, meniscus_totals* errors) {
    return guarded([&] {
        need(exact, "exact");
        need(totals, "totals");
        const meniscus::ThreadLimit limit(exact->threads);
        const meniscus::Measures& measures = ses_measures(exact->exact);
        *totals = totals_of(measures.totals);
        if (errors != nullptr) *errors = totals_of(measures.errors);
    });
}

meniscus_status meniscus_atom_areas(meniscus_exact* exact, double* sas, double* ses) {
    return guarded([&] {
        need(exact, "exact");
        const meniscus::ThreadLimit limit(exact->threads);
        for (const meniscus::AtomMeasure& atom : ses_measures(exact->exact).atoms) {
            if (sas != nullptr) *sas++ = atom.sas_area;
            if (ses != nullptr) *ses++ = atom.ses_area();
        }
    });
}

meniscus_status meniscus_signed_distance(meniscus_exact* exact, size_t n, const double* points, double* distances) {
    return guarded([&] {
        need(exact, "exact");
        need(points, "points");
        need(distances, "distances");
        need_room(n, "n");
        const meniscus::ThreadLimit limit(exact->threads);
        std::vector<meniscus::Vec3> places(n);
        for (size_t i = 0; i < n; ++i) places[i] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
        const std::vector<double> found = exact->exact.signed_distance(places);
        std::copy(found.begin(), found.end(), distances);
    });
}

meniscus_status meniscus_measure_report(meniscus_exact* exact, const meniscus_options* options, const char** json) {
    return guarded([&] {
        need(exact, "exact");
        need(json, "json");
        const meniscus::ThreadLimit limit(exact->threads);
        exact->report = report_of(*exact->structure, exact->exact, options_of(options));
        *json = exact->report.c_str();
    });
}

meniscus_status meniscus_pockets_report(meniscus_exact* exact, const meniscus_options* given, const char** json) {
    return guarded([&] {
        need(exact, "exact");
        need(json, "json");
        const Options& options = options_of(given);
        meniscus::PocketOptions asked = options.pockets;
        asked.probe = exact->exact.options().probe;
        const meniscus::Pockets found =
            meniscus::find_pockets(exact->exact, meniscus::atom_classes(*exact->structure), asked, options.run);
        exact->report = report_of(*exact->structure, exact->exact, found);
        *json = exact->report.c_str();
    });
}

meniscus_status meniscus_write_table(meniscus_exact* exact, const char* per, const char* path) {
    return guarded([&] {
        need(exact, "exact");
        need(per, "per");
        need(path, "path");
        const meniscus::ThreadLimit limit(exact->threads);
        const meniscus::RowsPer rows = meniscus::parse_word("per", per, meniscus::kRowsPerWords);
        meniscus::write_table(path, meniscus::measures_table(*exact->structure, with_depths(exact->exact), rows));
    });
}
