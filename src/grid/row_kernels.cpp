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

// A factor for each node of a row.
Row operator*(const Part& s, const Row& a) {
    Row c;
    for (int i = 0; i < kParts; ++i) c.part[i] = s * a.part[i];
    return c;
}

Row operator*(float s, const Row& a) { return (Part{} + s) * a; }

Row load(const float* from) {
    Row row;
    for (int i = 0; i < kParts; ++i) __builtin_memcpy(&row.part[i], from + std::ptrdiff_t{kPlaces} * i, sizeof(Part));
    return row;
}

void store(const Row& row, float* to) {
    for (int i = 0; i < kParts; ++i) __builtin_memcpy(to + std::ptrdiff_t{kPlaces} * i, &row.part[i], sizeof(Part));
}

WideQuad load_wide(const double* from) {
    WideQuad quad;
    __builtin_memcpy(&quad, from, sizeof quad);
    return quad;
}

void store_wide(const WideQuad& quad, double* to) { __builtin_memcpy(to, &quad, sizeof quad); }

#ifdef __AVX2__
Quad half(const Row& row, int number) {
    return number == 0 ? __builtin_shufflevector(row.part[0], row.part[0], 0, 1, 2, 3)
                       : __builtin_shufflevector(row.part[0], row.part[0], 4, 5, 6, 7);
}
#else
Quad half(const Row& row, int number) { return row.part[number]; }
#endif

// Sum of a node's two neighbours along the row.
Row sum_of_sides(const Row& left, const Row& own, const Row& right) {
    Row c;
    for (int i = 0; i < kParts; ++i)
        c.part[i] = join_last(i > 0 ? own.part[0] : left.part[kParts - 1], own.part[i]) +
                    join_first(own.part[i], i < kParts - 1 ? own.part[kParts - 1] : right.part[0]);
    return c;
}

#ifdef __AVX2__
// As many bits for each place as its number needs: one instruction copies a byte from memory to all bytes.
PartBits copies(int bits) {
    using Bytes = std::int8_t __attribute__((vector_size(sizeof(PartBits))));
    return reinterpret_cast<PartBits>(Bytes{} + static_cast<std::int8_t>(bits));
}
#else
PartBits copies(int bits) { return PartBits{} + bits; }
#endif

// Which places of a part of a row have their bits set.
PartBits places_of(int bits, int part) { return (copies(bits >> (kPlaces * part)) & kBitOfPlace) == kBitOfPlace; }

// The values where the bits are set, else 0.
Row keep(const Row& row, int bits) {
    Row c;
    for (int i = 0; i < kParts; ++i)
        c.part[i] = reinterpret_cast<Part>(reinterpret_cast<PartBits>(row.part[i]) & places_of(bits, i));
    return c;
}

// The values of one row where the bits are set, else those of the other.
Row choose(int bits, const Row& set, const Row& other) {
    Row c;
    for (int i = 0; i < kParts; ++i) c.part[i] = places_of(bits, i) ? set.part[i] : other.part[i];
    return c;
}

#ifdef __AVX2__
int bits_of(const PartBits& places) { return __builtin_ia32_movmskps256(reinterpret_cast<Part>(places)); }
#else
int bits_of(const PartBits& places) {
    const PartBits bits = places & kBitOfPlace;
    const PartBits pairs = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
    return pairs[0] | pairs[1];
}
#endif

// The bits of the places where |row| < near.
int bits_near(const Row& row, float near) {
    int bits = 0;
    for (int i = 0; i < kParts; ++i) bits |= bits_of((row.part[i] < near) & (row.part[i] > -near)) << (kPlaces * i);
    return bits;
}

// Sum of scalar products of rows, each place of a row by itself until the end.
class RowSum {
public:
    void add(const Row& a, const Row& b) {
        for (int i = 0; i < 2; ++i) sum_[i] += widen(half(a, i)) * widen(half(b, i));
    }
    double total() const {
        const WideQuad s = sum_[0] + sum_[1];
        return (s[0] + s[2]) + (s[1] + s[3]);
    }

private:
    static WideQuad widen(const Quad& quad) {
#if defined(__AVX2__) && !defined(__clang__)
        return __builtin_ia32_cvtps2pd256(quad);  // GCC 12 makes four instructions of the other
#else
        return __builtin_convertvector(quad, WideQuad);
#endif
    }

    WideQuad sum_[2]{};
};

// A row of nodes, and the sums of each one's neighbours in x.
struct RowWithSides {
    Row own;
    Row sides;
};

RowWithSides read_row(const float* const* along_x, int first) {
    const Row own = load(along_x[1] + first);
    return {own, sum_of_sides(load(along_x[0] + first), own, load(along_x[2] + first))};
}

// A stencil's coefficients, each for a row.
struct RowWeights {
    Part centre;
    Part face;
    Part edge;
    Part corner;

    explicit RowWeights(const StencilWeights& w)
        : centre(Part{} + w.centre), face(Part{} + w.face), edge(Part{} + w.edge), corner(Part{} + w.corner) {}
};

// What a row and those beside it in y add to the rows of its slab and of the slabs next to it: sums of the row itself,
// of all neighbours in x or y, and of those in both.
struct SlabSums {
    Row own;
    Row beside;
    Row diagonal;

    SlabSums(const RowWithSides& before, const RowWithSides& row, const RowWithSides& after)
        : own(row.own), beside((before.own + after.own) + row.sides), diagonal(before.sides + after.sides) {}
    Row within(const RowWeights& w) const { return w.centre * own + w.face * beside + w.edge * diagonal; }
    Row across(const RowWeights& w) const { return w.face * own + w.edge * beside + w.corner * diagonal; }
};

// Calls visit(y, sums) for the rows of a slab, -1 <= z <= kBlockEdge.
template <class Visit>
void for_each_row(const BlocksAround& around, int z, const Visit& visit) {
    constexpr int kBelow = neighbour_slot(-1, -1, -1);
    constexpr int kBeside = neighbour_slot(-1, -1, 0);
    constexpr int kAbove = neighbour_slot(-1, -1, 1);
    const float* const* blocks = around + (z < 0 ? kBelow : (z < kBlockEdge ? kBeside : kAbove));
    const float* const beside[] = {blocks[3], blocks[4], blocks[5]};
    const float* const after_them[] = {blocks[6], blocks[7], blocks[8]};
    const int first = (z & (kBlockEdge - 1)) * kBlockEdge * kBlockEdge;
    RowWithSides before = read_row(blocks, first + kBlockEdge * (kBlockEdge - 1));
    RowWithSides row = read_row(beside, first);
#pragma GCC unroll 8
    for (int y = 0; y < kBlockEdge; ++y) {
        const RowWithSides after =
            y + 1 < kBlockEdge ? read_row(beside, first + kBlockEdge * (y + 1)) : read_row(after_them, first);
        visit(y, SlabSums(before, row, after));
        before = row;
        row = after;
    }
}

// Slabs of a block.
struct Slabs {
    int begin = 0;
    int end = kBlockEdge;
};

// From the first slab that holds nodes of a set to the last one; of an empty set, the last of all.
Slabs slabs_of(const NodeBits& set) {
    const auto is_empty = [&set](int z) {
        std::uint64_t bits;
        __builtin_memcpy(&bits, set.rows + std::ptrdiff_t{kBlockEdge} * z, sizeof bits);
        return bits == 0;
    };
    Slabs slabs;
    while (slabs.begin + 1 < slabs.end && is_empty(slabs.begin)) ++slabs.begin;
    while (slabs.end - 1 > slabs.begin && is_empty(slabs.end - 1)) --slabs.end;
    return slabs;
}

constexpr int first_node(int y, int z) { return kBlockEdge * (y + kBlockEdge * z); }

// Calls finish(first node, stencil applied to the row) for all rows of some slabs of a block.
template <class Finish>
void apply_rows(const StencilWeights& weights, const BlocksAround& around, const Slabs& slabs, const Finish& finish) {
    const RowWeights w(weights);
    Row below[kBlockEdge];    // what the slab before adds to this one
    Row partial[kBlockEdge];  // this one without what the slab after it adds
    for_each_row(around, slabs.begin - 1, [&](int y, const SlabSums& sums) { below[y] = sums.across(w); });
    for_each_row(around, slabs.begin, [&](int y, const SlabSums& sums) {
        partial[y] = sums.within(w) + below[y];
        below[y] = sums.across(w);
    });
    for (int z = slabs.begin + 1; z < slabs.end; ++z)
        for_each_row(around, z, [&](int y, const SlabSums& sums) {
            const Row across = sums.across(w);
            finish(first_node(y, z - 1), partial[y] + across);
            partial[y] = sums.within(w) + below[y];
            below[y] = across;
        });
    for_each_row(around, slabs.end, [&](int y, const SlabSums& sums) {
        finish(first_node(y, slabs.end - 1), partial[y] + sums.across(w));
    });
}

void apply(const StencilWeights& weights, const BlocksAround& around, float* image) {
    apply_rows(weights, around, Slabs{}, [&](int n, const Row& value) { store(value, image + n); });
}

void apply_within(const StencilWeights& weights, const BlocksAround& around, const NodeBits& set, float* image) {
    apply_rows(weights, around, slabs_of(set), [&](int n, const Row& value) {
        store(choose(set.rows[n / kBlockEdge], value, load(image + n)), image + n);
    });
}

ImageProducts apply_to_set(const StencilWeights& weights, const BlocksAround& direction, const NodeBits& set,
                           float* image) {
    constexpr int kMiddle = neighbour_slot(0, 0, 0);
    const float* own = direction[kMiddle];
    RowSum with_direction;
    RowSum with_itself;
    apply_rows(weights, direction, Slabs{}, [&](int n, const Row& value) {
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
    apply_rows(weights, x, Slabs{}, [&](int n, const Row& value) {
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

// Sets the nodes of all other slabs to 0.
void clear_beyond(const Slabs& slabs, float* nodes) {
    for (int n = 0; n < first_node(0, slabs.begin); n += kBlockEdge) store(Row{}, nodes + n);
    for (int n = first_node(0, slabs.end); n < kBlockNodes; n += kBlockEdge) store(Row{}, nodes + n);
}

double find_residual(const StencilWeights& weights, const BlocksAround& x, const NodeBits& set, const float* b,
                     float* residual) {
    const Slabs slabs = slabs_of(set);
    clear_beyond(slabs, residual);
    RowSum squares;
    apply_rows(weights, x, slabs, [&](int n, const Row& value) {
        const Row left = keep(load(b + n) - value, set.rows[n / kBlockEdge]);
        store(left, residual + n);
        squares.add(left, left);
    });
    return squares.total();
}

void correct(const StencilWeights& weights, const BlocksAround& residual, const NodeBits& set, float* x) {
    apply_rows(weights, residual, slabs_of(set),
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
