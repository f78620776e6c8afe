// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Prints checksums of all that core makes of spheres, so that builds for other machines, compilers and thread libraries
// can be compared bit by bit. It uses nothing but the library `core`.
//
// usage: checksums FILE.xyzr ...      "x y z r" per line
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <type_traits>
#include <vector>

#include "meniscus/field.h"
#include "meniscus/sample.h"
#include "meniscus/surface.h"

namespace {

using namespace meniscus;

/// FNV-1a over the bytes of numbers.
class Checksum {
public:
    template <class T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
        std::uint8_t bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (const std::uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3;
    }
    void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
    template <class T>
    void add(const std::vector<T>& values) {
        for (const T& value : values) add(value);
    }
    unsigned long long value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

Atoms read_spheres(const char* path) {
    Atoms atoms;
    std::FILE* file = std::fopen(path, "r");
    Vec3 centre;
    double radius = 0.0;
    while (file != nullptr &&
           std::fscanf(file, "%lf %lf %lf %lf%*[^\n]", &centre.x, &centre.y, &centre.z, &radius) == 4) {
        atoms.centres.push_back(centre);
        atoms.radii.push_back(radius);
    }
    if (file != nullptr) std::fclose(file);
    return atoms;
}

void print(const char* what, const Checksum& checksum) { std::printf("  %-24s %016llx\n", what, checksum.value()); }

void print_mesh(const char* what, const Mesh& mesh) {
    Checksum places;
    places.add(mesh.vertices);
    places.add(mesh.triangles);
    Checksum values;
    for (const SmallVec3& normal : mesh.normals) values.add(Vec3(normal));
    values.add(mesh.atoms);
    for (const PatchKind patch : mesh.patches) values.add(static_cast<std::uint8_t>(patch));
    values.add(mesh.components);
    values.add(mesh.areas);
    values.add(mesh.mean_curvatures);
    values.add(mesh.gaussian_curvatures);
    values.add(mesh.shape_indices);
    std::printf("  %-24s %016llx %016llx  %zu vertices\n", what, places.value(), values.value(), mesh.vertices.size());
}

void print_measures(const Measures& measures) {
    Checksum totals;
    for (const double total : {measures.totals.sas_area, measures.totals.sas_volume, measures.totals.ses_area,
                               measures.totals.ses_volume, measures.totals.toroidal_area})
        totals.add(total);
    print("exact totals", totals);
    Checksum errors;
    for (const double error : {measures.errors.sas_area, measures.errors.ses_area, measures.errors.ses_volume})
        errors.add(error);
    print("errors", errors);
    Checksum atoms;
    for (const AtomMeasure& atom : measures.atoms) atoms.add(atom.ses_area());
    print("atoms", atoms);
    Checksum pieces;
    for (const SurfaceComponent& piece : measures.components) pieces.add(piece.ses_volume);
    print("pieces", pieces);
    std::printf("  %-24s %.17g %.17g\n", "exact area, volume", measures.totals.ses_area, measures.totals.ses_volume);
}

void print_surfaces(const Atoms& atoms) {
    const ExactSurface exact(atoms);
    print_measures(exact.measures());
    Checksum distances;
    distances.add(exact.signed_distance(atoms.centres));
    print("distances", distances);
    const Surface direct = mesh(exact, {.method = Method::Direct});
    print_mesh("direct", direct.mesh);
    const Surface flow = mesh(exact, {.method = Method::Flow, .quality = true});
    print_mesh("flow", flow.mesh);
    print_mesh("gaussian", mesh(exact, {.method = Method::Gaussian}).mesh);
    print_mesh("even triangles", mesh(exact, {.method = Method::Direct, .remesh = {.edge = 1.5}}).mesh);
    print_mesh("sample", sample_surface(direct, {.density = 0.2}));
    Checksum field;
    field.add(surface_field(flow, enclosing_grid(exact, 2.0)).values);
    print("field", field);
}

}  // namespace

int main(int count, char** paths) {
    for (int i = 1; i < count; ++i) {
        const Atoms atoms = read_spheres(paths[i]);
        const char* const slash = std::strrchr(paths[i], '/');
        std::printf("%s, %zu spheres\n", slash != nullptr ? slash + 1 : paths[i], atoms.size());
        if (atoms.empty()) return 1;
        print_surfaces(atoms);
    }
    return 0;
}
