// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/engine/ChangeFacts.h"
#include "core/engine/EditEngine.h"
#include "core/growth/GrowthCommands.h"
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
#include <utility>
#include <vector>

namespace core {

/// The state on which the operations of a session work: document, history, and where both are kept.
/// Part of EditSession; one thread.
class SessionState {
public:
    /// The result of the last ReviseStroke.
    struct Revision {
        RowId row = 0; ///< the row of that ReviseStroke
        std::vector<RowId> begunInside; ///< later strokes that would now meet another surface
    };

    /// Why the last growth that stopped by itself did so.
    struct Alarm {
        RowId row = 0; ///< the row of that growth
        LeakAlarm found;
    };

    SessionState(EditEngine& lentEngine, Volume volume);

    /// Records that a command was carried out on voxels: changes the document accordingly and
    /// appends a row, in memory and for the disk.
    void commit(const Edit& edit, EngineResult&& result, std::optional<std::uint32_t> generation);
    /// Records that an edit of the surface was carried out, as a row. The surface is already in the
    /// state after the step.
    /// @param remark an addition to the row's name; may be empty
    void commitSurface(const Edit& edit, std::shared_ptr<const SurfaceStep> step,
        const std::optional<RowTitle>& remark = {});
    void completeSurface(RowId row, std::shared_ptr<const SurfaceStep> step);
    /// Records that a row of an opened session was carried out again because it lacked its second
    /// half.
    void complete(RowId row, EngineResult&& result);
    /// Records that the voxels are now those of @p position: a row was redone or undone.
    void moveTo(RowId position, RowId over, EngineResult&& result);
    /// Takes the bricks of an opened session.
    void begin(std::vector<BrickImage> bricks);

    /// By label.
    void setVisible(const std::vector<std::pair<int, bool>>& segments);
    void hide(const std::vector<int>& labels);
    void setDisplay(const QJsonObject& shown);

    /// Has the engine carry out a command on which everything later depends: no operation begins
    /// before it is done. A refused command is submitted again; if that fails too, the session is
    /// lost: its voxels are not what the history says, so nothing is carried out any more.
    void require(EngineCommand command);
    [[nodiscard]] bool owes() const { return !m_required.empty(); }
    /// Calls @p then when nothing is owed, now or later; never in a session that is lost.
    void afterRequired(std::function<void(SessionState&)> then);
    /// Every result is passed here first. @return whether it belonged to a required command
    bool noteResult(const EngineResult& result);
    /// Marks the session as lost: engine or worker do not hold what the history says, so nothing is
    /// carried out or sealed any more. The file is intact and can be opened again.
    void lose(const Error& why);
    /// Why nothing is carried out any more.
    [[nodiscard]] const std::optional<Error>& lost() const { return m_lost; }

    void notify(DocumentChange::What what, const VoxelBox& box = {});
    void fail(const Error& error);

    /// The document after a row (0: the beginning), without the volume and display state.
    [[nodiscard]] Document documentAt(RowId row) const;
    /// The row of the newest division into chunks on the path to the position; 0: none, or none
    /// that is in effect.
    [[nodiscard]] RowId divisionRow() const;
    /// Has its chunks computed, unless they are available.
    void wantChunks();
    /// The canonical JSON that the state hash covers.
    [[nodiscard]] QByteArray documentJson() const;

    EditEngine& engine;
    Document document;
    History history;
    QJsonObject display; ///< not interpreted here (SessionDisplay::kept())
    std::unique_ptr<SessionFile> file; ///< null: history in memory only
    std::unique_ptr<CommitWorker> worker; ///< after file, to which it writes until the end
    std::unique_ptr<ChunkWorker> chunks;
    std::function<RowOrigin()> origin; ///< gives the origin of a new row
    std::set<RowId> keyframes; ///< rows with a picture in the file

    SurfaceState surface;
    std::unique_ptr<SideThread> side; ///< after surface, which it may deform until the end

    RecentSteps recent;
    Revision lastRevision;
    std::optional<Alarm> lastAlarm;
    /// of the last SeedStroke, whether or not it left a row
    std::optional<SketchedSeeds> lastSketched;
    std::vector<DocumentChange> news; ///< not reported yet
    std::vector<Error> errors; ///< not reported yet
    /// to questions about the history; not delivered yet
    std::vector<std::function<void()>> answers;
    std::optional<Error> firstError; ///< since the last settle()

private:
    RowId append(const Edit& edit, const ChangeFacts& facts, const EditStatistics& statistics,
        std::optional<std::uint32_t> generation, const std::optional<RowTitle>& remark = {});
    void noteIntervals(
        const Edit& edit, const ChangeFacts& facts, EditStatistics& statistics) const;
    void notifyCommitted(const Edit& edit);
    void takeIn(const ChangeFacts& facts);
    void placeDocument();
    void placeSegments();
    void showNewSegments(const std::vector<int>& labelsBefore);
    void muteLayers();
    void showSurface();

    std::array<std::int64_t, 256> m_voxels{}; ///< by label
    std::set<int> m_hidden; ///< labels
    std::bitset<256> m_muted; ///< layers, as last sent to the engine
    struct Required {
        std::shared_ptr<const EngineCommand> command; ///< kept for another try
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
