// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Compiled once for every set of instructions, so nothing inline of other headers may be called here: the linker would
// keep one copy of it, perhaps one that older machines cannot run.
#include "grid/block_kernels.h"

namespace meniscus {
namespace {

constexpr int kHalf = kBlockEdge / 2;

using Quad = float __attribute__((vector_size(kHalf * sizeof(float))));
using WideQuad = double __attribute__((vector_size(kHalf * sizeof(double))));

// A row is as many vectors as the machine needs for it: compilers split wider ones badly.
#ifdef __AVX2__
constexpr int kParts = 1;
using Part = float __attribute__((vector_size(kBlockEdge * sizeof(float))));
using PartBits = std::int32_t __attribute__((vector_size(kBlockEdge * sizeof(std::int32_t))));
constexpr PartBits kBitOfPlace{1, 2, 4, 8, 16, 32, 64, 128};

Part join_last(const Part& a, const Part& b) { return __builtin_shufflevector(a, b, 7, 8, 9, 10, 11, 12, 13, 14); }
Part join_first(const Part& a, const Part& b) { return __builtin_shufflevector(a, b, 1, 2, 3, 4, 5, 6, 7, 8); }
#else
constexpr int kParts = 2;
using Part = Quad;
using PartBits = std::int32_t __attribute__((vector_size(kHalf * sizeof(std::int32_t))));
constexpr PartBits kBitOfPlace{1, 2, 4, 8};

Part join_last(const Part& a, const Part& b) { return __builtin_shufflevector(a, b, 3, 4, 5, 6); }
Part join_first(const Part& a, const Part& b) { return __builtin_shufflevector(a, b, 1, 2, 3, 4); }
#endif
constexpr int kPlaces = kBlockEdge / kParts;

struct Row {
    Part part[kParts];
};

Row operator+(const Row& a, const Row& b) {
    Row c;
    for (int i = 0; i < kParts; ++i) c.part[i] = a.part[i] + b.part[i];
    return c;
}

Row operator-(const Row& a, const Row& b) {
    Row c;
    for (int i = 0; i < kParts; ++i) c.part[i] = a.part[i] - b.part[i];
    return c;
}

Row operator*(float s, const Row& a) {
    Row c;
    for (int i = 0; i < kParts; ++i) c.part[i] = s * a.part[i];
    return c;
}

Row load(const float* from) {
    Row row;
    __builtin_memcpy(&row, from, sizeof row);
    return row;
}

void store(const Row& row, float* to) { __builtin_memcpy(to, &row, sizeof row); }

WideQuad load_wide(const double* from) {
    WideQuad quad;
    __builtin_memcpy(&quad, from, sizeof quad);
    return quad;
}

void store_wide(const WideQuad& quad, double* to) { __builtin_memcpy(to, &quad, sizeof quad); }

// Sum of a node's two neighbours along the row.
Row sum_of_sides(const Row& left, const Row& own, const Row& right) {
    Row c;
    for (int i = 0; i < kParts; ++i)
        c.part[i] = join_last(i > 0 ? own.part[0] : left.part[kParts - 1], own.part[i]) +
                    join_first(own.part[i], i < kParts - 1 ? own.part[kParts - 1] : right.part[0]);
    return c;
}

// The values where the bits are set, else 0.
Row keep(const Row& row, int bits) {
    Row c;
    for (int i = 0; i < kParts; ++i) {
        const PartBits in = (kBitOfPlace & (bits >> (kPlaces * i))) != 0;
        c.part[i] = reinterpret_cast<Part>(reinterpret_cast<PartBits>(row.part[i]) & in);
    }
    return c;
}

#ifdef __AVX2__
int any_bit(const PartBits& b) {
    const PartBits quarters = b | __builtin_shufflevector(b, b, 4, 5, 6, 7, 0, 1, 2, 3);
    const PartBits pairs = quarters | __builtin_shufflevector(quarters, quarters, 2, 3, 0, 1, 6, 7, 4, 5);
    return pairs[0] | pairs[1];
}
#else
int any_bit(const PartBits& b) {
    const PartBits pairs = b | __builtin_shufflevector(b, b, 2, 3, 0, 1);
    return pairs[0] | pairs[1];
}
#endif

// The bits of the places where |row| < near.
int bits_near(const Row& row, float near) {
    int bits = 0;
    for (int i = 0; i < kParts; ++i) {
        const PartBits in = (row.part[i] < near) & (row.part[i] > -near);
        bits |= any_bit(in & kBitOfPlace) << (kPlaces * i);
    }
    return bits;
}

// Sum of scalar products of rows, each place of a row by itself until the end.
class RowSum {
public:
    void add(const Row& a, const Row& b) {
        Quad x[2];
        Quad y[2];
        __builtin_memcpy(x, &a, sizeof a);
        __builtin_memcpy(y, &b, sizeof b);
        for (int i = 0; i < 2; ++i) sum_[i] += widen(x[i]) * widen(y[i]);
    }
    double total() const {
        const WideQuad s = sum_[0] + sum_[1];
        return (s[0] + s[2]) + (s[1] + s[3]);
    }

private:
    static WideQuad widen(const Quad& quad) { return __builtin_convertvector(quad, WideQuad); }

    WideQuad sum_[2]{};
};

// The rows of a slab, z given, and of the rows beside it in y, -1 to 8; sides are the sums of both neighbours in x.
struct Slab {
    Row own[kPaddedEdge];
    Row sides[kPaddedEdge];
};

void read_row(const float* const* around, int first, Row& own, Row& sides) {
    const Row left = load(around[0] + first);
    own = load(around[1] + first);
    const Row right = load(around[2] + first);
    sides = sum_of_sides(left, own, right);
}

void read_slab(const BlocksAround& around, int z, Slab& slab) {
    constexpr int kBelow = neighbour_slot(-1, -1, -1);
    constexpr int kBeside = neighbour_slot(-1, -1, 0);
    constexpr int kAbove = neighbour_slot(-1, -1, 1);
    const float* const* blocks = around + (z < 0 ? kBelow : (z < kBlockEdge ? kBeside : kAbove));
    const int first = (z & (kBlockEdge - 1)) * kBlockEdge * kBlockEdge;
    read_row(blocks, first + kBlockEdge * (kBlockEdge - 1), slab.own[0], slab.sides[0]);
    for (int y = 0; y < kBlockEdge; ++y)
        read_row(blocks + 3, first + kBlockEdge * y, slab.own[y + 1], slab.sides[y + 1]);
    read_row(blocks + 6, first, slab.own[kPaddedEdge - 1], slab.sides[kPaddedEdge - 1]);
}

// Calls finish(first node, stencil applied to the row) for all rows of a block.
template <class Finish>
void apply_rows(const StencilWeights& w, const BlocksAround& around, const Finish& finish) {
    Row below[kBlockEdge]{};    // what slab z - 1 adds to slab z
    Row partial[kBlockEdge]{};  // slab z - 1 so far: without what slab z adds
    for (int z = -1; z <= kBlockEdge; ++z) {
        Slab slab;
        read_slab(around, z, slab);
        for (int y = 0; y < kBlockEdge; ++y) {
            const Row own = slab.own[y + 1];
            const Row beside = (slab.own[y] + slab.own[y + 2]) + slab.sides[y + 1];
            const Row diagonal = slab.sides[y] + slab.sides[y + 2];
            const Row across = w.face * own + w.edge * beside + w.corner * diagonal;
            if (z > 0) finish(kBlockEdge * (y + kBlockEdge * (z - 1)), partial[y] + across);
            const Row within = w.centre * own + w.face * beside + w.edge * diagonal;
            if (z >= 0) partial[y] = within + below[y];
            below[y] = across;
        }
    }
}

void apply(const StencilWeights& weights, const BlocksAround& around, float* image) {
    apply_rows(weights, around, [&](int n, const Row& value) { store(value, image + n); });
}

void apply_within(const StencilWeights& weights, const BlocksAround& around, const NodeBits& set, float* image) {
    apply_rows(weights, around, [&](int n, const Row& value) {
        const int bits = set.rows[n / kBlockEdge];
        store(keep(value, bits) + keep(load(image + n), ~bits), image + n);
    });
}

ImageProducts apply_to_set(const StencilWeights& weights, const BlocksAround& direction, const NodeBits& set,
                           float* image) {
    constexpr int kMiddle = neighbour_slot(0, 0, 0);
    const float* own = direction[kMiddle];
    RowSum with_direction;
    RowSum with_itself;
    apply_rows(weights, direction, [&](int n, const Row& value) {
        const Row kept = keep(value, set.rows[n / kBlockEdge]);
        store(kept, image + n);
        with_direction.add(kept, load(own + n));
        with_itself.add(kept, kept);
    });
    return {with_direction.total(), with_itself.total()};
}

double begin(const StencilWeights& weights, const BlocksAround& x, const NodeBits& set, const float* b, float* residual,
             float* direction) {
    RowSum squares;
    apply_rows(weights, x, [&](int n, const Row& value) {
        const Row left = keep(load(b + n) - value, set.rows[n / kBlockEdge]);
        store(left, residual + n);
        store(left, direction + n);
        squares.add(left, left);
    });
    return squares.total();
}

double advance(const CgFactors& factors, const float* image, float* x, float* residual, float* direction) {
    RowSum squares;
    for (int n = 0; n < kBlockNodes; n += kBlockEdge) {
        const Row along = load(direction + n);
        store(load(x + n) + factors.alpha * along, x + n);
        const Row left = load(residual + n) - factors.alpha * load(image + n);
        store(left, residual + n);
        store(left + factors.beta * along, direction + n);
        squares.add(left, left);
    }
    return squares.total();
}

NodeBits find_near(float near, const float* field) {
    NodeBits set;
    for (int n = 0; n < kBlockNodes; n += kBlockEdge)
        set.rows[n / kBlockEdge] = static_cast<std::uint8_t>(bits_near(load(field + n), near));
    return set;
}

void add_product(const AxisProduct& product, double negligible, double* sums) {
    const WideQuad low = load_wide(product.x);
    const WideQuad high = load_wide(product.x + kHalf);
    for (int z = 0; z < kBlockEdge; ++z) {
        if (product.z[z] <= negligible) continue;
        for (int y = 0; y < kBlockEdge; ++y) {
            const double factor = product.z[z] * product.y[y];
            if (factor <= negligible) continue;
            const int first = kBlockEdge * (y + kBlockEdge * z);
            double* row = sums + first;
            store_wide(load_wide(row) + factor * low, row);
            store_wide(load_wide(row + kHalf) + factor * high, row + kHalf);
        }
    }
}

double find_residual(const StencilWeights& weights, const BlocksAround& x, const NodeBits& set, const float* b,
                     float* residual) {
    RowSum squares;
    apply_rows(weights, x, [&](int n, const Row& value) {
        const Row left = keep(load(b + n) - value, set.rows[n / kBlockEdge]);
        store(left, residual + n);
        squares.add(left, left);
    });
    return squares.total();
}

void correct(const StencilWeights& weights, const BlocksAround& residual, const NodeBits& set, float* x) {
    apply_rows(weights, residual,
               [&](int n, const Row& value) { store(load(x + n) + keep(value, set.rows[n / kBlockEdge]), x + n); });
}

}  // namespace

#ifdef MENISCUS_AVX2_KERNELS
extern const BlockKernels kAvx2Kernels;
const BlockKernels kAvx2Kernels{"avx2",  apply,     apply_within, apply_to_set,  begin,
                                advance, find_near, add_product,  find_residual, correct};
#else
extern const BlockKernels kPlainKernels;
const BlockKernels kPlainKernels{"plain", apply,     apply_within, apply_to_set,  begin,
                                 advance, find_near, add_product,  find_residual, correct};
#endif

}  // namespace meniscus
