// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>

#include "meniscus/measures.h"
#include "summary.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

void write_mesh_with_residues(const std::string& path, const SurfaceRequest& request, const Structure& structure,
                              const Mesh& mesh) {
    std::vector<std::uint32_t> residues(mesh.atoms.size());
    std::transform(mesh.atoms.begin(), mesh.atoms.end(), residues.begin(),
                   [&](std::uint32_t atom) { return structure.labels[atom].residue; });
    write_mesh(path, mesh, {.encoding = request.encoding, .extra = {{"residue", residues}}});
}

class SurfaceRun : public StructureRun {
public:
    explicit SurfaceRun(const SurfaceRequest& request)
        : StructureRun(request, request.surface.threads), request_(request) {}

private:
    std::vector<Output> plan(const std::string& name, const std::string& mark) const override {
        return plan_outputs(request_.outputs, name, mark);
    }

    /// The exact measures, which only reports show, come first: their memory is free again when the grid needs it.
    void compute(const Job& job) override {
        const SurfaceOptions& options = request_.surface;
        if (!request_.report.empty()) measure_exactly(job.structure.atoms);
        surface_ = compute_surface(job.structure.atoms, options,
                                   [this](std::string_view stage, double fraction) { show(stage, fraction); });
    }

    void measure_exactly(const Atoms& atoms) {
        Stopwatch watch;
        exact_ = measure(atoms, {.probe = request_.surface.probe, .threads = request_.surface.threads});
        exact_.patches = {};
        exact_.atoms = {};
        exact_seconds_ = watch.lap();
    }

    void write(const Output& output, const Job& job) const override {
        switch (output.kind) {
            case OutputKind::Mesh:
                return write_mesh_with_residues(output.path, request_, job.structure, surface_.mesh);
            case OutputKind::Spheres:
                return write_spheres(output.path, job.structure);
            default:
                return write_atom_table(output.path, job.structure);
        }
    }

    std::string failed() const override { return failed_checks(surface_, exact_); }

    ordered_json report(const Job& job, const RunFacts& facts) const override {
        RunFacts all = facts;
        all.exact_seconds = exact_seconds_;
        return make_report(request_, job.structure, surface_, exact_, all);
    }

    std::string summary(const Job& job, const RunFacts& facts) const override {
        return make_summary(job.structure, surface_, facts, job.outputs);
    }

    const SurfaceRequest& request_;
    Measures exact_;
    double exact_seconds_ = 0.0;
    Surface surface_;
};

}  // namespace

void add_surface_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("surface", "Solvent-excluded surface of a structure, as a mesh");
    const auto request = std::make_shared<SurfaceRequest>();
    add_surface_options(*command, *request);
    command->callback([request, &outcome] { outcome = run_surface(*request); });
}

Outcome run_surface(const SurfaceRequest& request) { return SurfaceRun(request)(); }

}  // namespace meniscus::cli
