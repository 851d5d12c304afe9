// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/sculpt/SculptEdits.h"
#include "core/session/state/SessionState.h"

#include <map>
#include <set>
#include <vector>

namespace core {

/// What one stroke cuts by itself: bytes of coverage by brick, bricks that it misses left out.
using StrokeCut = std::map<std::uint32_t, BrickBytes>;

/// Lends the engine's coverage for a look into the past: takes it back to what it was before an
/// older row and cuts there, into a layer that no document has, so that the stroke starts on the
/// surface that it found then and what it cuts stands alone. Labels go back with it where strokes
/// spare segments. Part of ReviseOperation.
///
/// Nothing here is a row; whoever began it ends it by restore(). Tickets follow each other, so of
/// several commands only the last is waited for.
class PastCoverage {
public:
    /// @param path rows from the earliest that is looked back to, to the history's position
    /// @param labels whether labels are looked back to as well
    PastCoverage(std::vector<RowId> path, bool labels);

    /// What a row of the path changed.
    void addDifferences(RowId row, std::vector<BrickImage>&& differences);
    /// The bricks that the rows of the path changed.
    [[nodiscard]] std::vector<BrickKey> keys() const;
    /// Bricks as they are at the position, or at any row where no row of the path changed them.
    void addImages(const std::vector<BrickChange>& read);
    [[nodiscard]] bool knows(const BrickKey& key) const { return m_images.count(key) != 0; }

    /// As it is where the engine's coverage stands now.
    [[nodiscard]] const BrickImage& image(const BrickKey& key) const { return m_images.at(key); }

    /// To before a row of the path.
    void goBefore(SessionState& state, RowId row);
    /// Lays other bricks over the past, until the next goBefore() or restore().
    void overlay(SessionState& state, const std::map<BrickKey, BrickImage>& images);
    /// @return the ticket whose result cutOf() reads; or why it cannot be cut. What a restoring
    /// stroke gives back is cut too.
    [[nodiscard]] Result<Ticket> cut(SessionState& state, const SculptEdit& edit);
    [[nodiscard]] StrokeCut cutOf(const EngineResult& result);
    /// Of a result that nobody reads: what may stand in the layer of the cuts goes with restore().
    void discard(const EngineResult& result);
    /// Back to the position; done when SessionState owes nothing any more.
    void restore(SessionState& state);

private:
    void walk(std::size_t place);
    [[nodiscard]] SwapBricks takeToPut();
    void put(SessionState& state);
    /// Layers as they were after a row: what is seen, and so where a stroke starts.
    [[nodiscard]] static MuteLayers mutedAt(const SessionState& state, RowId at);

    std::vector<RowId> m_path;
    bool m_labels = false;
    std::map<RowId, std::vector<BrickImage>> m_differences; ///< of coverage, and of labels
    std::map<BrickKey, BrickImage> m_images; ///< at m_place
    std::map<BrickKey, BrickImage> m_toPut;
    std::set<BrickKey> m_touched; ///< all that was put, done or refused
    std::size_t m_place; ///< rows of the path that are done there
};

} // namespace core
