// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The members of what can be pickled. Each list is checked by the compiler: it names as many members as there are, so
// that a new one cannot be forgotten. Whoever adds one counts kArchiveLayout up.
#pragma once

#include "meniscus/describe_options.h"
#include "meniscus/pocket_places.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/tables.h"

namespace meniscus {

template <class Archive>
void fields(Archive& archive, Atoms& s) {
    auto& [centres, radii] = s;
    archive(centres, radii);
}

template <class Archive>
void fields(Archive& archive, AtomLabel& s) {
    auto& [residue, name, element, altloc, serial, b_factor, occupancy, charge] = s;
    archive(residue, name, element, altloc, serial, b_factor, occupancy, charge);
}

template <class Archive>
void fields(Archive& archive, Residue& s) {
    auto& [chain, name, number, insertion_code] = s;
    archive(chain, name, number, insertion_code);
}

template <class Archive>
void fields(Archive& archive, Ligands& s) {
    auto& [centres, labels, residues, bonds, in_surface] = s;
    archive(centres, labels, residues, bonds, in_surface);
}

template <class Archive>
void fields(Archive& archive, Structure& s) {
    auto& [file, name, sha256, radii_set, atoms, labels, residues, dropped, left_out_ligands, ligands, notes,
           warnings] = s;
    archive(file, name, sha256, radii_set, atoms, labels, residues, dropped, left_out_ligands, ligands, notes,
            warnings);
}

template <class Archive>
void fields(Archive& archive, SurfaceTotals& s) {
    auto& [sas_area, sas_volume, ses_area, ses_volume, contact_area, toroidal_area, reentrant_area] = s;
    archive(sas_area, sas_volume, ses_area, ses_volume, contact_area, toroidal_area, reentrant_area);
}

template <class Archive>
void fields(Archive& archive, MeasureOptions& s) {
    auto& [probe, cavities, depth, patches, threads] = s;
    archive(probe, cavities, depth, patches, threads);
}

template <class Archive>
void fields(Archive& archive, PatchAreas& s) {
    auto& [contact, toroidal, reentrant] = s;
    archive(contact, toroidal, reentrant);
}

template <class Archive>
void fields(Archive& archive, PatchMeasure& s) {
    auto& [kind, atoms, component, ses_area, sas_area, first_share] = s;
    archive(kind, atoms, component, ses_area, sas_area, first_share);
}

template <class Archive>
void fields(Archive& archive, SurfaceComponent& s) {
    auto& [kind, ses_area, contact_area, toroidal_area, reentrant_area, ses_volume, sas_area, sas_volume,
           sas_components, centre, inside_of, atoms, inscribed_centre, inscribed_radius, errors] = s;
    archive(kind, ses_area, contact_area, toroidal_area, reentrant_area, ses_volume, sas_area, sas_volume,
            sas_components, centre, inside_of, atoms, inscribed_centre, inscribed_radius, errors);
}

template <class Archive>
void fields(Archive& archive, Measures& s) {
    auto& [options, totals, errors, sas_components, largest_sas_piece, components, atoms, patches, agreed, degenerate,
           disputed] = s;
    archive(options, totals, errors, sas_components, largest_sas_piece, components, atoms, patches, agreed, degenerate,
            disputed);
}

template <class Archive>
void fields(Archive& archive, ChainPair& s) {
    auto& [a, b] = s;
    archive(a, b);
}

template <class Archive>
void fields(Archive& archive, InterfaceAtom& s) {
    auto& [sas_alone, sas_complex, ses_alone, ses_complex] = s;
    archive(sas_alone, sas_complex, ses_alone, ses_complex);
}

template <class Archive>
void fields(Archive& archive, Interface& s) {
    auto& [sas_a, sas_b, sas_ab, ses_a, ses_b, ses_ab, sas_error, ses_error, atoms_a, atoms_b, agreed, disputed] = s;
    archive(sas_a, sas_b, sas_ab, ses_a, ses_b, ses_ab, sas_error, ses_error, atoms_a, atoms_b, agreed, disputed);
}

template <class Archive>
void fields(Archive& archive, ChainInterface& s) {
    auto& [chains, group_a, group_b, areas] = s;
    archive(chains, group_a, group_b, areas);
}

template <class Archive>
void fields(Archive& archive, VertexValues& s) {
    auto& [name, values] = s;
    archive(name, values);
}

template <class Archive>
void fields(Archive& archive, Mesh& s) {
    auto& [vertices, normals, atoms, patches, components, areas, mean_curvatures, gaussian_curvatures, shape_indices,
           values, triangles] = s;
    archive(vertices, normals, atoms, patches, components, areas, mean_curvatures, gaussian_curvatures, shape_indices,
            values, triangles);
}

template <class Archive>
void fields(Archive& archive, MeshComponent& s) {
    auto& [vertices, triangles, area, volume] = s;
    archive(vertices, triangles, area, volume);
}

template <class Archive>
void fields(Archive& archive, MeshMeasures& s) {
    auto& [area, volume, closed, manifold, euler_characteristic, smallest_angle_deg, shortest_edge, components] = s;
    archive(area, volume, closed, manifold, euler_characteristic, smallest_angle_deg, shortest_edge, components);
}

/// Archives the options that a description visits.
template <class Archive>
struct OptionArchiver {
    Archive& archive;

    template <class T, class... More>
    void operator()(const Option& /*option*/, T& member, const More&... /*more*/) const {
        archive(member);
    }
    void operator()(const Option& /*option*/, FlowOptions& flow, const Words<FlowName, 3>& /*words*/) const {
        archive(flow.name);
    }
    void operator()(const Option& /*option*/, double& /*target*/, double (* /*of*/)(double)) const {}
};

template <class Archive>
void fields(Archive& archive, SurfaceOptions& s) {
    describe(s, OptionArchiver<Archive>{archive});
    archive(s.remesh.finer_grid, s.exact);
}

template <class Archive>
void fields(Archive& archive, Percentiles& s) {
    auto& [min, p5, p50, p95, max] = s;
    archive(min, p5, p50, p95, max);
}

template <class Archive>
void fields(Archive& archive, DistanceSummary& s) {
    auto& [mean, p99, max] = s;
    archive(mean, p99, max);
}

template <class Archive>
void fields(Archive& archive, MeshQuality& s) {
    auto& [angles, smallest_angles, edges, aspect_ratios] = s;
    archive(angles, smallest_angles, edges, aspect_ratios);
}

template <class Archive>
void fields(Archive& archive, TwoSidedDistance& s) {
    auto& [to_exact, from_exact] = s;
    archive(to_exact, from_exact);
}

template <class Archive>
void fields(Archive& archive, DroppedPieces& s) {
    auto& [cavities, islands] = s;
    archive(cavities, islands);
}

template <class Archive>
void fields(Archive& archive, FilledCavities& s) {
    auto& [cavities, islands, volume, walls, rest] = s;
    archive(cavities, islands, volume, walls, rest);
}

template <class Archive>
void fields(Archive& archive, SimplifiedTopology& s) {
    auto& [handles, pieces] = s;
    archive(handles, pieces);
}

template <class Archive>
void fields(Archive& archive, FlowSummary& s) {
    auto& [steps, time, converged, end, residual, mean_distance, max_distance, solver_iterations, initial_area,
           reinitialisations, kept_step, explanation] = s;
    archive(steps, time, converged, end, residual, mean_distance, max_distance, solver_iterations, initial_area,
            reinitialisations, kept_step, explanation);
}

template <class Archive>
void fields(Archive& archive, FlowStep& s) {
    auto& [step, time, area, volume, mean_distance, max_distance, residual, solver_iterations, components, genus] = s;
    archive(step, time, area, volume, mean_distance, max_distance, residual, solver_iterations, components, genus);
}

template <class Archive>
void fields(Archive& archive, Check& s) {
    auto& [name, passed, value, bound] = s;
    archive(name, passed, value, bound);
}

template <class Archive>
void fields(Archive& archive, PocketPlace& s) {
    auto& [points, reach] = s;
    archive(points, reach);
}

template <class Archive>
void fields(Archive& archive, NamedPlace& s) {
    auto& [name, place, ligand] = s;
    archive(name, place, ligand);
}

template <class Archive>
void fields(Archive& archive, PocketOptions& s) {
    auto& [probe, large_probe, spacing, count, rank, places] = s;
    archive(probe, large_probe, spacing, count, rank, places);
}

template <class Archive>
void fields(Archive& archive, PocketMouth& s) {
    auto& [area, radius, centre] = s;
    archive(area, radius, centre);
}

template <class Archive>
void fields(Archive& archive, WallAtom& s) {
    auto& [atom, area] = s;
    archive(atom, area);
}

template <class Archive>
void fields(Archive& archive, Pocket& s) {
    auto& [rank, score, probability, tied_with, site, points_inside, cavity, volume, wall_area, depth, centre, deepest,
           mouths, openings, wall, voxels] = s;
    archive(rank, score, probability, tied_with, site, points_inside, cavity, volume, wall_area, depth, centre, deepest,
            mouths, openings, wall, voxels);
}

template <class Archive>
void fields(Archive& archive, PocketVoxel& s) {
    auto& [position, share, depth, probability, pocket] = s;
    archive(position, share, depth, probability, pocket);
}

template <class Archive>
void fields(Archive& archive, Pockets& s) {
    auto& [options, volume, rest_volume, scale, wall_area, mouth_area, pockets, voxels, points, features] = s;
    archive(options, volume, rest_volume, scale, wall_area, mouth_area, pockets, voxels, points, features);
}

template <class Archive>
void fields(Archive& archive, Cost& s) {
    auto& [area, vertices, memory_mb, seconds] = s;
    archive(area, vertices, memory_mb, seconds);
}

template <class Archive>
void fields(Archive& archive, StageTimes& s) {
    auto& [estimate, geometry, exact, band, flow, mesh] = s;
    archive(estimate, geometry, exact, band, flow, mesh);
}

template <class Archive>
void fields(Archive& archive, Surface& s) {
    // The exact surface follows from the structure's atoms and the options.
    auto& [exact, options, mesh, measures, corrected_area, corrected_volume, measured, distance, quality, two_sided,
           dropped, filled, simplified, self_intersections, flow, history, level_set, checks, expected, seconds] = s;
    archive(options, mesh, measures, corrected_area, corrected_volume, measured, distance, quality, two_sided, dropped,
            filled, simplified, self_intersections, flow, history, level_set, checks, expected, seconds);
}

}  // namespace meniscus
