// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/volume_origins.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace meniscus {
namespace {

constexpr double kFarApart = 1e4;  // Å: no structure is larger, and 1e-10 Å² off in ∮ n are 1e-7 relative here

constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

// Cuts a list of atoms at every slab that has none, along each axis in turn, until none of them finds one.
class Clusters {
public:
    Clusters(const std::vector<Vec3>& centres, double gap) : centres_(centres), gap_(gap), cluster_(centres.size()) {
        std::vector<std::uint32_t> all(centres.size());
        std::iota(all.begin(), all.end(), 0U);
        todo_.push_back({all, 0, 0});
        while (!todo_.empty()) {
            const Part part = std::move(todo_.back());
            todo_.pop_back();
            cut(part);
        }
    }

    std::size_t count() const { return count_; }
    std::vector<std::uint32_t> take() { return std::move(cluster_); }

private:
    struct Part {
        std::vector<std::uint32_t> atoms;
        int axis;
        int uncut;  // axes in a row along which there was no slab
    };

    void cut(Part part) {
        if (part.uncut == 3) return keep(part);
        const double Vec3::*axis = kAxes[part.axis];
        std::sort(part.atoms.begin(), part.atoms.end(), [&](std::uint32_t a, std::uint32_t b) {
            const double of_a = centres_[a].*axis;
            const double of_b = centres_[b].*axis;
            return of_a != of_b ? of_a < of_b : a < b;
        });
        std::vector<std::size_t> begins{0};
        for (std::size_t i = 1; i < part.atoms.size(); ++i)
            if (centres_[part.atoms[i]].*axis - centres_[part.atoms[i - 1]].*axis > gap_) begins.push_back(i);
        begins.push_back(part.atoms.size());
        const int uncut = begins.size() == 2 ? part.uncut + 1 : 0;
        for (std::size_t b = 0; b + 1 < begins.size(); ++b) {
            const auto atoms = std::span(part.atoms).subspan(begins[b], begins[b + 1] - begins[b]);
            todo_.push_back({{atoms.begin(), atoms.end()}, (part.axis + 1) % 3, uncut});
        }
    }

    void keep(const Part& part) {
        for (const std::uint32_t atom : part.atoms) cluster_[atom] = static_cast<std::uint32_t>(count_);
        ++count_;
    }

    const std::vector<Vec3>& centres_;
    double gap_;
    std::vector<Part> todo_;
    std::vector<std::uint32_t> cluster_;
    std::size_t count_ = 0;
};

}  // namespace

VolumeOrigins::VolumeOrigins(const AccessibleSurface::Data& data) {
    const std::vector<Vec3>& centres = data.atoms.centres;
    Box box;
    for (const Vec3& centre : centres) box.include(centre);
    const Vec3 size = box.high - box.low;
    if (std::max({size.x, size.y, size.z}) < kFarApart) {
        origins_.push_back(box.middle());
        return;
    }
    // Probes that touch atoms farther apart than this do not overlap.
    Clusters clusters(centres, 4.0 * data.rho_max);
    std::vector<Box> boxes(clusters.count());
    cluster_ = clusters.take();
    for (std::size_t i = 0; i < centres.size(); ++i) boxes[cluster_[i]].include(centres[i]);
    for (const Box& b : boxes) origins_.push_back(b.middle());
}

}  // namespace meniscus
