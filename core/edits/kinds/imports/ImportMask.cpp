// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/imports/ImportMask.h"

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/imports/ImportTargets.h"
#include "core/edits/kinds/segments/AddSegment.h"

#include <algorithm>
#include <bitset>
#include <set>
#include <utility>

namespace core {

using namespace rowWords;

namespace {

constexpr int highestLabel = 255;

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

/// What may not be written to in a plane, since segments of other planes keep their voxels.
std::optional<EditableVoxels> besideOtherPlanes(
    int plane, const ImportMask& edit, const Document& document)
{
    EditableVoxels editable;
    for (const std::uint8_t other : document.labelPlanes()) {
        const std::bitset<256> kept =
            edit.overwriteUnlocked ? document.lockedLabels(other) : document.labelsIn(other);
        if (other != plane && kept.any())
            editable.outside.push_back({.plane = other, .labels = kept});
    }
    return editable.outside.empty() ? std::nullopt : std::optional(std::move(editable));
}

/// A number that no segment of the import gets.
std::uint8_t freeNumber(const ImportTargets& where)
{
    std::bitset<256> given;
    for (const LabelTarget& target : where.targets)
        given.set(target.label);
    int number = 1;
    while (number < highestLabel && given.test(std::size_t(number)))
        ++number;
    return std::uint8_t(number);
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

Result<void> check(const ImportMask& edit, const Document& document)
{
    if (effects(edit).changes) {
        if (const Result<void> applied = checkApplied(edit, document); !applied)
            return applied;
    }
    return discardValue(importPlan(edit, document));
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
                      .code = alone ? segments[i].code : CodedConcept{},
                      .plane = where->targets[i].plane},
                document);
        if (!added)
            return added;
    }
    return true;
}

EditEffects effects(const ImportMask& edit)
{
    const std::optional<int> named = edit.as ? edit.as->number : std::nullopt;
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .changes = named ? std::nullopt : std::optional(DocumentChange::What::Segments),
        .takesVoxelsOrNothing = true,
        .writesTo = named,
        .fills = {.label = named,
            .name = edit.as ? edit.as->name : QString(),
            .added = AddedSegments::Known},
        .boundToStudy = true};
}

Result<ImportPlan> importPlan(const ImportMask& edit, const Document& document)
{
    Result<ImportTargets> where = importTargets(edit, document);
    if (!where)
        return tl::unexpected(where.error());
    if (const Result<void> same = isOfVolume(edit, document); !same)
        return tl::unexpected(same.error());
    std::set<std::uint8_t> planes;
    for (const LabelTarget& target : where->targets)
        planes.insert(target.plane);
    for (const std::uint8_t plane : document.labelPlanes()) {
        // What others lose in planes of their own.
        if (edit.overwriteUnlocked && document.unlockedLabels(plane).any())
            planes.insert(plane);
    }
    const bool othersLose = edit.overwriteUnlocked && !document.segments.empty();
    ImportPlan plan{.size = *edit.size,
        .order = segmentsByPrecedence(edit.ahead, edit.segments->size()),
        .frees = othersLose && planes.size() > 1 ? freeNumber(*where) : std::uint8_t(0)};
    for (const std::uint8_t plane : planes)
        plan.planes.push_back({.plane = plane,
            .overwritable = overwrittenBy(edit, plane, document),
            .editable = besideOtherPlanes(plane, edit, document),
            .othersMayLose = document.unlockedLabels(plane).any()});
    plan.targets = std::move(where->targets);
    return plan;
}

Result<LabelPlanes> labelPlanes(
    const ImportPlan& plan, const std::vector<ImportedSegment>& segments, const Progress& progress)
{
    const auto voxelCount =
        std::uint64_t(plan.size.x) * std::uint64_t(plan.size.y) * std::uint64_t(plan.size.z);
    std::vector<BrickList> lists(plan.planes.size(), BrickList(plan.size));
    const int rounds = plan.frees == 0 ? 1 : 2;
    int done = 0;
    // Freeing comes second: a voxel that is asked for in a plane is not freed there.
    for (int round = 0; round < rounds; ++round) {
        const bool freeing = round == 1;
        for (const std::size_t i : plan.order) {
            if (progress.cancelled())
                return failure(ErrorCode::Cancelled);
            progress.report(ProgressStep::PlacingMask, done++, rounds * int(plan.order.size()));
            const std::optional<VoxelRuns> voxels = unpackedRuns(segments[i].voxels, voxelCount);
            if (!voxels)
                return wrong("importMask.segments",
                    Clause::saying("entry %1: its voxels are damaged", i + 1));
            for (std::size_t list = 0; list < lists.size(); ++list) {
                const ImportPlan::Plane& plane = plan.planes[list];
                const bool isIts = plane.plane == plan.targets[i].plane;
                if (isIts != freeing && (isIts || plane.othersMayLose))
                    lists[list].put(*voxels, isIts ? plan.targets[i].label : plan.frees);
            }
        }
    }
    LabelPlanes result;
    for (std::size_t list = 0; list < lists.size(); ++list) {
        const ImportPlan::Plane& plane = plan.planes[list];
        result.planes.push_back({.plane = plane.plane,
            .overwritable = plane.overwritable,
            .bricks = lists[list].take(),
            .frees = plan.frees,
            .editable = plane.editable});
    }
    return result;
}

Result<LabelPlanes> labelPlanes(const ImportMask& edit, const Document& document)
{
    const Result<ImportPlan> plan = importPlan(edit, document);
    if (!plan)
        return tl::unexpected(plan.error());
    return labelPlanes(*plan, *edit.segments, Progress());
}

/// "Import 7 segments of liver.dcm, 12.3 mL"
RowTitle rowTitle(const ImportMask& mask, const RowFacts& row)
{
    const qsizetype slash = mask.file.lastIndexOf(QLatin1Char('/'));
    const auto count = std::int64_t(mask.segments ? mask.segments->size() : 0);
    std::int64_t voxels = 0; // without those that others lose
    for (const LabelFlow& flow : row.facts.flows)
        voxels += flow.gained;
    const double ml =
        double(voxels) * row.document.volumes.front().geometry.voxelVolumeMm3() / 1000.0;
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

/// The labels and seed words of all planes in the bricks that it has voxels in, whatever has become
/// of the segments that were there.
EditDependencies dependencies(const ImportMask&, const DependencyFacts& row)
{
    if (!row.trace.importedTo)
        return dependsOn::Plane{};
    return dependsOn::AllPlanes{
        .bricks = *row.trace.importedTo, .written = {row.written.begin(), row.written.end()}};
}

} // namespace core
