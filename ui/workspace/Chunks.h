// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/chunks/ChunkMap.h"
#include "core/chunks/ChunkStage.h"
#include "core/document/Document.h"
#include "core/history/History.h"
#include "gpu/scene/Scene.h"
#include "ui/settings/ChunkLeaves.h"
#include "ui/settings/LikelyChunks.h"
#include "ui/workspace/ChunkMembers.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace core {
struct CoarseChunks;
struct DivideSegment;
class SessionChunks;
} // namespace core

namespace ui {

class Workspace;

/// The chunks into which a segment and its surroundings are divided (seed B, section 4), as the
/// window uses them: how many there are, how they look, and which of them the segment contains.
/// Tools change the segment through the session. Part of Workspace.
class Chunks : public QObject {
    Q_OBJECT

public:
    using Chunk = core::ChunkTree::Chunk;
    /// Which chunks the 3D view shows: those of the segment; also those that look more like the
    /// segment than like their surroundings; all.
    enum class Bodies { Own, Alike, All };
    /// How chunks are divided and shown; not a step of undo.
    struct Look {
        bool shown = false; ///< chunks are computed only while they are shown
        int count = 60; ///< wanted number of chunks; approximated where it is impossible
        float opacity = 0.4f;
        Bodies bodies = Bodies::Alike;
        bool operator==(const Look&) const = default;
    };
    static constexpr int fewest = 5;
    static constexpr int most = core::ChunkTree::mostChunks;

    explicit Chunks(Workspace& workspace);

    /// The present division; none if nothing is divided.
    [[nodiscard]] std::optional<core::ChunkDivision> division() const;
    /// The chunks; null if they are not shown, or not computed yet.
    [[nodiscard]] const core::ChunkMap* map() const
    {
        return m_leaves ? m_leaves->map.get() : nullptr;
    }
    /// Whether chunks are to be shown and are still being computed.
    [[nodiscard]] bool isWorking() const;
    /// Whether the chunks of the segment are being counted, or those in doubt looked for, so that
    /// what is shown may change.
    [[nodiscard]] bool isCounting() const { return m_members.isCounting() || m_likely.isLooking(); }
    /// How far the computation is; changes without a signal.
    [[nodiscard]] core::ChunkStage stage() const;
    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);

    /// The present number of chunks, for edits. Specks (small chunks that touch no other one of
    /// their kind) come on top of the wanted number; otherwise a ragged mask would yield nothing
    /// but specks.
    [[nodiscard]] int count() const;
    /// The number without specks, and how many chunks the segment contains.
    [[nodiscard]] int shownCount() const { return count() - m_specks; }
    [[nodiscard]] int ownCount() const;
    [[nodiscard]] std::optional<Chunk> chunkAt(const glm::ivec3& voxel) const;
    /// Whether the segment contains more than half of the chunk.
    [[nodiscard]] bool has(Chunk chunk) const;
    /// How many voxels it has.
    [[nodiscard]] std::int64_t voxels(Chunk chunk) const;
    /// The number of chunks, as in Look, at which the most doubtful part is a chunk of its own; a
    /// new division begins with it. None: nothing is in doubt, or the chunks are not computed.
    [[nodiscard]] std::optional<int> suggestedCount() const;
    /// The few chunks that the user will most likely click on, which are drawn with a rim; the
    /// most likely one first.
    using Likely = core::DoubtfulChunks::Doubtful;
    [[nodiscard]] const std::vector<Likely>& likely() const { return m_likely.all(); }
    /// A place in one of them, about in its middle.
    [[nodiscard]] glm::dvec3 placeLps(const Likely& likely) const;
    /// Sets the chunks that are drawn brightly because a tool points at them.
    void setLit(std::vector<Chunk> chunks);

    /// What slices (areas) and the 3D view (bodies) draw of them; null if nothing. While those of a
    /// large box are being computed, an approximation of them in cells of several voxels.
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> areas() const { return m_areas; }
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> bodies() const { return m_bodies; }

    /// Divides the active segment and its surroundings, as far as @p marginMm.
    /// @param probabilityFile a probability map of the segment, which is read in the background;
    /// empty: the image alone decides
    void divide(double marginMm, const QString& probabilityFile = {});
    /// Whether a probability map is being read.
    [[nodiscard]] bool isReading() const { return m_reading.busy(); }
    /// Cancels the computation and undoes the division.
    void abort();

Q_SIGNALS:
    void changed(); ///< the division, its chunks, or which of them the segment contains
    void lookChanged();
    void pictureChanged(); ///< areas() or bodies()

private:
    void apply(const core::DivideSegment& division);
    void follow();
    void takeBack();
    void sayThatItStays();
    void undo();
    /// The chunks of the session; null if there is no session.
    [[nodiscard]] core::SessionChunks* chunks() const;
    void take(const std::shared_ptr<const ChunkLeaves>& leaves);
    void countOwn();
    void colour();
    /// Whether the 3D view leaves out a chunk of others that looks so much like the segment.
    [[nodiscard]] bool isHidden(int likelihood) const;
    [[nodiscard]] std::vector<std::uint32_t> argbOfLeaves(bool bodies) const;
    [[nodiscard]] std::vector<std::uint32_t> rimsOfLeaves() const;
    [[nodiscard]] bool isJustDivided() const;
    void lookForLikely();
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> scene(
        std::vector<std::uint32_t> argb, const std::vector<std::uint32_t>& rims) const;

    Workspace& m_workspace;
    Look m_look;
    ChunkMembers m_members;
    LikelyChunks m_likely;
    /// The chunks from which m_leaves are made or being made.
    std::shared_ptr<const core::ChunkMap> m_wanted;
    std::shared_ptr<const ChunkLeaves> m_leaves;
    std::shared_ptr<const core::CoarseChunks> m_coarse; ///< null: not known, or those are drawn
    int m_division = 0; ///< to which that belongs
    int m_segment = 0; ///< the segment that they belong to
    core::RowId m_dividedAfter = 0; ///< a division after this row comes from divide()
    bool m_isAwaited = false; ///< a division that divide() asked for
    /// The division that is awaited begins with the suggested number.
    bool m_takesSuggestion = false;
    int m_specks = 0; ///< number of small chunks that are never merged
    std::vector<Chunk> m_chunkOfLeaf; ///< for the present count, like the next two
    std::vector<std::uint8_t> m_colourOfLeaf;
    int m_count = 0; ///< the count for which they are; 0: none
    std::vector<bool> m_has; ///< by chunk: whether the segment contains more than half of it
    std::vector<Chunk> m_lit;
    std::shared_ptr<const gpu::SceneChunks> m_areas;
    std::shared_ptr<const gpu::SceneChunks> m_bodies;
    core::Background m_background; ///< these last: they use all of the above
    core::Background m_reading;
};

} // namespace ui
