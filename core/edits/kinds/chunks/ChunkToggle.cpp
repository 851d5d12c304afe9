// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/ChunkToggle.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/chunks/ChunkVoxels.h"

#include <utility>

namespace core {

using namespace rowWords;

Result<void> check(const ChunkToggle& edit, const Document& document)
{
    return discardValue(chunkClick(edit, document));
}

Result<bool> apply(const ChunkToggle&, Document&)
{
    return false;
}

EditEffects effects(const ChunkToggle& edit)
{
    return {.task = EditTask::Chunks,
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.segment},
        .boundToStudy = true};
}

RowTitle rowTitle(const ChunkToggle& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    return {.code = flow.gained > 0 && flow.lost > 0 ? RowTitleCode::ToggleChunks
            : flow.gained > 0                        ? RowTitleCode::AddChunks
                                                     : RowTitleCode::TakeChunks,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

/// The labels and seed words of the bricks that the chunks lie in.
EditDependencies dependencies(const ChunkToggle& edit, const DependencyFacts& row)
{
    dependsOn::Bricks bricks;
    const std::uint8_t plane = row.planeOf(edit.segment);
    for (const std::int64_t brick : edit.bricks.value_or(std::vector<std::int64_t>())) {
        bricks.keys.insert({Field::Labels, plane, std::uint32_t(brick)});
        bricks.keys.insert({Field::SeedWords, plane, std::uint32_t(brick)});
    }
    return row.alsoReading(edit.editable, std::move(bricks));
}

} // namespace core
