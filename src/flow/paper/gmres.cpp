// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/paper/gmres.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kRestart = 30;
constexpr std::size_t kVectorChunk = std::size_t{32} * kBlockNodes;

// Least squares min |e1·norm - H y| for a Hessenberg matrix H that grows by columns.
class HessenbergSolver {
public:
    explicit HessenbergSolver(double norm) : right_{norm} {}

    std::size_t size() const { return columns_.size(); }
    double residual() const { return std::abs(right_.back()); }

    void add(std::vector<double> column) {
        const std::size_t j = size();
        for (std::size_t i = 0; i < j; ++i) rotations_[i].turn(column[i], column[i + 1]);
        rotations_.push_back(Rotation(column[j], column[j + 1]));
        rotations_[j].turn(column[j], column[j + 1]);
        right_.push_back(0.0);
        rotations_[j].turn(right_[j], right_[j + 1]);
        columns_.push_back(std::move(column));
    }

    std::vector<double> solution() const {
        std::vector<double> y(right_.begin(), right_.end() - 1);
        for (std::size_t i = y.size(); i-- > 0;) {
            for (std::size_t j = i + 1; j < y.size(); ++j) y[i] -= columns_[j][i] * y[j];
            y[i] /= columns_[i][i];
        }
        return y;
    }

private:
    struct Rotation {
        double cosine;
        double sine;
        Rotation(double a, double b) : cosine(a / std::sqrt(a * a + b * b)), sine(b / std::sqrt(a * a + b * b)) {}
        void turn(double& a, double& b) const {
            const double turned = cosine * a + sine * b;
            b = cosine * b - sine * a;
            a = turned;
        }
    };

    std::vector<std::vector<double>> columns_;
    std::vector<Rotation> rotations_;
    std::vector<double> right_;
};

std::vector<float> scaled(const std::vector<float>& vector, double scale) {
    std::vector<float> result(vector.size());
    const auto factor = static_cast<float>(scale);
    parallel_for(vector.size(), kVectorChunk, [&](std::size_t n) { result[n] = factor * vector[n]; });
    return result;
}

// Sum of term(n) over a vector's nodes, block by block.
template <class Term>
double sum_over_nodes(std::size_t nodes, const Term& term) {
    return parallel_sum<double>(nodes, kVectorChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t first = begin; first < end; first += kBlockNodes) {
            double of_block = 0.0;
            for (std::size_t n = first; n < first + kBlockNodes; ++n) of_block += term(n);
            sum += of_block;
        }
        return sum;
    });
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
    return sum_over_nodes(a.size(), [&](std::size_t n) { return double{a[n]} * b[n]; });
}

// image -= scale · vector; returns the image's squared norm.
double subtract(const std::vector<float>& vector, double scale, std::vector<float>& image) {
    const auto factor = static_cast<float>(scale);
    return sum_over_nodes(image.size(), [&](std::size_t n) {
        image[n] -= factor * vector[n];
        return double{image[n]} * image[n];
    });
}

// x += scale · vector.
void add_to(std::span<float> x, const std::vector<BlockId>& blocks, const std::vector<float>& vector, double scale) {
    const auto factor = static_cast<float>(scale);
    parallel_for(vector.size(), kVectorChunk, [&](std::size_t n) {
        x[std::size_t{blocks[n / kBlockNodes]} * kBlockNodes + n % kBlockNodes] += factor * vector[n];
    });
}

}  // namespace

// Arnoldi by modified Gram-Schmidt, the small least-squares problem by Givens rotations.
SolveResult solve_gmres(const SplineSystem& system, std::span<float> x, const SolveOptions& options) {
    KrylovVectors vectors(system);
    std::vector<std::vector<float>> basis(kRestart + 1);
    SolveResult result;
    for (;;) {
        const double norm = std::sqrt(vectors.begin(x));
        result.residual = root_mean_square(system.unknowns, norm * norm);
        if (result.residual <= options.tolerance || result.iterations >= options.max_iterations) return result;
        basis[0] = scaled(vectors.residual, 1.0 / norm);
        HessenbergSolver small(norm);
        const auto is_left = [&] {
            return root_mean_square(system.unknowns, small.residual() * small.residual()) > options.tolerance;
        };
        while (small.size() < kRestart && is_left() && result.iterations < options.max_iterations) {
            const std::size_t j = small.size();
            vectors.direction = basis[j];
            vectors.apply();
            std::vector<double> column(j + 2);
            double squared = 0.0;
            for (std::size_t i = 0; i <= j; ++i) {
                column[i] = dot(vectors.image, basis[i]);
                squared = subtract(basis[i], column[i], vectors.image);
            }
            column[j + 1] = std::sqrt(squared);
            small.add(std::move(column));
            basis[j + 1] = scaled(vectors.image, squared > 0.0 ? 1.0 / std::sqrt(squared) : 0.0);
            ++result.iterations;
        }
        const std::vector<double> weights = small.solution();
        for (std::size_t j = 0; j < weights.size(); ++j) add_to(x, system.unknowns.blocks, basis[j], weights[j]);
    }
}

}  // namespace meniscus
