// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "volume/vdb_module.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

const auto kHalfWidth = static_cast<float>(openvdb::LEVEL_SET_HALF_WIDTH);  // voxels

void set_values(const VdbRequest& request, openvdb::FloatGrid& target) {
    const VolumeGrid& grid = request.volume.grid;
    const bool distance = request.content == VolumeContent::Distance;
    const float background = target.background();
    openvdb::FloatGrid::Accessor accessor = target.getAccessor();
    for (std::size_t i = 0; i < grid.counts[0]; ++i)
        for (std::size_t j = 0; j < grid.counts[1]; ++j)
            for (std::size_t k = 0; k < grid.counts[2]; ++k) {
                const float value = request.volume.values[grid.index(i, j, k)];
                const openvdb::Coord at(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k));
                if (!distance && value != background) accessor.setValue(at, value);
                if (distance && std::abs(value) < background) accessor.setValue(at, -value);
            }
}

float outside_value(const VdbRequest& request) {
    const std::vector<float>& values = request.volume.values;
    switch (request.content) {
        case VolumeContent::Mask:
        case VolumeContent::Probability:
        case VolumeContent::Pockets:
            return 0.0F;
        case VolumeContent::Ions:
            return 1.0F;
        case VolumeContent::Dielectric:  // the corner of the grid
            return values.front();
        default:
            return kHalfWidth * static_cast<float>(request.volume.grid.spacing.x);
    }
}

const char* name_of(VolumeContent content) {
    switch (content) {
        case VolumeContent::Mask:
            return "mask";
        case VolumeContent::Ions:
            return "ions";
        case VolumeContent::Dielectric:
            return "dielectric";
        case VolumeContent::Probability:
            return "probability";
        case VolumeContent::Pockets:
            return "pockets";
        default:
            return "surface";
    }
}

openvdb::FloatGrid::Ptr make_grid(const VdbRequest& request) {
    const VolumeGrid& grid = request.volume.grid;
    auto result = openvdb::FloatGrid::create(outside_value(request));
    result->setName(name_of(request.content));
    result->setCreator(request.creator);
    result->insertMeta("description", openvdb::StringMetadata(request.description));
    auto transform = openvdb::math::Transform::createLinearTransform(grid.spacing.x);
    transform->postTranslate({grid.origin.x, grid.origin.y, grid.origin.z});
    result->setTransform(transform);
    set_values(request, *result);
    if (request.content == VolumeContent::Distance) {
        result->setGridClass(openvdb::GRID_LEVEL_SET);
        openvdb::tools::signedFloodFill(result->tree());
    }
    result->pruneGrid();
    return result;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void meniscus_write_vdb(const VdbRequest& request,
                                                                          std::ostream& out) {
    openvdb::initialize();
    const openvdb::GridPtrVec grids{make_grid(request)};
    openvdb::io::Stream(out).write(grids);
}

}  // namespace meniscus
