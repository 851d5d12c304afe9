// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ImportedSegments.h"

#include "core/edits/kinds/imports/ImportMask.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// The voxels that an import gave to a label.
VoxelRuns voxelsFor(int label, const DoneImport& done, std::uint64_t voxels)
{
    VoxelRuns all;
    for (std::size_t i = 0; i < done.labels.size(); ++i) {
        if (done.labels[i] != label)
            continue;
        if (const auto runs = unpackedRuns((*done.edit->segments)[i].voxels, voxels))
            all = united(all, *runs);
    }
    return all;
}

} // namespace

std::vector<ImportedVoxels> importedAs(const std::vector<Segment>& segments,
    const std::vector<DoneImport>& imports, std::uint64_t voxels)
{
    std::vector<ImportedVoxels> found;
    for (const Segment& segment : segments) {
        const auto newest =
            std::find_if(imports.rbegin(), imports.rend(), [&](const DoneImport& done) {
                return std::find(done.labels.begin(), done.labels.end(), int(segment.label))
                    != done.labels.end();
            });
        if (newest == imports.rend())
            continue;
        VoxelRuns its = voxelsFor(segment.label, *newest, voxels);
        if (!its.empty())
            found.push_back({.label = segment.label, .voxels = std::move(its)});
    }
    return found;
}

} // namespace core
