// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/ComparedSegments.h"

#include "core/document/Document.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/engine/EngineCommands.h"
#include "core/sculpt/labels/HeldVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/peers/cases/WholeSegments.h"

#include <QElapsedTimer>

#include <concepts>
#include <span>
#include <type_traits>
#include <vector>

namespace peer {

namespace {

template <class E>
concept workedOut = requires(const E& edit, const core::Document& document,
    std::span<const std::uint8_t> labels, const core::Progress& progress)
{
    {
        relabelListed(edit, document, labels, progress)
        } -> std::same_as<core::Result<core::RelabelListed>>;
};

/// Milliseconds of working something out. @param work returns a Result
template <class Work> core::Result<std::optional<double>> timed(const Work& work)
{
    QElapsedTimer timer;
    timer.start();
    const auto listed = work();
    if (!listed)
        return tl::unexpected(listed.error());
    return double(timer.nsecsElapsed()) / 1e6;
}

core::Result<std::optional<double>> timeToWorkOut(const core::ReshapeSegment& edit,
    const core::Document& document, std::span<const std::uint8_t> labels)
{
    if (edit.with)
        return timed([&] { return labelListed(edit, document, labels, core::Progress()); });
    return timed([&] { return relabelListed(edit, document, labels, core::Progress()); });
}

core::Result<std::optional<double>> timeToWorkOut(const core::SplitIslands& edit,
    const core::Document& document, std::span<const std::uint8_t> labels)
{
    core::SplitIslands completed = edit;
    const std::vector<core::LabelPlane> planes{{0, labels}};
    return timed(
        [&] { return labelListed(completed, document, {.planes = planes}, core::Progress()); });
}

/// @return none: the engine itself works it out
template <class E>
core::Result<std::optional<double>> timeToWorkOut(
    const E& edit, const core::Document& document, std::span<const std::uint8_t> labels)
{
    if constexpr (workedOut<E>)
        return timed([&] { return relabelListed(edit, document, labels, core::Progress()); });
    else
        return std::nullopt;
}

} // namespace

core::Result<Compared> compare(RealSegment& segment, const WholeSegment& operation)
{
    if (const core::Result<void> gone = segment.goTo(operation.before); !gone)
        return tl::unexpected(gone.error());
    core::EditSession& session = segment.session();
    const std::vector<core::Edit> first =
        operation.first ? operation.first(segment) : std::vector<core::Edit>();
    for (const core::Edit& edit : first) {
        if (const core::Result<void> applied = session.apply(edit); !applied)
            return tl::unexpected(applied.error());
        if (const core::Result<void> settled = session.settle(); !settled)
            return tl::unexpected(settled.error());
    }
    const core::Result<std::vector<std::uint8_t>> before =
        session.questions().labels(operation.plane);
    if (!before)
        return tl::unexpected(before.error());
    Compared compared;
    const core::Edit edit = operation.edit(segment);
    const core::Document workedOn = segment.document(); // the edit may add segments
    QElapsedTimer timer;
    timer.start();
    if (const core::Result<void> applied = session.apply(edit); !applied)
        return tl::unexpected(applied.error());
    if (const core::Result<void> settled = session.settle(); !settled)
        return tl::unexpected(settled.error());
    compared.stepMilliseconds = double(timer.nsecsElapsed()) / 1e6;
    const core::Result<std::vector<std::uint8_t>> ours =
        session.questions().labels(operation.plane);
    if (!ours)
        return tl::unexpected(ours.error());
    const auto worked = core::visitEdit(
        [&](const auto& known) { return timeToWorkOut(known, workedOn, *before); }, edit);
    if (!worked)
        return tl::unexpected(worked.error());
    compared.workedOutMilliseconds = *worked;

    const PeerMask theirs = operation.theirs(segment);
    compared.theirMilliseconds = theirs.milliseconds;
    compared.voxels = std::int64_t(ours->size());
    for (std::size_t voxel = 0; voxel < ours->size(); ++voxel) {
        compared.changed += (*ours)[voxel] != (*before)[voxel] ? 1 : 0;
        compared.either += !theirs.either.empty() && theirs.either[voxel] == 1 ? 1 : 0;
        if ((*ours)[voxel] == theirs.voxels[voxel])
            continue;
        ++compared.differing;
        if (theirs.either.empty() || theirs.either[voxel] == 0)
            ++compared.unexplained;
    }
    if (const core::Result<void> gone = segment.goTo(operation.before); !gone)
        return tl::unexpected(gone.error());
    return compared;
}

} // namespace peer
