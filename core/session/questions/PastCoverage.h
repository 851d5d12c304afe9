// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/BrickCommands.h"
#include "core/engine/LayerCommands.h"
#include "core/session/state/SessionState.h"

#include <map>
#include <set>
#include <vector>

namespace core {

/// What one stroke cuts by itself: bytes of coverage by brick. Bricks that it does not touch are
/// left out.
using StrokeCut = std::map<std::uint32_t, BrickBytes>;

/// Temporarily takes the engine's coverage back to what it was before an older row, so that a
/// stroke can be cut again on the surface that it found then. It cuts into a layer that no document
/// has, so that its cut stands alone. Labels are taken back too if strokes exclude protected
/// segments. Part of ReviseOperation.
///
/// This makes no row. The caller ends it by restore(). Tickets are consecutive, so of several
/// commands only the last one is awaited. Only the walk reads voxels; it runs on the side thread.
class PastCoverage {
public:
    /// @param path rows from the earliest one that is needed to the position of the history
    /// @param labels whether labels are taken back as well
    PastCoverage(std::vector<RowId> path, bool labels);

    /// Adds what a row of the path changed.
    void addDifferences(RowId row, std::vector<BrickImage>&& differences);
    /// The bricks that rows of the path changed.
    [[nodiscard]] std::vector<BrickKey> keys() const;
    /// Adds bricks as they are at the position, or, if no row of the path changed them, at any row.
    void addImages(const std::vector<BrickChange>& read);
    [[nodiscard]] bool knows(const BrickKey& key) const { return m_images.count(key) != 0; }

    /// Works out the bricks before a row of the path.
    void walkBefore(RowId row);

    /// A brick at the place of the last walk.
    [[nodiscard]] const BrickImage& image(const BrickKey& key) const { return m_images.at(key); }

    /// Takes the engine to the state before a row, after walkBefore().
    void putBefore(SessionState& state, RowId row);
    /// Puts other bricks over the past, until the next putBefore() or restore().
    void overlay(SessionState& state, const std::map<BrickKey, BrickImage>& images);
    /// Cuts a stroke. What a restoring stroke would refill is cut too.
    /// @return the ticket whose result cutOf() reads, or why it cannot be cut
    [[nodiscard]] Result<Ticket> cut(SessionState& state, const SculptEdit& edit);
    [[nodiscard]] StrokeCut cutOf(EngineResult&& result);
    /// For a result that is not needed: what it may have left in the layer of the cuts is removed
    /// by restore().
    void discard(const EngineResult& result);
    /// Returns to the position, also after a walk or a put that has thrown; finished when
    /// SessionState owes nothing any more.
    void restore(SessionState& state);

private:
    void walk(std::size_t place);
    [[nodiscard]] SwapBricks takeToPut();
    void put(SessionState& state);
    /// Which layers are muted after a row. They decide what is visible, and so where a stroke
    /// starts.
    [[nodiscard]] static MuteLayers mutedAt(const SessionState& state, RowId at);

    std::vector<RowId> m_path;
    bool m_labels = false;
    std::map<RowId, std::vector<BrickImage>> m_differences; ///< of coverage and labels
    std::map<BrickKey, BrickImage> m_images; ///< at m_place
    std::map<BrickKey, BrickBytes> m_atPosition; ///< the same bricks, as they were read
    std::map<BrickKey, BrickImage> m_toPut;
    std::vector<BrickChange> m_lastCut; ///< until all of it is in m_toPut
    std::set<BrickKey> m_touched; ///< all bricks that were put, whether carried out or refused
    std::size_t m_place; ///< number of rows of the path that are in effect there
};

} // namespace core
