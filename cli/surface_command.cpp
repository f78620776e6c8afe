// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_command.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "interrupt.h"
#include "meniscus/draw_surface.h"
#include "meniscus/errors.h"
#include "meniscus/ligand_bodies.h"
#include "meniscus/measures.h"
#include "meniscus/mesh_part.h"
#include "meniscus/page.h"
#include "meniscus/pocket_chemistry.h"
#include "meniscus/pockets.h"
#include "meniscus/tables.h"
#include "meniscus/threads.h"
#include "platform/files/atomic_file.h"
#include "standard_output.h"
#include "summary.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

bool has(const std::vector<Output>& outputs, OutputKind kind) {
    return std::any_of(outputs.begin(), outputs.end(), [kind](const Output& o) { return o.kind == kind; });
}

bool has_encoding(const Output& output) {
    const std::string suffix = suffix_of(output.path);
    return suffix == ".ply" || suffix == ".stl";
}

const Output* first_mesh(const std::vector<Output>& outputs) {
    const auto found = std::find_if(outputs.begin(), outputs.end(),
                                    [](const Output& output) { return output.kind == OutputKind::Mesh; });
    return found == outputs.end() ? nullptr : &*found;
}

/// Refuses options that write files beside a mesh that is not there, or that goes to standard output.
void check_files_beside(const SurfaceRequest& request, const Output* mesh) {
    if (mesh != nullptr && !is_standard_output(mesh->path)) return;
    const auto refuse = [mesh](const std::string& why) {
        throw UsageError(mesh == nullptr ? why + "; name a mesh with -o"
                                         : "-o -: " + why + "; name it with -o FILE.SUFFIX");
    };
    if (request.snapshots > 0) refuse("--snapshots writes meshes beside the final one");
    if (request.cavity_files) refuse("--cavity-files writes meshes beside that of the surface");
}

/// Refuses options that none of the outputs heeds.
void check_together(const SurfaceRequest& request, const std::vector<Output>& outputs) {
    check_files_beside(request, first_mesh(outputs));
    const bool has_page = has(outputs, OutputKind::Page);
    const bool has_picture = has(outputs, OutputKind::Picture);
    if (!request.show.empty() && !has_picture && !has_page && first_mesh(outputs) == nullptr)
        throw UsageError("--show chooses a part of meshes, pictures and pages; ask for one of them with -o");
    if (request.encoding == Encoding::Text && std::none_of(outputs.begin(), outputs.end(), has_encoding))
        throw UsageError("--ascii applies to PLY and STL; ask for one with -o FILE.ply or FILE.stl");
    check_drawn(request.picture, outputs);
}

std::vector<Colour> colours_of(const MeshPart& part, const std::vector<Colour>& colours) {
    std::vector<Colour> own;
    own.reserve(part.vertices.size());
    for (const VertexId v : part.vertices) own.push_back(colours[v]);
    return own;
}

/// The mesh that is written, where it is not the whole one (--show).
struct WrittenPart {
    Mesh mesh;
    std::vector<Colour> colours;
    ShownPart shown;
};

/// The wall of a cavity as a mesh of its own.
struct CavityFile {
    std::uint32_t component;
    Output output;
};

/// What is written beside meshes and tables.
struct Products {
    std::vector<CavityFile> cavities;
    Picture picture;
    Volumes volumes;
    std::string page;  // HTML
};

class SurfaceRun : public StructureRun {
public:
    explicit SurfaceRun(const SurfaceRequest& request)
        : StructureRun(request, request.run.threads), request_(request) {}

private:
    std::vector<Output> plan(const std::string& name, const std::string& mark) const override {
        std::vector<Output> outputs = plan_volumes(request_.volume, plan_outputs(request_.outputs, name, mark));
        if (!request_.history.empty()) outputs.push_back(plan_history(request_.history, mark));
        check_together(request_, outputs);
        return outputs;
    }

    std::vector<ReadFile> files_read() const override {
        std::vector<ReadFile> files;
        if (!request_.volume.grid_file.empty()) files.push_back({"the file of --grid", request_.volume.grid_file});
        for (const std::string& path : request_.values.tables) files.push_back({"the file of --values", path});
        for (const SampledMap& map : request_.values.maps) files.push_back({"the file of --sample", map.path});
        return files;
    }

    void compute(const Job& job) override {
        const SurfaceOptions& options = request_.surface;
        std::vector<bool> selected;
        if (!request_.show.empty()) {
            if (const std::string restated = restate_selection(job.structure, request_.show, "--show");
                !restated.empty())
                note("--show " + request_.show + ": understood as " + restated);
            selected = select_atoms(job.structure, request_.show, "--show");
        }
        values_ = ValueSources(request_.values, request_.picture.colours, job.structure, request_.per_chain);
        for (const std::string& line : values_.warnings()) warn(line);
        for (const std::string& line : values_.notes()) note(line);
        Stopwatch estimating;
        const bool has_volume = has(job.outputs, OutputKind::Volume);
        ExactSurface exact(job.structure.atoms, {options.surface, options.probe});
        VolumeGrid grid;
        if (shows_progress() || has_volume) {
            const Cost expected = estimate_cost(job.structure.atoms, options);
            if (has_volume) grid = choose_grid(job, exact, options.spacing, expected);
            refuse_what_would_not_fit(job.structure.atoms, options, expected, request_.run.memory_limit_mb);
            expect(expected.seconds);
        }
        const double estimate_seconds = estimating.lap();
        find_pockets(job);
        make_surface(job, std::move(exact));
        const SurfaceOptions& made = surface_.options;
        if (has_volume && made.spacing != options.spacing)
            grid = choose_grid(job, surface_.exact, made.spacing, surface_.expected);
        surface_.seconds.estimate += estimate_seconds;
        add_values();
        Stopwatch watch;
        colours_ = colour_vertices(surface_.mesh, job.structure, request_.picture.colours);
        if (!selected.empty()) show_part(part_of_atoms(surface_.mesh, selected));
        count_drawn(job);
        if (request_.cavity_files) plan_cavities(job);
        if (has(job.outputs, OutputKind::Picture)) draw(job.structure);
        seconds_.picture = watch.lap();
        if (has_volume) sample_volumes(grid);
        seconds_.volume = watch.lap();
        if (has(job.outputs, OutputKind::Page)) make_page(job.structure);
        seconds_.page = watch.lap();
    }

    /// Pages alone show ligands that belong to the surface: the reader may make it translucent.
    void count_drawn(const Job& job) {
        const Ligands& ligands = job.structure.ligands;
        const bool shown = ligands.in_surface ? has(job.outputs, OutputKind::Page) : draws_ligands(job.outputs);
        drawn_.clear();
        if (request_.picture.ligands && shown) drawn_ = count_ligands(ligands_near(ligands, written_mesh()));
    }

    VolumeGrid choose_grid(const Job& job, const ExactSurface& exact, double spacing, const Cost& expected) const {
        const VolumeGrid grid = find_grid(request_.volume, exact, spacing, job.outputs);
        refuse_grid_that_would_not_fit(grid, volumes_of(request_.volume), expected, request_.run.memory_limit_mb);
        return grid;
    }

    void make_surface(const Job& job, ExactSurface exact) {
        RunOptions run = request_.run;
        run.keep_exact = has(job.outputs, OutputKind::Picture) || has(job.outputs, OutputKind::Volume);
        run.progress = [this](std::string_view stage, double fraction) { show(stage, fraction); };
        if (request_.snapshots > 0)
            run.observer = [&](const FlowStep& step, const Mesh& mesh) { write_snapshot(job, step, mesh); };
        surface_ = meniscus::mesh(std::move(exact), request_.surface, run);
        Stopwatch watch;
        if (surface_.measured && request_.surface.surface == SurfaceKind::Sas && !request_.report.empty()) {
            const ThreadLimit limit(request_.run.threads);
            excluded_ = surface_.exact.of_same_atoms({SurfaceKind::Ses, request_.surface.probe}).shared_measures();
        }
        seconds_.exact = watch.lap();
    }

    /// Pockets are found once, for the colours of all meshes of a structure.
    void find_pockets(const Job& job) {
        pockets_.reset();
        if (request_.picture.colours.scheme != ColourScheme::Pocket) return;
        const PocketOptions options;
        of_pockets_ = as_ranked(job);
        const Structure& structure = of_pockets_ ? *of_pockets_ : job.structure;
        if (const std::string doubt = doubt_of_ranking(structure, options.spacing); !doubt.empty())
            note("--color pocket: " + doubt);
        RunOptions run = request_.run;
        run.observer = {};
        run.progress = [this](std::string_view, double fraction) { show("pockets", fraction); };
        pockets_ = meniscus::find_pockets(ExactSurface(structure.atoms), atom_classes(structure), options, run);
    }

    /// The atoms that `pockets` takes, where the surface has others and the input can be read again.
    std::optional<Structure> as_ranked(const Job& job) const {
        if (request_.input == "-" || job.structure.residues.empty() || doubt_of_ranking(job.structure, 1.0).empty())
            return std::nullopt;
        ReadOptions options = options_of_model(request_, job.model);
        options.radii = "united";
        options.hydrogens = HydrogenPolicy::Auto;
        options.hetero = HeteroPolicy::None;
        options.keep_waters = false;
        if (!job.chain.empty()) options.chains = {job.chain};
        try {
            return read_structure(request_.input, options);
        } catch (const InputError&) {  // of ligands alone nothing is left
            return std::nullopt;
        }
    }

    std::vector<VertexValues> values_at(const Mesh& mesh) const {
        std::vector<VertexValues> values = values_.at_vertices(mesh, surface_.exact);
        if (pockets_) values.push_back(pocket_values(*pockets_, mesh));
        return values;
    }

    void add_values() {
        std::vector<VertexValues>& values = surface_.mesh.values;
        values = values_.at_vertices(surface_.mesh, surface_.exact);
        for (const std::string& line : values_.judge(values)) warn(line);
        if (pockets_) values.push_back(pocket_values(*pockets_, surface_.mesh));
    }

    /// The mesh that is written.
    const Mesh& written_mesh() const { return part_ ? part_->mesh : surface_.mesh; }
    const std::vector<Colour>& written_colours() const { return part_ ? part_->colours : colours_; }

    void show_part(MeshPart part) {
        const MeshMeasures measures = measure_mesh(part.mesh);
        const ShownPart shown{.select = request_.show,
                              .vertices = part.mesh.vertices.size(),
                              .triangles = part.mesh.triangles.size(),
                              .area = measures.area,
                              .open = !measures.closed};
        std::vector<Colour> colours = colours_of(part, colours_);
        part_ = {std::move(part.mesh), std::move(colours), shown};
    }

    /// Lists the walls of cavities, by falling volume as everywhere, and the files that they are written to.
    void plan_cavities(const Job& job) {
        std::vector<CavityFile>& cavities = made_.cavities;
        cavities.clear();
        const std::vector<MeshComponent>& pieces = surface_.measures.components;
        for (std::size_t c = 0; c < pieces.size(); ++c) {
            if (pieces[c].volume >= 0.0) continue;
            const std::string path = cavity_path(first_mesh(job.outputs)->path, cavities.size() + 1);
            for (const Output& output : job.outputs)
                if (output.path == path)
                    throw UsageError(path + ": --cavity-files writes this file; choose another name");
            cavities.push_back({static_cast<std::uint32_t>(c), {path, OutputKind::Mesh}});
        }
    }

    /// computed_with   must outlive what is returned, as the structure and the colours must
    WriteOptions mesh_writing(const Structure& structure, const SurfaceOptions& computed_with,
                              std::span<const Colour> colours) const {
        return {.encoding = request_.encoding,
                .colours = colours,
                .structure = &structure,
                .computed_with = &computed_with,
                .probe = computed_with.probe,
                .threads = request_.run.threads};
    }

    void write_surface(const std::string& path, const Structure& structure) const {
        WriteOptions options = mesh_writing(structure, surface_.options, written_colours());
        options.shortest_edge = part_ ? 0.0 : surface_.measures.shortest_edge;
        options.open = part_ && part_->shown.open;
        const bool has_ligands = suffix_of(path) == ".glb" && request_.picture.ligands;
        const Bodies ligands =
            has_ligands ? ligand_bodies(structure.ligands, written_mesh(), written_colours()) : Bodies{};
        options.beside = &ligands;
        write_mesh(path, written_mesh(), options);
    }

    void write_cavities(const Job& job) const {
        for (const auto& [component, output] : made_.cavities) {
            const MeshPart part = part_of_component(surface_.mesh, component);
            const std::vector<Colour> colours = colours_of(part, colours_);
            write_mesh(output.path, part.mesh, mesh_writing(job.structure, surface_.options, colours));
        }
    }

    void sample_volumes(const VolumeGrid& grid) {
        show("volume", 0.0);
        made_.volumes = Volumes(request_.volume, grid, surface_, request_.run.threads);
        show("volume", 1.0);
    }

    void make_page(const Structure& structure) {
        show("page", 0.0);
        const PictureOptions& picture = request_.picture.picture;
        made_.page = meniscus::make_page(written_mesh(), structure,
                                         {.colours = request_.picture.colours,
                                          .viewpoint = picture.viewpoint,
                                          .projection = picture.projection,
                                          .ligands = request_.picture.ligands,
                                          .rows = rows_of_page(structure),
                                          .components = exact_pieces(),
                                          .pockets = listed_pockets(structure),
                                          .exact = surface_.exact,
                                          .threads = request_.run.threads});
        show("page", 1.0);
    }

    std::vector<PagePocket> listed_pockets(const Structure& structure) const {
        if (!pockets_) return {};
        return page_pockets(describe_pockets(*pockets_, of_pockets_ ? *of_pockets_ : structure));
    }

    std::span<const SurfaceComponent> exact_pieces() const {
        if (!surface_.measured) return {};
        return surface_.measured->components;
    }

    std::vector<PageRow> rows_of_page(const Structure& structure) const {
        std::vector<PageRow> rows =
            surface_.measured ? page_rows(structure, surface_, *surface_.measured) : page_rows(structure, surface_);
        if (part_) rows.push_back({"Part that is shown", "atoms", part_->shown.select});
        return rows;
    }

    void write_made_page(const std::string& path) const {
        AtomicFile file(path);
        file.write(made_.page);
        file.commit();
    }

    void draw(const Structure& structure) {
        show("picture", 0.0);
        PictureOptions options = request_.picture.picture;
        options.threads = request_.run.threads;
        made_.picture = draw_surface(surface_, structure, {written_mesh(), written_colours()},
                                     {.picture = options,
                                      .scheme = request_.picture.colours,
                                      .legend = request_.picture.legend,
                                      .ligands = request_.picture.ligands,
                                      .whole = &surface_.mesh});
        show("picture", 1.0);
    }

    void write_snapshot(const Job& job, const FlowStep& step, const Mesh& mesh) const {
        if (step.step % request_.snapshots != 0) return;
        {
            const WritingSection section;
            Mesh complete = mesh;
            complete.values = values_at(mesh);
            const std::vector<Colour> colours = colour_vertices(complete, job.structure, request_.picture.colours);
            write_mesh(snapshot_path(first_mesh(job.outputs)->path, step.step), complete,
                       mesh_writing(job.structure, request_.surface, colours));
        }
        throw_if_interrupted();
    }

    void write(const Output& output, const Job& job) const override {
        switch (output.kind) {
            case OutputKind::Mesh:
                write_surface(output.path, job.structure);
                if (&output == first_mesh(job.outputs)) write_cavities(job);
                return;
            case OutputKind::Picture:
                return write_picture(output.path, made_.picture);
            case OutputKind::Page:
                return write_made_page(output.path);
            case OutputKind::Volume:
                return made_.volumes.write(output.path);
            case OutputKind::History:
                return write_table(output.path, history_table(surface_.history));
            case OutputKind::Spheres:
                return write_spheres(output.path, job.structure);
            default:
                return write_atom_table(output.path, job.structure);
        }
    }

    RunFacts facts() const override {
        RunFacts facts{.seconds = seconds_, .checks = surface_.checks};
        if (part_) facts.shown = part_->shown;
        facts.values = values_.numbers(surface_.mesh);
        facts.excluded = excluded_;
        facts.drawn = drawn_;
        if (surface_.measured) facts.checks.push_back(agreement_check(*surface_.measured));
        return facts;
    }

    std::string failed() const override { return failed_checks(surface_); }

    ordered_json report(const Job& job, const RunFacts& facts) const override {
        return make_report(request_, job.structure, surface_, facts);
    }

    std::string summary(const Job& job, const RunFacts& facts) const override {
        std::vector<Output> written = job.outputs;
        for (const CavityFile& cavity : made_.cavities) written.push_back(cavity.output);
        return make_summary(job.structure, surface_, facts, written);
    }

    const SurfaceRequest& request_;
    ValueSources values_;
    std::optional<Pockets> pockets_;       // with --color pocket
    std::optional<Structure> of_pockets_;  // whose pockets these are, where it is not the surface's
    // Of the SES, where the mesh is of another surface and the report has both.
    std::shared_ptr<const Measures> excluded_;
    Surface surface_;
    std::vector<Colour> colours_;               // of the mesh's vertices
    std::map<std::string, std::size_t> drawn_;  // ligands, by name
    std::optional<WrittenPart> part_;
    Products made_;
    RunSeconds seconds_;
};

}  // namespace

void add_surface_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("surface", "The surface as a mesh, picture and report");
    const auto request = std::make_shared<SurfaceRequest>();
    add_surface_options(*command, *request);
    command->callback([request, &outcome] {
        resolve_standard_output(*request, request->encoding == Encoding::Text);
        outcome = run_surface(*request);
    });
}

Outcome run_surface(const SurfaceRequest& request) { return SurfaceRun(request)(); }

}  // namespace meniscus::cli
