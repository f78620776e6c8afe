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
#include "result_dict.h"

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

/// throws   as mesh_of() does for the same options
void check_surface_options(const py::dict& given) { surface_options(given); }

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

/// Found once.
std::shared_ptr<const Measures> exact_measures(const Surface& surface, int threads) {
    return by_threads(threads, [&] { return surface.exact.shared_measures(); });
}

/// The block `mesh` of the report, with deviations from the exact measures.
py::dict mesh_dict(const Surface& surface, int threads) {
    DictVisitor visit;
    describe_mesh(surface, exact_measures(surface, threads).get(), visit);
    visit({"self_intersections", "", "also without the shapes of triangles"}, surface.self_intersections);
    return visit.dict();
}

/// The block `flow` of the report; None for other methods.
py::object flow_dict(const Surface& surface) {
    if (surface.options.method != Method::Flow) return py::none();
    DictVisitor visit;
    describe_flow(surface, visit);
    return visit.dict();
}

/// The check of the report that is of the exact measures.
py::dict exact_check(const Surface& surface, int threads) {
    return dict_of(agreement_check(*exact_measures(surface, threads)));
}

/// Φ, or where there is no level set the exact signed distance.
py::array values(const Surface& surface, const Positions& points, int threads) {
    const std::span<const Vec3> places = points_of(points);
    return given_away(by_threads(threads, [&] {
        return surface.level_set ? surface.level_set->values(places) : surface.exact.signed_distance(places);
    }));
}

py::array gradients(const Surface& surface, const Positions& points, int threads) {
    const std::span<const Vec3> places = points_of(points);
    return given_away(by_threads(threads, [&] {
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
    type.def("mesh_block", &mesh_dict, py::arg("threads"));
    type.def_property_readonly("area", [](const Surface& s) { return s.measures.area; });
    type.def_property_readonly("flow_block", &flow_dict);
    type.def_property_readonly("mesh_checks", [](const Surface& s) { return dicts_of(s.checks); });
    type.def("exact_check", &exact_check, py::arg("threads"));
    type.def("values", &values, py::arg("points"), py::arg("threads"));
    type.def("gradients", &gradients, py::arg("points"), py::arg("threads"));
    type.def("sample", &sample, py::arg("density"), py::arg("seed"), py::arg("threads"));
    type.def("to_bytes", &to_bytes<Surface>);
    module.def("surface_of_bytes", &surface_of_bytes, py::arg("bytes"), py::arg("exact"));
    module.def("depth_values", &depths, py::arg("mesh"), py::arg("exact"), py::arg("threads"));
    module.def("check_surface_options", &check_surface_options, py::arg("options"));
    module.def("mesh", &mesh_of, py::arg("exact"), py::arg("options"), py::arg("progress"));
}

}  // namespace meniscus::python
