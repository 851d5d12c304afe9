// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/PlainEdits.h"

#include <initializer_list>

namespace test {

void addChunkStrokes(std::vector<StrokeCase>& cases, const core::LoadedVolume& volume,
    const std::vector<core::Edit>& grown)
{
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const auto after = [&grown](std::initializer_list<core::Edit> further) {
        std::vector<core::Edit> all = grown;
        all.insert(all.end(), further);
        return all;
    };
    const auto toggle = [&geometry](int chunks, std::initializer_list<glm::dvec3> voxels) {
        core::ChunkToggle edit{.segment = 1, .chunks = chunks};
        for (const glm::dvec3& voxel : voxels)
            edit.pointsLps.push_back(geometry.toWorld(voxel));
        return edit;
    };
    const core::DivideSegment near{.segment = 1, .marginMm = 3.0};
    const core::DivideSegment wide{.segment = 2, .marginMm = 500.0};
    core::ChunkToggle one = toggle(40, {{20, 16, 10}});
    core::ChunkToggle many = toggle(300, {{4, 9, 9}, {20, 16, 12}, {30, 30, 12}, {36, 3, 18}});
    core::ChunkToggle added = many;
    added.mode = core::ChunkToggle::Mode::Add;
    added.overwriteUnlocked = true;
    core::ChunkToggle removed = toggle(2, {{4, 9, 9}, {20, 16, 12}, {30, 30, 12}});
    removed.mode = core::ChunkToggle::Mode::Remove;
    core::ChunkToggle limited = added;
    limited.editable = core::EditableRange{.outside = std::vector<int>{2}};
    const core::Edit lock = core::ChangeSegment{.segment = 2, .locked = true};
    const auto row = std::int64_t(grown.size()) + 2;

    cases.push_back({"divide into chunks", volume, grown, near});
    cases.push_back({"divide again", volume, after({near}), near});
    cases.push_back({"divide otherwise", volume, after({near}), wide});
    cases.push_back({"divide what was changed", volume, after({wide, added}), wide});
    cases.push_back({"toggle a chunk", volume, after({wide}), one});
    cases.push_back({"toggle chunks back", volume, after({wide, many}), many});
    cases.push_back({"add chunks", volume, after({wide}), added});
    cases.push_back({"add chunks beside a locked segment", volume, after({wide, lock}), added});
    cases.push_back({"add chunks within limits", volume, after({wide}), limited});
    cases.push_back({"take chunks", volume, after({wide}), removed});
    cases.push_back({"take what is not there", volume, after({wide, removed}), removed});
    cases.push_back({"toggle by an older division", volume,
        after({wide, one, near, core::RemoveSegment{.segment = 2}}), one});
    cases.push_back({"undo only a chunk", volume,
        after({wide, one, core::AddLayer{.name = QStringLiteral("Other")}}), revertRows({row})});
    cases.push_back(
        {"growth after chunks", volume, after({wide, removed}), growBetween(0, 1000, 3)});
    cases.push_back(
        {"delete what is divided", volume, after({near, one}), core::RemoveSegment{.segment = 1}});
}

} // namespace test
