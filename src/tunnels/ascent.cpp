// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/ascent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr double kLongestStep = 0.5;     // Å
constexpr double kReach = 8.0;           // Å: a slope of one sixteenth is climbed by the longest steps
constexpr double kBand = 2.0;            // Å beyond the clearance: atoms that are listed at once
constexpr double kShortestStep = 1e-12;  // Å
constexpr std::size_t kMostHeld = 12;    // more than the four atoms of a general maximum: atoms of a symmetric one
// Added to the diagonal: atoms on a circle round the point have vectors that depend on each other.
constexpr double kRidge = 1e-10;

using Matrix = std::array<std::array<double, kMostHeld + 2>, kMostHeld + 1>;

// Gauss elimination of `rows` equations with the right side in the column after the last one.
bool solve(Matrix& m, std::size_t rows) {
    for (std::size_t c = 0; c < rows; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < rows; ++r)
            if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
        if (m[pivot][c] == 0.0) return false;
        std::swap(m[c], m[pivot]);
        for (std::size_t r = 0; r < rows; ++r) {
            if (r == c) continue;
            const double factor = m[r][c] / m[c][c];
            for (std::size_t k = c; k <= rows; ++k) m[r][k] -= factor * m[c][k];
        }
    }
    for (std::size_t r = 0; r < rows; ++r) m[r][rows] /= m[r][r];
    return true;
}

// The dual of the step: weights λ >= 0 with sum 1 of the atoms that hold the step back minimise
// reach/2 |Σ λ away|² + Σ λ clearance, and the step is reach Σ λ away. Solved by an active set, as Wolfe 1976,
// "Finding the nearest point in a polytope".
class HeldStep {
public:
    HeldStep(std::span<const AtomView> atoms, double reach) : atoms_(atoms), reach_(reach) {}

    Vec3 find() {
        add(least({}));
        weights_[0] = 1.0;
        double dual = value();
        Vec3 best = step();
        for (int round = 0; round < 64 && count_ < kMostHeld; ++round) {
            const std::size_t next = least(step());
            if (is_held(next)) break;
            add(next);
            if (!improve() || !(value() < dual)) break;
            dual = value();
            if (gain(step()) > gain(best)) best = step();
        }
        return best;
    }

private:
    double after(std::size_t atom, const Vec3& d) const { return atoms_[atom].clearance + dot(atoms_[atom].away, d); }

    std::size_t least(const Vec3& d) const {
        std::size_t result = 0;
        double value = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < atoms_.size(); ++i) {
            const double now = after(i, d);
            if (now >= value) continue;
            value = now;
            result = i;
        }
        return result;
    }

    bool is_held(std::size_t atom) const {
        return std::find(held_.begin(), held_.begin() + count_, atom) != held_.begin() + count_;
    }

    void add(std::size_t atom) {
        held_[count_] = atom;
        weights_[count_++] = 0.0;
    }

    void drop(std::size_t i) {
        std::copy(held_.begin() + i + 1, held_.begin() + count_, held_.begin() + i);
        std::copy(weights_.begin() + i + 1, weights_.begin() + count_, weights_.begin() + i);
        --count_;
    }

    Vec3 step() const {
        Vec3 sum;
        for (std::size_t i = 0; i < count_; ++i) sum += weights_[i] * atoms_[held_[i]].away;
        return reach_ * sum;
    }

    // Of the dual, which falls with every atom that is added.
    double value() const {
        double sum = squared_norm(step()) / (2.0 * reach_);
        for (std::size_t i = 0; i < count_; ++i) sum += weights_[i] * atoms_[held_[i]].clearance;
        return sum;
    }

    double gain(const Vec3& d) const { return after(least(d), d) - squared_norm(d) / (2.0 * reach_); }

    // To the best weights of the held atoms, dropping those whose weights would become negative.
    bool improve() {
        while (count_ > 0) {
            Matrix m{};
            for (std::size_t i = 0; i < count_; ++i) {
                for (std::size_t j = 0; j < count_; ++j)
                    m[i][j] = reach_ * dot(atoms_[held_[i]].away, atoms_[held_[j]].away);
                m[i][i] += kRidge;
                m[i][count_] = -1.0;
                m[i][count_ + 1] = -atoms_[held_[i]].clearance;
                m[count_][i] = 1.0;
            }
            m[count_][count_ + 1] = 1.0;
            if (!solve(m, count_ + 1)) return false;
            double part = 1.0;
            std::size_t first = count_;
            for (std::size_t i = 0; i < count_; ++i) {
                const double wanted = m[i][count_ + 1];
                if (wanted >= 0.0) continue;
                const double until = weights_[i] / (weights_[i] - wanted);
                if (first < count_ && until >= part) continue;
                part = until;
                first = i;
            }
            for (std::size_t i = 0; i < count_; ++i) weights_[i] += part * (m[i][count_ + 1] - weights_[i]);
            if (first == count_) return true;
            drop(first);
        }
        return false;
    }

    std::span<const AtomView> atoms_;
    double reach_;
    std::array<std::size_t, kMostHeld> held_{};
    std::array<double, kMostHeld> weights_{};
    std::size_t count_ = 0;
};

}  // namespace

Vec3 step_up(std::span<const AtomView> atoms, double reach) { return HeldStep(atoms, reach).find(); }

void Ascent::look_round(const Vec3& point) {
    const auto view = [&] {
        views_.clear();
        here_ = std::numeric_limits<double>::infinity();
        for (const std::uint32_t atom : list_) {
            const Vec3 from = point - clearance_.atoms().centres[atom];
            const double distance = norm(from);
            if (distance == 0.0) continue;  // no direction is better than another
            views_.push_back({(1.0 / distance) * from, distance - clearance_.atoms().radii[atom]});
            here_ = std::min(here_, views_.back().clearance);
        }
    };
    if (!list_.empty()) {
        view();
        // Atoms that are not listed must not matter within the longest step.
        if (most_ - norm(point - seen_from_) >= here_ + 2.0 * kLongestStep) return;
    }
    seen_from_ = point;
    most_ = clearance_.at(point) + kBand;
    clearance_.list_atoms(point, most_, list_);
    view();
}

bool Ascent::find_next(const Vec3& point, Vec3& next) {
    look_round(point);
    if (views_.empty()) return false;
    Vec3 d = step_up(views_, kReach);
    const double length = norm(d);
    if (!(length > kShortestStep)) return false;
    if (length > kLongestStep) d = (kLongestStep / length) * d;
    double least = std::numeric_limits<double>::infinity();
    for (const AtomView& atom : views_) least = std::min(least, atom.clearance + dot(atom.away, d));
    next = point + d;
    return least > here_;
}

}  // namespace meniscus
