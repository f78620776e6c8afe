// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Elementary functions that give the same bits with every compiler and C library, which those of <cmath> do not.
//
// The result is less than one unit in the last place away from the exact value. Arguments must be finite; the ranges
// that are named are all that surface geometry needs.
#pragma once

namespace meniscus::elementary {

double sin(double x);                   ///< |x| up to 1e5
double cos(double x);                   ///< |x| up to 1e5
double acos(double x);                  ///< π below -1 and 0 above 1
double atan2(double y, double x);       ///< in (-π, π], 0 for two zeros; |x| and |y| are 0 or from 1e-150 to 1e150
double exp(double x);                   ///< 0 below -745.13, infinity above 709.78
double pow(double base, int exponent);  ///< by repeated multiplication; exponent >= 0
double log(double x);                   ///< -infinity for 0; x must not be negative

}  // namespace meniscus::elementary
