// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ImportedSegments.h"

#include "core/masks/ImportedMasks.h"

#include <algorithm>

namespace core {

std::vector<ImportedVoxels> importedAs(const std::vector<Segment>& segments,
    const std::vector<ImportMask>& imports, std::uint64_t voxels)
{
    std::map<int, QString> names;
    for (const Segment& segment : segments)
        names.emplace(segment.label, segment.name);
    const std::vector<MaskSegment> masks = importedMasks(imports, names, voxels).segments;
    std::vector<ImportedVoxels> found;
    for (const Segment& segment : segments) {
        const auto its = std::find_if(masks.begin(), masks.end(),
            [&](const MaskSegment& mask) { return mask.name == segment.name; });
        if (its != masks.end())
            found.push_back({.label = segment.label, .voxels = its->voxels});
    }
    return found;
}

} // namespace core
