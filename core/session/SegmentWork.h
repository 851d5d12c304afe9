// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

class OperationQueue;

/// The edit of a segment that is being worked out (CleanSegment, ReshapeSegment, FillBetweenSlices,
/// FloodFill, MirrorSegment, EvolveContour, SplitIslands, SplitSegment). Part of EditSession.
class SegmentWork {
public:
    explicit SegmentWork(OperationQueue& queue);

    /// How much of it is done; none: no such edit is running, or its voxels are being written.
    [[nodiscard]] std::optional<int> percent() const;
    /// Abandons it. It is reported as Cancelled, and voxels and history stay as they were.
    void abort();

private:
    OperationQueue& m_queue;
};

} // namespace core
