// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <pybind11/stl.h>

#include <chrono>
#include <string_view>

#include "arrays.h"
#include "bindings.h"
#include "by_threads.h"
#include "meniscus/colours.h"
#include "meniscus/sample.h"
#include "options.h"
#include "pickling.h"

namespace meniscus::python {

namespace {

using namespace py::literals;

SurfaceOptions surface_options(const py::dict& given) {
    SurfaceOptions options;
    OptionReader read(given);
    describe(options, read);
    options.remesh.finer_grid = !Options(given).has("spacing");
    if (Options(given).has("edge") && Options(given).has("vertex_density"))
        throw UsageError("edge and vertex_density set the same thing; give one of them");
    for (const Option& option : read.changed()) refuse_without_effect(option, options, spell_as_keyword);
    return options;
}

RunOptions run_options(const py::dict& given) {
    RunOptions run;
    describe(run, OptionReader(given));
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

std::shared_ptr<Surface> mesh_of(const ExactSurface& exact, const py::dict& given, const py::object& progress) {
    const SurfaceOptions options = surface_options(given);
    RunOptions run = run_options(given);
    Watcher watcher(progress);
    run.progress = [&watcher](std::string_view stage, double fraction) { watcher(stage, fraction); };
    const py::gil_scoped_release release;
    auto surface = std::make_shared<Surface>(mesh(exact, options, run));
    refuse_large_indices(surface->mesh);
    return surface;
}

/// Of the exact surface that the bytes leave out.
std::shared_ptr<Surface> surface_of_bytes(const py::bytes& bytes, const ExactSurface& exact) {
    auto surface = std::make_shared<Surface>(from_bytes<Surface>(bytes));
    surface->exact = exact;
    return surface;
}

py::array depths(const Mesh& mesh, const ExactSurface& exact, int threads) {
    return owning(by_threads(threads, [&] { return depth_values(mesh, exact).values; }));
}

py::dict percentiles(const Percentiles& p) {
    return py::dict("min"_a = p.min, "p5"_a = p.p5, "p50"_a = p.p50, "p95"_a = p.p95, "max"_a = p.max);
}

py::dict distances(const DistanceSummary& d) { return py::dict("mean"_a = d.mean, "p99"_a = d.p99, "max"_a = d.max); }

/// The block `mesh` of the report.
py::dict mesh_dict(const Surface& s) {
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
py::object flow_dict(const Surface& s) {
    if (s.options.method != Method::Flow) return py::none();
    const FlowSummary& f = s.flow;
    return py::dict("steps"_a = f.steps, "time"_a = f.time, "converged"_a = f.converged, "residual"_a = f.residual,
                    "mean_distance"_a = f.mean_distance, "max_distance"_a = f.max_distance,
                    "solver_iterations"_a = f.solver_iterations, "initial_area"_a = f.initial_area,
                    "reinitialisations"_a = f.reinitialisations, "end"_a = word_for(kFlowEndWords, f.end),
                    "kept_step"_a = f.kept_step, "explanation"_a = f.explanation,
                    "history"_a = history_list(s.history));
}

py::list checks_list(const Surface& s) {
    py::list list;
    for (const Check& c : s.checks)
        list.append(py::dict("name"_a = c.name, "passed"_a = c.passed, "value"_a = c.value, "bound"_a = c.bound));
    return list;
}

/// Φ, or where there is no level set the exact signed distance.
py::array values(const Surface& surface, const Positions& points, int threads) {
    const std::span<const Vec3> places = points_of(points);
    return owning(by_threads(threads, [&] {
        return surface.level_set ? surface.level_set->values(places) : surface.exact.signed_distance(places);
    }));
}

py::array gradients(const Surface& surface, const Positions& points, int threads) {
    const std::span<const Vec3> places = points_of(points);
    return owning(by_threads(threads, [&] {
        if (surface.level_set) return surface.level_set->gradients(places);
        std::vector<Vec3> normals;
        for (const NearestFeature& at : surface.exact.nearest_features(places)) normals.push_back(at.normal);
        return normals;
    }));
}

Mesh sample(const Surface& surface, double density, std::uint64_t seed, int threads) {
    const py::gil_scoped_release release;
    return sample_surface(surface, {.density = density, .seed = seed, .threads = threads});
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
    py::class_<Surface, std::shared_ptr<Surface>> type(module, "Surface");
    type.def_readonly("mesh", &Surface::mesh);
    type.def_property_readonly("mesh_block", &mesh_dict);
    type.def_property_readonly("flow_block", &flow_dict);
    type.def_property_readonly("checks", &checks_list);
    type.def_property_readonly("passed", &Surface::passed);
    type.def("values", &values, py::arg("points"), py::arg("threads"));
    type.def("gradients", &gradients, py::arg("points"), py::arg("threads"));
    type.def("sample", &sample, py::arg("density"), py::arg("seed"), py::arg("threads"));
    type.def("to_bytes", &to_bytes<Surface>);
    module.def("surface_of_bytes", &surface_of_bytes, py::arg("bytes"), py::arg("exact"));
    module.def("depth_values", &depths, py::arg("mesh"), py::arg("exact"), py::arg("threads"));
    module.def("mesh", &mesh_of, py::arg("exact"), py::arg("options"), py::arg("progress"));
}

}  // namespace meniscus::python
