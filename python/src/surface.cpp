// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <pybind11/stl.h>

#include <chrono>
#include <string_view>

#include "arrays.h"
#include "bindings.h"
#include "held_surface.h"
#include "meniscus/colours.h"
#include "meniscus/sample.h"
#include "meniscus/threads.h"
#include "options.h"
#include "pickling.h"

namespace meniscus::python {

namespace {

using namespace py::literals;

constexpr Words<const FlowOptions*, 3> kFlows{
    {{"anchored", &kAnchoredFlow}, {"parallel", &kParallelFlow}, {"paper", &kPaperFlow}}};

FlowOptions flow_options(const Options& options) {
    const FlowOptions* named = &kAnchoredFlow;
    options.read_word("flow", named, kFlows);
    FlowOptions flow = *named;
    options.read_word("curvature", flow.curvature, kCurvatureWords);
    options.read("anchor", flow.anchor);
    options.read_word("reinitialise", flow.reinitialiser, kReinitialiserWords);
    options.read_word("solver", flow.solver, kSolverWords);
    options.read_word("slope", flow.slope, kSlopeWords);
    options.read("time_step", flow.time_step);
    options.read("half_width", flow.half_width);
    options.read("max_steps", flow.max_steps);
    options.read("tolerance", flow.tolerance);
    return flow;
}

RemeshOptions remesh_options(const Options& options) {
    RemeshOptions remesh;
    double density = 0.0;
    options.read("edge", remesh.edge);
    options.read("vertex_density", density);
    if (density > 0.0) remesh.edge = edge_of_density(density);
    options.read("adaptive", remesh.adaptive);
    options.read("keep_ridges", remesh.keep_ridges);
    options.read_word("corners", remesh.corners, kCornersWords);
    options.read("simplify_topology", remesh.simplify_topology);
    options.read("finer_grid", remesh.finer_grid);
    return remesh;
}

SurfaceOptions surface_options(const Options& options) {
    SurfaceOptions surface;
    options.read_word("method", surface.method, kMethodWords);
    options.read_word("surface", surface.surface, kSurfaceWords);
    options.read("probe", surface.probe);
    options.read("spacing", surface.spacing);
    options.read("density", surface.density);
    surface.flow = flow_options(options);
    surface.remesh = remesh_options(options);
    options.read_word("components", surface.pieces, kPiecesWords);
    options.read("min_cavity", surface.min_cavity);
    options.read("fill_cavities", surface.fill_cavities);
    options.read("history", surface.history);
    options.read("initial_area", surface.initial_area);
    options.read("quality", surface.quality);
    options.read("two_sided_distance", surface.two_sided_distance);
    options.read("verify", surface.verify);
    return surface;
}

RunOptions run_options(const Options& options) {
    RunOptions run;
    options.read("threads", run.threads);
    options.read("memory_mb", run.memory_limit_mb);
    return run;
}

/// Lets Python look for Ctrl-C, and calls whoever wants to know, a few times per second.
class Watcher {
public:
    explicit Watcher(py::object callback) : callback_(std::move(callback)) {}

    void operator()(std::string_view stage, double fraction) {
        const auto now = std::chrono::steady_clock::now();
        const bool ended = fraction >= 1.0 && !callback_.is_none();
        if (!ended && now - last_ < std::chrono::milliseconds(50)) return;
        last_ = now;
        const py::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!callback_.is_none()) callback_(py::str(stage.data(), stage.size()), fraction);
    }

private:
    py::object callback_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::shared_ptr<HeldSurface> compute(const std::shared_ptr<Structure>& structure, const py::dict& given,
                                     const py::object& progress) {
    const SurfaceOptions options = surface_options(Options(given));
    RunOptions run = run_options(Options(given));
    Watcher watcher(progress);
    run.progress = [&watcher](std::string_view stage, double fraction) { watcher(stage, fraction); };
    const py::gil_scoped_release release;
    Surface surface = compute_surface(structure->atoms, options, run);
    refuse_large_indices(surface.mesh);
    return std::make_shared<HeldSurface>(HeldSurface{structure, std::move(surface), run.threads});
}

/// The structure as an object of its own, so that a pickle holds it once, whoever else refers to it.
py::tuple surface_state(const HeldSurface& held) {
    return py::make_tuple(std::const_pointer_cast<Structure>(held.structure), to_bytes(held.surface));
}

std::shared_ptr<HeldSurface> surface_of_state(const py::tuple& state) {
    if (state.size() != 2) throw InputError("this is no pickle of a surface");
    const auto structure = state[0].cast<std::shared_ptr<Structure>>();
    Surface surface = from_bytes<Surface>(state[1].cast<py::bytes>());
    surface.exact = ExactSurface(structure->atoms, {surface.options.surface, surface.options.probe});
    return std::make_shared<HeldSurface>(HeldSurface{structure, std::move(surface)});
}

py::array depths(const Mesh& mesh, const Structure& structure, int threads) {
    VertexValues values;
    {
        const py::gil_scoped_release release;
        const ThreadLimit limit(threads);
        values = depth_values(mesh, ExactSurface(structure.atoms));
    }
    return owning(std::move(values.values));
}

py::dict percentiles(const Percentiles& p) {
    return py::dict("min"_a = p.min, "p5"_a = p.p5, "p50"_a = p.p50, "p95"_a = p.p95, "max"_a = p.max);
}

py::dict distances(const DistanceSummary& d) { return py::dict("mean"_a = d.mean, "p99"_a = d.p99, "max"_a = d.max); }

/// The block `mesh` of the report.
py::dict mesh_dict(const HeldSurface& held) {
    const Surface& s = held.surface;
    const MeshMeasures& m = s.measures;
    py::dict block("vertices"_a = s.mesh.vertices.size(), "triangles"_a = s.mesh.triangles.size(), "area"_a = m.area,
                   "volume"_a = m.volume, "corrected_area"_a = s.corrected_area,
                   "corrected_volume"_a = s.corrected_volume, "closed"_a = m.closed, "manifold"_a = m.manifold,
                   "components"_a = m.components.size(), "euler_characteristic"_a = m.euler_characteristic,
                   "mean_distance"_a = s.distance.mean, "p99_distance"_a = s.distance.p99,
                   "max_distance"_a = s.distance.max, "smallest_triangle_angle_deg"_a = m.smallest_angle_deg);
    block["dropped"] = py::dict("cavities"_a = s.dropped.cavities, "islands"_a = s.dropped.islands);
    block["filled"] =
        py::dict("cavities"_a = s.filled.cavities, "islands"_a = s.filled.islands, "volume"_a = s.filled.volume);
    block["simplified"] = py::dict("handles"_a = s.simplified.handles, "pieces"_a = s.simplified.pieces);
    block["self_intersections"] = py::cast(s.self_intersections);
    block["quality"] = py::none();
    if (s.quality)
        block["quality"] = py::dict(
            "angle_histogram"_a = s.quality->angles, "smallest_angles_deg"_a = percentiles(s.quality->smallest_angles),
            "edges"_a = percentiles(s.quality->edges), "aspect_ratios"_a = percentiles(s.quality->aspect_ratios));
    block["two_sided_distance"] = py::none();
    if (s.two_sided)
        block["two_sided_distance"] = py::dict("to_exact"_a = distances(s.two_sided->to_exact),
                                               "from_exact"_a = distances(s.two_sided->from_exact));
    return block;
}

py::list history_list(const std::vector<FlowStep>& history) {
    py::list list;
    for (const FlowStep& s : history)
        list.append(py::dict("step"_a = s.step, "time"_a = s.time, "area"_a = s.area, "volume"_a = s.volume,
                             "mean_distance"_a = s.mean_distance, "max_distance"_a = s.max_distance,
                             "residual"_a = s.residual, "solver_iterations"_a = s.solver_iterations,
                             "components"_a = s.components, "genus"_a = s.genus));
    return list;
}

/// The block `flow` of the report; None for other methods.
py::object flow_dict(const HeldSurface& held) {
    const Surface& s = held.surface;
    if (s.options.method != Method::Flow) return py::none();
    const FlowSummary& f = s.flow;
    return py::dict("steps"_a = f.steps, "time"_a = f.time, "converged"_a = f.converged, "residual"_a = f.residual,
                    "mean_distance"_a = f.mean_distance, "max_distance"_a = f.max_distance,
                    "solver_iterations"_a = f.solver_iterations, "initial_area"_a = f.initial_area,
                    "reinitialisations"_a = f.reinitialisations, "end"_a = word_for(kFlowEndWords, f.end),
                    "kept_step"_a = f.kept_step, "explanation"_a = f.explanation,
                    "history"_a = history_list(s.history));
}

py::list checks_list(const HeldSurface& held) {
    py::list list;
    for (const Check& c : held.surface.checks)
        list.append(py::dict("name"_a = c.name, "passed"_a = c.passed, "value"_a = c.value, "bound"_a = c.bound));
    return list;
}

/// Φ, or where there is no level set the exact signed distance.
py::array values(const HeldSurface& held, const Positions& points) {
    const std::span<const Vec3> places = points_of(points);
    std::vector<double> result;
    {
        const py::gil_scoped_release release;
        const ThreadLimit limit(held.threads);
        const auto& level_set = held.surface.level_set;
        result = level_set ? level_set->values(places) : held.surface.exact.signed_distance(places);
    }
    return owning(std::move(result));
}

py::array gradients(const HeldSurface& held, const Positions& points) {
    const std::span<const Vec3> places = points_of(points);
    std::vector<Vec3> result;
    {
        const py::gil_scoped_release release;
        if (const auto& level_set = held.surface.level_set)
            result = level_set->gradients(places);
        else
            for (const NearestFeature& at : held.surface.exact.nearest_features(places)) result.push_back(at.normal);
    }
    return owning(std::move(result));
}

Mesh sample(const HeldSurface& held, double density, std::uint64_t seed, int threads) {
    const py::gil_scoped_release release;
    return sample_surface(held.surface, {.density = density, .seed = seed, .threads = threads});
}

void bind_mesh(py::module_& module) {
    py::class_<Mesh, std::shared_ptr<Mesh>> type(module, "Mesh");
    const auto def_array = [&type](const char* name, auto member) {
        type.def_property_readonly(name, [member](const py::object& self) {
            return view(std::span(std::as_const(self.cast<const Mesh&>().*member)), self);
        });
    };
    def_array("vertices", &Mesh::vertices);
    def_array("triangles", &Mesh::triangles);
    type.def_property_readonly("normals", [](const Mesh& mesh) {
        return owning(std::vector<Vec3>(mesh.normals.begin(), mesh.normals.end()));
    });
    def_array("atom", &Mesh::atoms);
    def_array("patch", &Mesh::patches);
    def_array("component", &Mesh::components);
    def_array("area", &Mesh::areas);
    def_array("mean_curvature", &Mesh::mean_curvatures);
    def_array("gaussian_curvature", &Mesh::gaussian_curvatures);
    def_array("shape_index", &Mesh::shape_indices);
    def_pickle<Mesh>(type);
}

}  // namespace

void bind_surface(py::module_& module) {
    bind_mesh(module);
    py::class_<HeldSurface, std::shared_ptr<HeldSurface>> type(module, "Surface");
    type.def_property_readonly(
        "mesh", [](const HeldSurface& held) -> const Mesh& { return held.surface.mesh; },
        py::return_value_policy::reference_internal);
    type.def_property_readonly("mesh_block", &mesh_dict);
    type.def_property_readonly("flow_block", &flow_dict);
    type.def_property_readonly("checks", &checks_list);
    type.def_property_readonly("passed", [](const HeldSurface& held) { return held.surface.passed(); });
    type.def_property_readonly("has_level_set",
                               [](const HeldSurface& held) { return held.surface.level_set != nullptr; });
    type.def(py::pickle(&surface_state, &surface_of_state));
    type.def("values", &values, py::arg("points"));
    type.def("gradients", &gradients, py::arg("points"));
    type.def("sample", &sample, py::arg("density"), py::arg("seed"), py::arg("threads"));
    module.def("depth_values", &depths, py::arg("mesh"), py::arg("structure"), py::arg("threads"));
    module.def("compute_surface", &compute, py::arg("structure"), py::arg("options"), py::arg("progress"));
}

}  // namespace meniscus::python
