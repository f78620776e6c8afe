// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much a point resembles those where ligands are: a logistic regression.
#pragma once

#include <array>
#include <string_view>

#include "pockets/point_features.h"

namespace meniscus {

/// A feature's part in the model: coefficient * (value - mean) / scale.
struct ModelTerm {
    std::string_view feature;
    double mean = 0.0;
    double scale = 1.0;
    double coefficient = 0.0;
};

struct PocketModel {
    double intercept = 0.0;
    std::array<ModelTerm, FeatureCount> terms{};
};

/// The model that tools/fit-pockets has fitted.
const PocketModel& pocket_model();

/// The probability that a point is a ligand's, where one in twelve points is; not calibrated.
double probability(const PocketModel& model, const PointFeatures& features);

}  // namespace meniscus
