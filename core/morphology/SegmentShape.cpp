// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SegmentShape.h"

#include "core/brick/LabelBox.h"
#include "core/morphology/BallFilters.h"
#include "core/morphology/MillimetreBall.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>

namespace core {

namespace {

enum class Side { Segment, Rest };

/// The segment in a box around it, and the filters that are applied to it one after the other.
class Reshaping {
public:
    Reshaping(std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label,
        const MillimetreBall& ball, const Progress& progress, int stages)
        : m_labels(labels)
        , m_size(size)
        , m_label(label)
        , m_ball(ball)
        , m_progress(progress)
        , m_stages(stages)
    {
    }

    /// @param margin around the segment's voxels
    /// @param beyond whether the box may reach beyond the volume, where there is nothing
    Result<void> begin(VoxelBox box, const glm::ivec3& margin, bool beyond)
    {
        box = {.minimum = box.minimum - margin, .maximum = box.maximum + margin};
        if (!beyond)
            box = {.minimum = glm::max(box.minimum, glm::ivec3(0)),
                .maximum = glm::min(box.maximum, m_size)};
        m_first = box.minimum;
        m_mask.size = box.maximum - box.minimum;
        if (const Result<void> enough = checkBytes(
                filterBytes(m_mask.size), Clause::saying("the segment with this margin"));
            !enough)
            return enough;
        m_mask.voxels.resize(
            std::size_t(m_mask.size.x) * std::size_t(m_mask.size.y) * std::size_t(m_mask.size.z));
        return {};
    }
    void fill(Side side)
    {
        const bool own = side == Side::Segment;
        std::fill(m_mask.voxels.begin(), m_mask.voxels.end(), std::uint8_t(0));
        forEachRow([&](std::size_t of, std::size_t in, int width) {
            for (int x = 0; x < width; ++x)
                m_mask.voxels[in + std::size_t(x)] =
                    (m_labels[of + std::size_t(x)] == m_label) == own ? 1 : 0;
        });
    }
    void invert()
    {
        for (std::uint8_t& voxel : m_mask.voxels)
            voxel = voxel == 0 ? 1 : 0;
    }
    Result<void> fillEnclosed() { return core::fillEnclosed(m_mask, m_progress); }
    Result<void> spread() { return dilate(m_mask, m_ball, nextStage()); }
    Result<void> vote() { return keepMajority(m_mask, m_ball, nextStage()); }

    /// Voxels of a label, in the order of memory, where the mask is @p value.
    [[nodiscard]] VoxelRuns voxels(std::uint8_t label, std::uint8_t value) const
    {
        VoxelRuns runs;
        forEachRow([&](std::size_t of, std::size_t in, int width) {
            for (int x = 0; x < width;) {
                const int begin = x;
                while (x < width && m_labels[of + std::size_t(x)] == label
                    && m_mask.voxels[in + std::size_t(x)] == value)
                    ++x;
                if (x > begin)
                    runs.append(of + std::size_t(begin), std::uint64_t(x - begin));
                else
                    ++x;
            }
        });
        return runs;
    }
    [[nodiscard]] VoxelRuns freeIn() const { return voxels(0, 1); }
    [[nodiscard]] VoxelRuns ownIn() const { return voxels(m_label, 1); }
    [[nodiscard]] VoxelRuns ownOutside() const { return voxels(m_label, 0); }

private:
    FilterStage nextStage() { return {m_progress, m_stage++, m_stages}; }
    /// Calls @p visit(index in the labels, index in the mask, width) for each row of the box, as
    /// far as it lies in the volume, and until the work is cancelled.
    template <class Visit> void forEachRow(const Visit& visit) const
    {
        const glm::ivec3 begin = glm::max(m_first, glm::ivec3(0));
        const glm::ivec3 end = glm::min(m_first + m_mask.size, m_size);
        for (int z = begin.z; z < end.z && !m_progress.cancelled(); ++z) {
            for (int y = begin.y; y < end.y; ++y)
                visit(indexOf({begin.x, y, z}, m_size),
                    indexOf(glm::ivec3(begin.x, y, z) - m_first, m_mask.size), end.x - begin.x);
        }
    }
    static std::size_t indexOf(const glm::ivec3& at, const glm::ivec3& size)
    {
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
            + std::size_t(at.x);
    }

    std::span<const std::uint8_t> m_labels;
    glm::ivec3 m_size;
    std::uint8_t m_label;
    const MillimetreBall& m_ball;
    const Progress& m_progress;
    int m_stages;
    int m_stage = 0;
    glm::ivec3 m_first{0}; ///< of the box in the volume
    ByteMask m_mask;
};

int stagesOf(ShapeOperation operation, ShellPlace place)
{
    switch (operation) {
    case ShapeOperation::Grow:
    case ShapeOperation::Shrink:
        return 1;
    case ShapeOperation::Hollow:
        return place == ShellPlace::Centred ? 2 : 1;
    case ShapeOperation::Open:
    case ShapeOperation::Close:
    case ShapeOperation::Median:
    case ShapeOperation::Wrap:
        return 2;
    case ShapeOperation::Gaussian:
        break;
    }
    return 1;
}

/// Whether an operation only asks which of the segment's own voxels are near voxels outside it. On
/// a grid with perpendicular axes the nearest of those always lies in the segment's box or touches
/// it, so a margin of one voxel suffices.
bool looksOnlyInside(ShapeOperation operation, ShellPlace place)
{
    return operation == ShapeOperation::Shrink || operation == ShapeOperation::Open
        || (operation == ShapeOperation::Hollow && place == ShellPlace::Inside);
}

Result<ShapeChange> hollowed(Reshaping& work, ShellPlace place)
{
    ShapeChange change;
    if (place != ShellPlace::Inside) {
        work.fill(Side::Segment);
        if (const Result<void> done = work.spread(); !done)
            return tl::unexpected(done.error());
        change.given = work.freeIn();
        change.taken = work.ownIn();
    }
    if (place != ShellPlace::Outside) {
        work.fill(Side::Rest);
        if (const Result<void> done = work.spread(); !done)
            return tl::unexpected(done.error());
        change.taken = work.ownOutside();
    }
    return change;
}

/// @param first what is spread first: the rest to open, the segment to close
Result<ShapeChange> openedOrClosed(Reshaping& work, Side first)
{
    work.fill(first);
    for (int half = 0; half < 2; ++half) {
        if (const Result<void> done = work.spread(); !done)
            return tl::unexpected(done.error());
        work.invert();
    }
    // The mask is now the closing of what was spread first. The closing of the rest contains, of
    // the segment, the voxels that no ball within the segment covers.
    if (first == Side::Rest)
        return ShapeChange{.given = {}, .taken = work.ownIn()};
    return ShapeChange{.given = work.freeIn(), .taken = {}};
}

/// The centre of the ball can reach, from outside, every voxel that the segment grown by the ball
/// does not enclose. From there the ball covers everything except what is wrapped.
Result<ShapeChange> wrapped(Reshaping& work)
{
    work.fill(Side::Segment);
    if (const Result<void> done = work.spread(); !done)
        return tl::unexpected(done.error());
    if (const Result<void> done = work.fillEnclosed(); !done)
        return tl::unexpected(done.error());
    work.invert();
    if (const Result<void> done = work.spread(); !done)
        return tl::unexpected(done.error());
    work.invert();
    return ShapeChange{.given = work.freeIn(), .taken = {}};
}

Result<ShapeChange> smoothed(Reshaping& work)
{
    ShapeChange change;
    work.fill(Side::Segment);
    if (const Result<void> done = work.vote(); !done)
        return tl::unexpected(done.error());
    change.given = work.freeIn();
    work.fill(Side::Rest);
    if (const Result<void> done = work.vote(); !done)
        return tl::unexpected(done.error());
    change.taken = work.ownIn();
    return change;
}

Result<ShapeChange> changeBy(ShapeOperation operation, ShellPlace place, Reshaping& work)
{
    switch (operation) {
    case ShapeOperation::Hollow:
        return hollowed(work, place);
    case ShapeOperation::Open:
        return openedOrClosed(work, Side::Rest);
    case ShapeOperation::Close:
        return openedOrClosed(work, Side::Segment);
    case ShapeOperation::Median:
        return smoothed(work);
    case ShapeOperation::Wrap:
        return wrapped(work);
    case ShapeOperation::Gaussian:
        return ShapeChange();
    case ShapeOperation::Grow:
    case ShapeOperation::Shrink:
        break;
    }
    const bool grows = operation == ShapeOperation::Grow;
    work.fill(grows ? Side::Segment : Side::Rest);
    if (const Result<void> done = work.spread(); !done)
        return tl::unexpected(done.error());
    if (grows)
        return ShapeChange{.given = work.freeIn(), .taken = {}};
    return ShapeChange{.given = {}, .taken = work.ownIn()};
}

} // namespace

Result<ShapeChange> shapeChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, ShapeOperation operation, ShellPlace place, const MillimetreBall& ball,
    const Progress& progress)
{
    const VoxelBox own = boxOfLabel(labels, size, label);
    if (own.empty())
        return ShapeChange();
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    Reshaping work(labels, size, label, ball, progress, stagesOf(operation, place));
    const bool isNear = looksOnlyInside(operation, place) && ball.isStraight();
    if (const Result<void> begun = work.begin(own, isNear ? glm::ivec3(1) : ball.extent,
            operation == ShapeOperation::Close || operation == ShapeOperation::Wrap);
        !begun)
        return tl::unexpected(begun.error());
    Result<ShapeChange> change = changeBy(operation, place, work);
    if (progress.cancelled()) // then it is not all of it
        return failure(ErrorCode::Cancelled);
    return change;
}

} // namespace core
