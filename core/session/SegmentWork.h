// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

class OperationQueue;

/// The edit of a segment that is being computed at present, also for its preview (CleanSegment,
/// ReshapeSegment, FillBetweenSlices, FloodFill, MirrorSegment, EvolveContour, SplitIslands,
/// SplitSegment, CopySegment, SplitByCurve, ImportMask); or a RevertRows that looks where imports
/// of masks have voxels; or, once it is to be a step, an edit for which the engine goes through the
/// volume (InvertSegment, CombineSegments, ThresholdSegment, SegmentScissors, GrowFromSeeds). Part
/// of EditSession.
class SegmentWork {
public:
    explicit SegmentWork(OperationQueue& queue);

    /// The percentage of it that is done; none: no such edit is running, or what was computed is
    /// already being written.
    [[nodiscard]] std::optional<int> percent() const;
    /// Whether it is for a preview that stands open, which is its dialog's. One that waits in line
    /// behind other work is not.
    [[nodiscard]] bool isPreview() const;
    /// Abandons it. The session then reports the error Cancelled; voxels and history stay as they
    /// were. Does nothing if percent() is empty.
    void abort();

private:
    OperationQueue& m_queue;
};

} // namespace core
