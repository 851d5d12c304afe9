// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/chunks/ChunkMap.h"
#include "core/chunks/ChunkStage.h"
#include "core/document/Document.h"
#include "core/history/History.h"
#include "gpu/scene/Scene.h"
#include "ui/settings/ChunkLeaves.h"
#include "ui/workspace/ChunkMembers.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace core {
class SessionChunks;
}

namespace ui {

class Workspace;

/// The chunks that a segment and what lies around it are divided into (seed B, section 4), as the
/// window has them: into how many, what they look like, which of them the segment has. Tools click
/// on them through the session. Part of Workspace.
class Chunks : public QObject {
    Q_OBJECT

public:
    using Chunk = core::ChunkTree::Chunk;
    /// Which of them the 3D view shows: the segment's; those, too, that look more like the segment
    /// than like what they are of; all.
    enum class Bodies { Own, Alike, All };
    /// No step of undo.
    struct Look {
        bool shown = false; ///< chunks are worked out only for who looks at them
        int count = 60; ///< into so many, as far as that is possible
        float opacity = 0.4f;
        Bodies bodies = Bodies::Alike;
        bool operator==(const Look&) const = default;
    };
    static constexpr int fewest = 5;
    static constexpr int most = core::ChunkTree::mostChunks;

    explicit Chunks(Workspace& workspace);

    /// None: nothing is divided.
    [[nodiscard]] std::optional<core::ChunkDivision> division() const;
    /// Null: they are not shown, or are not there yet.
    [[nodiscard]] const core::ChunkMap* map() const
    {
        return m_leaves ? m_leaves->map.get() : nullptr;
    }
    /// They are to be shown, and are being worked out.
    [[nodiscard]] bool isWorking() const;
    /// Which of them are the segment's own is being counted; what is shown may change.
    [[nodiscard]] bool isCounting() const { return m_members.isCounting(); }
    /// How far that is; changes without a signal.
    [[nodiscard]] core::ChunkStage stage() const;
    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);

    /// Into how many it is divided at present, for edits; specks that touch nothing of their kind
    /// are on top of what was asked for, or a ragged mask would have nothing else.
    [[nodiscard]] int count() const;
    /// The same without specks, and how many of these the segment has.
    [[nodiscard]] int shownCount() const { return count() - m_specks; }
    [[nodiscard]] int ownCount() const;
    [[nodiscard]] std::optional<Chunk> chunkAt(const glm::ivec3& voxel) const;
    /// Whether the segment has more than half of it.
    [[nodiscard]] bool has(Chunk chunk) const;
    [[nodiscard]] double millilitres(Chunk chunk) const;
    /// Drawn brightly: those that a tool is about.
    void setLit(std::vector<Chunk> chunks);

    /// What slices and the 3D view draw of them; null: nothing.
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> areas() const { return m_areas; }
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> bodies() const { return m_bodies; }

    /// The active segment and what lies around it.
    void divide(double marginMm);
    /// Chunks that are being worked out are not wanted: the division is undone.
    void abort();

Q_SIGNALS:
    void changed(); ///< the division, what is known of its chunks, or which the segment has
    void lookChanged();
    void pictureChanged(); ///< areas() or bodies()

private:
    void follow();
    void takeBack();
    /// Of the session; null: there is none.
    [[nodiscard]] core::SessionChunks* chunks() const;
    void take(const std::shared_ptr<const ChunkLeaves>& leaves);
    void countOwn();
    void colour();
    [[nodiscard]] std::vector<std::uint32_t> argbOfLeaves(bool bodies) const;
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> scene(
        std::vector<std::uint32_t> argb) const;

    Workspace& m_workspace;
    Look m_look;
    ChunkMembers m_members;
    std::shared_ptr<const core::ChunkMap> m_wanted; ///< of which m_leaves are, or are to be
    std::shared_ptr<const ChunkLeaves> m_leaves;
    int m_segment = 0; ///< of the division that they are of
    core::RowId m_dividedAfter = 0; ///< later divisions are of divide()
    int m_specks = 0; ///< chunks that are never joined, and small
    std::vector<Chunk> m_chunkOfLeaf; ///< at the present count, like the next two
    std::vector<std::uint8_t> m_colourOfLeaf;
    int m_count = 0; ///< that these are for; 0: none
    std::vector<bool> m_has; ///< by chunk: the segment has more than half of it
    std::vector<Chunk> m_lit;
    std::shared_ptr<const gpu::SceneChunks> m_areas;
    std::shared_ptr<const gpu::SceneChunks> m_bodies;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
