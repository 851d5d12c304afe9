// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/session/state/ChunkWorker.h"
#include "core/session/state/CommitWorker.h"
#include "core/session/state/RecentSteps.h"
#include "core/session/surface/SideThread.h"
#include "core/session/surface/SurfaceState.h"
#include "core/sessionfile/SessionFile.h"

#include <array>
#include <bitset>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace core {

/// What the operations of a session work on: document, history and where both are kept. Part of
/// EditSession; one thread.
class SessionState {
public:
    /// What the last ReviseStroke found.
    struct Revision {
        RowId row = 0; ///< the one it became
        std::vector<RowId> begunInside; ///< later strokes that would have met another surface
    };

    /// Why the last growth that stopped by itself did.
    struct Alarm {
        RowId row = 0; ///< the one it became
        LeakAlarm found;
    };

    SessionState(EditEngine& lentEngine, Volume volume);

    /// A command was carried out on voxels: what it changes in the document, and a row for it, in
    /// memory and on its way to disk.
    void commit(const Edit& edit, EngineResult&& result, std::optional<std::uint32_t> generation);
    /// An edit of the surface was carried out: a row for it. The surface is as the step left it.
    /// @param remark what the row's title says at its end, or nothing
    void commitSurface(const Edit& edit, std::shared_ptr<const SurfaceStep> step,
        const std::optional<RowTitle>& remark = {});
    void completeSurface(RowId row, std::shared_ptr<const SurfaceStep> step);
    /// A row of an opened session was carried out again, because it lacked its second half.
    void complete(RowId row, EngineResult&& result);
    /// The voxels now are those of @p position: a row was carried out again or taken back.
    void moveTo(RowId position, RowId over, EngineResult&& result);
    /// Takes in the bricks of an opened session.
    void begin(std::vector<BrickImage> bricks);

    void setVisible(int label, bool visible);
    void hide(const std::vector<int>& labels);
    void setDisplay(const QJsonObject& shown);

    /// Has the engine do what all that follows relies on: no operation begins before it is done.
    /// What is refused is asked for again; where that is of no use either, the session is lost: its
    /// voxels are not what the history says, so nothing is carried out any more.
    void require(EngineCommand command);
    [[nodiscard]] bool owes() const { return !m_required.empty(); }
    /// Calls @p then once nothing is owed, now or later; never in a session that is lost.
    void afterRequired(std::function<void(SessionState&)> then);
    /// Every result comes by here first. @return whether it was of something required
    bool noteResult(const EngineResult& result);
    /// What the engine or the worker hold is not what the history says: nothing is carried out or
    /// sealed any more. What is in the file is whole, and opens again.
    void lose(const Error& why);
    /// Why nothing is carried out any more.
    [[nodiscard]] const std::optional<Error>& lost() const { return m_lost; }

    void tell(DocumentChange::What what, const VoxelBox& box = {});
    void fail(const Error& error);

    /// The document after a row (0: at the beginning), without the volume and what is only shown.
    [[nodiscard]] Document documentAt(RowId row) const;
    /// The newest division into chunks on the way to the position; 0: none, or none that counts.
    [[nodiscard]] RowId divisionRow() const;
    /// Has its chunks worked out, unless they are there.
    void wantChunks();
    /// The canonical form that the state hash covers.
    [[nodiscard]] QByteArray documentJson() const;

    EditEngine& engine;
    Document document;
    History history;
    QJsonObject display; ///< opaque here (SessionDisplay::kept())
    std::unique_ptr<SessionFile> file; ///< null: history in memory only
    std::unique_ptr<CommitWorker> worker; ///< after file: it writes there to the end
    std::unique_ptr<ChunkWorker> chunks;
    std::function<RowOrigin()> origin; ///< of a row that is made now
    std::set<RowId> keyframes; ///< rows that have a picture in the file

    SurfaceState surface;
    std::unique_ptr<SideThread> side; ///< after surface: it may be deforming that to the end

    RecentSteps recent;
    Revision lastRevision;
    std::optional<Alarm> lastAlarm;
    std::optional<SketchedSeeds> lastSketched; ///< of the last SeedStroke, row or no row
    std::vector<DocumentChange> news; ///< not told yet
    std::vector<Error> errors; ///< not told yet
    std::vector<std::function<void()>> answers; ///< to questions about the history; not given yet
    std::optional<Error> firstError; ///< since settle() was called last

private:
    RowId append(const Edit& edit, const ChangeFacts& facts, const EditStatistics& statistics,
        std::optional<std::uint32_t> generation, const std::optional<RowTitle>& remark = {});
    void tellCommitted(const Edit& edit);
    void takeIn(const ChangeFacts& facts);
    void placeDocument();
    void placeSegments();
    void muteLayers();
    void showSurface();

    std::array<std::int64_t, 256> m_voxels{}; ///< by label
    std::set<int> m_hidden; ///< labels
    std::bitset<256> m_muted; ///< layers, as the engine was told
    struct Required {
        EngineCommand command; ///< to be asked for again
        int tries = 1;
    };
    void submitRequired(Required required);

    std::map<Ticket, Required> m_required;
    Ticket m_lastMute = 0; ///< of the required ones
    std::function<void(SessionState&)> m_afterRequired;
    std::optional<Error> m_lost;
    bool m_isSurfaceShown = false;
};

} // namespace core
