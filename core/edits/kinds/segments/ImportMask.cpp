// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ImportMask.h"

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ImportTargets.h"

#include <algorithm>
#include <utility>

namespace core {

using namespace rowWords;

namespace {

constexpr int highestLabel = 255;

/// What importMask means by its "as": one that is there; none: a new one.
Result<std::optional<int>> segmentMeant(const ImportMask& edit, const Document& document)
{
    if (!edit.as)
        return std::optional<int>();
    if (edit.as->number) {
        if (!document.segment(*edit.as->number))
            return failure(ErrorCode::UnknownSegment, QString::number(*edit.as->number),
                Clause::saying("in field 'importMask.as'"));
        return edit.as->number;
    }
    const auto named = std::find_if(document.segments.begin(), document.segments.end(),
        [&](const Segment& segment) { return segment.name == edit.as->name; });
    return named == document.segments.end() ? std::optional<int>()
                                            : std::optional<int>(named->label);
}

tl::unexpected<Error> wrong(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
}

Result<void> isOfVolume(const ImportMask& edit, const Document& document)
{
    const glm::ivec3 size = document.volumes.front().geometry.size;
    if (*edit.size == size)
        return {};
    return wrong("importMask.size",
        Clause::saying("its voxels are of a volume of %1 × %2 × %3, this one has %4 × %5 × %6",
            edit.size->x, edit.size->y, edit.size->z, size.x, size.y, size.z));
}

/// Puts labels where runs are and nothing is yet.
class BrickList {
public:
    explicit BrickList(const glm::ivec3& size)
        : m_grid{size}
        , m_slots(std::size_t(m_grid.brickCount()), -1)
    {
    }

    void put(const VoxelRuns& voxels, std::uint8_t label)
    {
        const auto columns = std::uint64_t(m_grid.volumeSize.x);
        const auto rows = std::uint64_t(m_grid.volumeSize.y);
        for (const VoxelRun& run : voxels.runs()) {
            for (std::uint64_t at = run.first; at < run.first + run.count;) {
                const glm::ivec3 voxel(
                    int(at % columns), int(at / columns % rows), int(at / columns / rows));
                const int toBrickEnd = BrickGrid::side - voxel.x % BrickGrid::side;
                const auto length = std::min({std::uint64_t(toBrickEnd),
                    columns - std::uint64_t(voxel.x), run.first + run.count - at});
                std::uint8_t* labels =
                    brick(m_grid.brickOf(voxel)).data() + BrickGrid::offsetInBrick(voxel);
                std::replace(labels, labels + length, std::uint8_t(0), label);
                at += length;
            }
        }
    }

    [[nodiscard]] std::vector<LabelListed::Brick> take()
    {
        std::sort(m_bricks.begin(), m_bricks.end(),
            [](const auto& one, const auto& other) { return one.brick < other.brick; });
        return std::move(m_bricks);
    }

private:
    std::vector<std::uint8_t>& brick(int number)
    {
        int& slot = m_slots[std::size_t(number)];
        if (slot < 0) {
            slot = int(m_bricks.size());
            m_bricks.push_back({.brick = std::uint32_t(number),
                .labels = std::vector<std::uint8_t>(BrickGrid::voxelsPerBrick, 0)});
        }
        return m_bricks[std::size_t(slot)].labels;
    }

    BrickGrid m_grid;
    std::vector<int> m_slots; ///< by brick; −1: not listed yet
    std::vector<LabelListed::Brick> m_bricks;
};

} // namespace

Result<ImportTargets> importTargets(const ImportMask& edit, const Document& document)
{
    if (!edit.segments || !edit.size)
        return wrong("importMask.segments", Clause::saying("its file has not been read"));
    const Result<std::optional<int>> meant = segmentMeant(edit, document);
    if (!meant)
        return tl::unexpected(meant.error());
    ImportTargets result{.targets = {}, .isNew = !*meant};
    const int room = highestLabel - document.lastLabelGiven();
    const auto wanted = std::ssize(*edit.segments);
    for (const int place : edit.ahead.value_or(std::vector<int>())) {
        if (place < 1 || place > wanted)
            return wrong("importMask.ahead",
                Clause::saying("there is no segment %1 in its list of %2", place, wanted));
    }
    if (result.isNew && (edit.as ? 1 : wanted) > room)
        return wrong("importMask.segments",
            Clause::saying("there is room for %1 segments more, it brings %2", room, wanted));
    Result<LabelTarget> target =
        labelTarget({.segment = *meant, .name = {}}, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    for (std::ptrdiff_t i = 0; i < wanted; ++i) {
        result.targets.push_back(*target);
        if (!edit.as)
            ++target->label;
    }
    return result;
}

std::vector<std::size_t> segmentsByPrecedence(
    const std::optional<std::vector<int>>& ahead, std::size_t count)
{
    std::vector<std::size_t> order;
    std::vector<bool> taken(count, false);
    const auto take = [&](std::size_t segment) {
        if (segment < count && !taken[segment])
            order.push_back(segment);
        if (segment < count)
            taken[segment] = true;
    };
    for (const int place : ahead.value_or(std::vector<int>())) {
        if (place >= 1)
            take(std::size_t(place) - 1);
    }
    for (std::size_t segment = 0; segment < count; ++segment)
        take(segment);
    return order;
}

Result<void> check(const ImportMask& edit, const Document& document)
{
    if (effects(edit).changes) {
        if (const Result<void> applied = checkApplied(edit, document); !applied)
            return applied;
    }
    return discardValue(labelListed(edit, document));
}

Result<bool> apply(const ImportMask& edit, Document& document)
{
    const Result<ImportTargets> where = importTargets(edit, document);
    if (!where)
        return tl::unexpected(where.error());
    if (!where->isNew)
        return false;
    const std::vector<ImportedSegment>& segments = *edit.segments;
    for (std::size_t i = 0; i < (edit.as ? 1 : segments.size()); ++i) {
        const bool alone = !edit.as || segments.size() == 1;
        const Result<bool> added =
            apply(AddSegment{.name = edit.as ? edit.as->name : segments[i].name,
                      .rgb = segments[i].rgb,
                      .code = alone ? segments[i].code : CodedConcept{}},
                document);
        if (!added)
            return added;
    }
    return true;
}

EditEffects effects(const ImportMask& edit)
{
    const std::optional<int> named = edit.as ? edit.as->number : std::nullopt;
    return {.task = engineTask<ImportMask>(),
        .standsOpen = false,
        .changes = named ? std::nullopt : std::optional(DocumentChange::What::Segments),
        .takesVoxelsOrNothing = true,
        .writesTo = named,
        .fills = {.label = named, .name = edit.as ? edit.as->name : QString(), .added = true},
        .boundToStudy = true};
}

Result<LabelListed> labelListed(const ImportMask& edit, const Document& document)
{
    const Result<ImportTargets> where = importTargets(edit, document);
    if (!where)
        return tl::unexpected(where.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (const Result<void> same = isOfVolume(edit, document); !same)
        return tl::unexpected(same.error());
    BrickList bricks(geometry.size);
    for (const std::size_t i : segmentsByPrecedence(edit.ahead, edit.segments->size())) {
        const std::optional<VoxelRuns> voxels =
            unpackedRuns((*edit.segments)[i].voxels, geometry.voxelCount());
        if (!voxels)
            return wrong(
                "importMask.segments", Clause::saying("entry %1: its voxels are damaged", i + 1));
        bricks.put(*voxels, where->targets[i].label);
    }
    const LabelTarget& target = where->targets.front();
    return LabelListed{
        .plane = target.plane, .overwritable = target.overwritable, .bricks = bricks.take()};
}

Result<EngineEdit> engineEdit(const ImportMask& edit, const Document& document)
{
    return engineEditFrom(labelListed(edit, document));
}

/// "Import 7 segments of liver.dcm, 12.3 mL"
RowTitle rowTitle(const ImportMask& mask, const RowFacts& row)
{
    const qsizetype slash = mask.file.lastIndexOf(QLatin1Char('/'));
    const auto count = std::int64_t(mask.segments ? mask.segments->size() : 0);
    const double ml = double(row.statistics.voxelsChanged)
        * row.document.volumes.front().geometry.voxelVolumeMm3() / 1000.0;
    RowTitle title{.code = RowTitleCode::ImportMask,
        .arguments = {TitleCount{count}, mask.file.mid(slash + 1)},
        .then = {{.code = RowTitleCode::Millilitres,
            .arguments = {TitleDecimal{.value = ml, .decimals = ml < 1.0 ? 3 : 1}}}}};
    if (mask.as) {
        title.code = RowTitleCode::ImportMaskAs;
        title.arguments.push_back(
            mask.as->number ? segmentName(*mask.as->number, row.document) : mask.as->name);
    }
    return title;
}

/// The labels and seed words of the bricks that it has voxels in.
EditDependencies dependencies(const ImportMask& edit, const DependencyFacts& row)
{
    dependsOn::Bricks bricks;
    if (const Result<LabelListed> listed = labelListed(edit, row.document)) {
        for (const LabelListed::Brick& brick : listed->bricks) {
            bricks.keys.insert({Field::Labels, listed->plane, brick.brick});
            bricks.keys.insert({Field::SeedWords, listed->plane, brick.brick});
        }
    }
    return bricks;
}

} // namespace core
