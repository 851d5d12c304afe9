// SPDX-License-Identifier: Apache-2.0
#include "core/masks/ImportedMasks.h"

#include "core/edits/kinds/segments/ImportMask.h"

#include <set>
#include <utility>

namespace core {

namespace {

/// The voxels of one imported mask that became one segment, united.
VoxelRuns allOf(const ImportMask& edit, std::uint64_t voxels)
{
    VoxelRuns all;
    for (const ImportedSegment& segment : *edit.segments) {
        if (const auto runs = unpackedRuns(segment.voxels, voxels))
            all = united(all, *runs);
    }
    return all;
}

} // namespace

MaskOnVolume importedMasks(const std::vector<ImportMask>& imports,
    const std::map<int, QString>& names, std::uint64_t voxels)
{
    MaskOnVolume masks;
    std::set<QString> newer;
    for (auto edit = imports.rbegin(); edit != imports.rend(); ++edit) {
        std::vector<MaskSegment> its;
        if (edit->as) {
            const auto named = names.find(edit->as->number.value_or(0));
            its.push_back({.name = named == names.end() ? edit->as->name : named->second,
                .rgb = {},
                .code = {},
                .voxels = allOf(*edit, voxels)});
        } else {
            for (const ImportedSegment& segment : *edit->segments)
                its.push_back({.name = segment.name,
                    .rgb = segment.rgb,
                    .code = segment.code,
                    .voxels = unpackedRuns(segment.voxels, voxels).value_or(VoxelRuns())});
        }
        std::set<QString> own;
        for (MaskSegment& segment : its) {
            own.insert(segment.name);
            if (!newer.contains(segment.name) && !segment.voxels.empty())
                masks.segments.push_back(std::move(segment));
        }
        newer.merge(own);
    }
    return masks;
}

} // namespace core
