// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/exact_surface.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "by_threads.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "options.h"

namespace meniscus::python {

namespace {

ExactOptions exact_options(const py::dict& given) {
    const Options options(given);
    ExactOptions exact;
    options.read_word("surface", exact.kind, kSurfaceWords);
    options.read("probe", exact.probe);
    return exact;
}

std::shared_ptr<ExactSurface> of_structure(const Structure& structure, const py::dict& given) {
    return std::make_shared<ExactSurface>(structure.atoms, exact_options(given));
}

std::shared_ptr<ExactSurface> of_same_atoms(const ExactSurface& exact, const py::dict& given) {
    return std::make_shared<ExactSurface>(exact.of_same_atoms(exact_options(given)));
}

/// The surface's own; nobody changes what Python holds of them.
std::shared_ptr<Measures> measures(const ExactSurface& exact, int threads) {
    return by_threads(threads, [&] { return std::const_pointer_cast<Measures>(exact.shared_measures()); });
}

py::array signed_distance(const ExactSurface& exact, const Positions& points, int threads) {
    const std::span<const Vec3> places = points_of(points);
    return given_away(by_threads(threads, [&] { return exact.signed_distance(places); }));
}

template <class T>
py::array member_of_all(const std::vector<NearestFeature>& features, T NearestFeature::*member) {
    std::vector<T> values;
    values.reserve(features.size());
    for (const NearestFeature& feature : features) values.push_back(feature.*member);
    return owning(std::move(values));
}

py::dict nearest(const ExactSurface& exact, const Positions& points, int threads) {
    using namespace py::literals;
    const std::span<const Vec3> places = points_of(points);
    const std::vector<NearestFeature> found = by_threads(threads, [&] { return exact.nearest_features(places); });
    return py::dict("distance"_a = member_of_all(found, &NearestFeature::signed_distance),
                    "atom"_a = member_of_all(found, &NearestFeature::atom),
                    "patch"_a = member_of_all(found, &NearestFeature::patch),
                    "normal"_a = member_of_all(found, &NearestFeature::normal),
                    "mean_curvature"_a = member_of_all(found, &NearestFeature::mean_curvature),
                    "gaussian_curvature"_a = member_of_all(found, &NearestFeature::gaussian_curvature),
                    "foot"_a = member_of_all(found, &NearestFeature::foot));
}

}  // namespace

void bind_exact_surface(py::module_& module) {
    py::class_<ExactSurface, std::shared_ptr<ExactSurface>> type(module, "ExactSurface");
    type.def("of_same_atoms", &of_same_atoms, py::arg("options"));
    type.def("measures", &measures, py::arg("threads"));
    type.def("signed_distance", &signed_distance, py::arg("points"), py::arg("threads"));
    type.def("nearest", &nearest, py::arg("points"), py::arg("threads"));
    module.def("exact_surface", &of_structure, py::arg("structure"), py::arg("options"));
}

}  // namespace meniscus::python
