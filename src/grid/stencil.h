// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Symmetric 27-point stencils on a block: what the tri-cubic B-spline needs on a uniform grid.
#pragma once

namespace meniscus {

/// Coefficients of a node by how many axes it differs in: centre 1, face 6, edge 12, corner 8 nodes.
struct Stencil {
    double centre = 0.0;
    double face = 0.0;
    double edge = 0.0;
    double corner = 0.0;
};

constexpr Stencil operator*(double s, const Stencil& a) { return {s * a.centre, s * a.face, s * a.edge, s * a.corner}; }
constexpr Stencil operator-(const Stencil& a, const Stencil& b) {
    return {a.centre - b.centre, a.face - b.face, a.edge - b.edge, a.corner - b.corner};
}

/// Product of the symmetric three-point stencil (side, middle, side) along every axis.
constexpr Stencil tensor_cube(double middle, double side) {
    return {middle * middle * middle, middle * middle * side, middle * side * side, side * side * side};
}

/// The factor of a wave cos(θ·x) along whose axes cos θ is as given: what the stencil multiplies it by.
constexpr double symbol_of(const Stencil& s, double x, double y, double z) {
    return s.centre + 2.0 * s.face * (x + y + z) + 4.0 * s.edge * (x * y + y * z + z * x) + 8.0 * s.corner * x * y * z;
}

/// A stencil whose symbol interpolates the inverse of another's, which must have no zero, at cos θ = ±√½ along each
/// axis: there the product of two symbols that are linear in every cos θ oscillates least about 1.
Stencil approximate_inverse(const Stencil& s);

/// The range of the product of two symbols, from waves that are constant, alternate or are halfway between along each
/// axis.
struct Range {
    double least = 0.0;
    double greatest = 0.0;
};
Range range_of_product(const Stencil& a, const Stencil& b);

/// B: values at the nodes of a tri-cubic B-spline from its coefficients, (1, 4, 1)/6 per axis.
constexpr Stencil spline_value() { return tensor_cube(4.0 / 6.0, 1.0 / 6.0); }

/// L: Laplacian at the nodes, Å^-2 times the coefficients; second derivative (1, -2, 1)/h² per axis.
constexpr Stencil spline_laplacian(double spacing) {
    const double s = 1.0 / (36.0 * spacing * spacing);
    return {-96.0 * s, 0.0, 6.0 * s, 3.0 * s};
}

/// Coefficients from values, to fourth order where the values are smooth: (-1, 8, -1)/6 per axis.
/// A local stand-in for the inverse of B, whose error the flow damps (docs/design/flow.md).
constexpr Stencil spline_quasi_interpolant() { return tensor_cube(8.0 / 6.0, -1.0 / 6.0); }

}  // namespace meniscus
