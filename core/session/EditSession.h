// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FileInUse.h"
#include "core/delta/Ending.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/growth/GrowthProgress.h"
#include "core/history/History.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace core {

class EditEngine;
class OperationQueue;
class SegmentWork;
class SessionChunks;
class SessionDisplay;
class SessionFile;
class SessionKeyframes;
class SessionStorage;
class SessionSurface;
class StepFindings;
class VoxelQuestions;

/// The controller: turns strokes and other edits into commands for the engine, and keeps the
/// results in the history and the session file.
///
/// It owns the document and the history of one open volume; the engine is lent. At most one stroke
/// is open at a time, and whoever began it ends it. Only settle(), endWork(), endUnheard() and
/// the destructor block. All members, including those of the parts, are called from one thread.
class EditSession {
public:
    struct Options {
        QString file; ///< session file; empty: history in memory only
        /// Begin in memory if the file cannot be created (SessionStorage).
        bool beginWithoutFile = false;
        /// called on another thread whenever poll() has something to do
        std::function<void()> wakeUp{};
    };

    /// Begins with an empty history on a volume. Errors: FileExists, FileUnwritable, and the
    /// engine's.
    static Result<std::unique_ptr<EditSession>> create(
        EditEngine& engine, LoadedVolume volume, Options options);
    /// Continues a session file where it stopped; the volume must be the one that the file refers
    /// to. Rows whose delta did not reach the disk are executed again. If the disk is still full,
    /// they wait in memory. Errors: SessionDamaged, SessionMismatch (the file belongs to another
    /// volume).
    static Result<std::unique_ptr<EditSession>> open(EditEngine& engine, LoadedVolume volume,
        const QString& file, std::function<void()> wakeUp = {});
    /// Opens a session for viewing, without changing the file or its folder. Undo, redo and goTo()
    /// work; edits are refused with SessionReadOnly and @p why until SessionStorage::saveAs().
    static Result<std::unique_ptr<EditSession>> view(EditEngine& engine, LoadedVolume volume,
        const QString& file, const QString& why, std::function<void()> wakeUp = {});
    /// Commits a running growth, waits for the disk and closes the file as a single one.
    ~EditSession();

    [[nodiscard]] const Document& document() const;
    /// The document after the edits that are waiting (undo and redo are not taken into account).
    [[nodiscard]] Document foreseenDocument() const;
    [[nodiscard]] const History& history() const;
    /// Where the history will stand once the walks that are waiting or running have arrived. None:
    /// an edit is under way that may become a row; previews are not.
    [[nodiscard]] std::optional<RowId> foreseenPosition() const;
    [[nodiscard]] GrowthProgress growthProgress() const;
    [[nodiscard]] QString file() const; ///< empty: history in memory only
    [[nodiscard]] QString whyReadOnly() const; ///< why edits are refused; empty: they are allowed

    /// Carries out a whole edit. Errors are returned before anything changes; the row of the
    /// history follows when the edit is done.
    Result<void> apply(const Edit& edit);

    /// Interactive edits (canStandOpen() in core/edits/EditTask.h): begin, then extend any number
    /// of times, then end. A stroke begins without samples of the pen and with the first point of
    /// its path.
    Result<void> begin(const Edit& edit);
    /// What does not apply to the open edit, and what is out of range, is ignored. The kind of the
    /// edit decides what it makes of it (core/edits/open/OpenStroke.h).
    void extend(const StrokeExtension& extension);
    void end(Ending ending);
    /// Takes an open preview back, with what the engine keeps for the next one of its kind. Does
    /// nothing if no such preview is open.
    void forgetPreview();
    /// Ends an edit that stands open without a pen, as is usual for its kind (OpenManner): a growth
    /// is committed at its generation, a preview taken back. An open stroke is left alone. apply(),
    /// begin(), undo() and others do this themselves.
    void closeOpen();
    [[nodiscard]] bool transactionOpen() const;
    /// The edit that stands open, with its input so far; null: none.
    [[nodiscard]] const Edit* openEdit() const;
    template <isEdit E> [[nodiscard]] bool isOpen() const
    {
        const Edit* open = openEdit();
        return open && open->is<E>();
    }
    /// Whether what stands open is a preview, which any next action takes back.
    [[nodiscard]] bool openIsPreview() const;
    /// Whether it is a preview of an edit that was complete when it began, and of which the engine
    /// keeps nothing: the preview of another edit may take its place.
    [[nodiscard]] bool openIsReplaceable() const;
    /// Whether an edit stands open whose effect is included in the answers to questions asked from
    /// now on. An edit of a whole segment may still be computed (SegmentWork) or wait in line
    /// before that.
    [[nodiscard]] bool openHasBegun() const;
    /// Whether an edit stands open of which nothing will remain: the engine has refused it.
    [[nodiscard]] bool openIsRefused() const;

    Result<void> undo();
    Result<void> redo();
    Result<void> goTo(RowId row); ///< of the history; 0: the beginning

    /// Announces to the engine that edits with an editable range may follow, so that it can
    /// prepare.
    void expectEditableRanges();

    void poll(); ///< takes in finished results; call it after a wake-up
    [[nodiscard]] bool idle() const; ///< nothing is waiting or running, and no stroke is open
    Result<void> settle(); ///< blocks until every command is carried out and on disk
    /// To be called before the session is destroyed, while failures can still be reported: ends
    /// what stands open without a pen (closeOpen()), aborts long-running work as the destructor
    /// does, and settles. If the disk refuses the last steps, listeners are notified, and the
    /// session can be continued.
    Result<void> endWork();
    /// Does now what the destructor would do first. From here on neither listeners nor callers
    /// receive anything; SessionStorage::trouble() says whether the disk took the last steps.
    void endUnheard();
    /// hex, of a settled session; core/session/README.md defines it
    [[nodiscard]] QByteArray stateHash() const;

    // Parts, each documented in its own header; they live as long as the session.
    [[nodiscard]] VoxelQuestions& questions();
    [[nodiscard]] SessionChunks& chunks();
    [[nodiscard]] const StepFindings& findings() const;
    [[nodiscard]] SessionSurface& surface();
    [[nodiscard]] SegmentWork& segmentWork();
    [[nodiscard]] SessionDisplay& display();
    [[nodiscard]] SessionKeyframes& keyframes();
    [[nodiscard]] SessionStorage& storage();

    /// A listener must live as long as the session, or until it is replaced by an empty one.
    void setListener(std::function<void(const DocumentChange&)> listener);
    /// Called by poll() for failures that occur after the call that caused them has returned
    /// (engine, disk). settle() returns the first such failure since its last call.
    void setErrorListener(std::function<void(const Error&)> listener);
    /// @param origin called whenever a row is made. The default is presentOrigin() without a name.
    void setOrigin(std::function<RowOrigin()> origin);

private:
    struct Parts;
    explicit EditSession(std::unique_ptr<OperationQueue> queue);
    static Result<std::unique_ptr<EditSession>> continued(EditEngine& engine, LoadedVolume volume,
        std::unique_ptr<SessionFile> file, std::function<void()> wakeUp);
    [[nodiscard]] Result<void> mayEdit() const;

    std::unique_ptr<Parts> m_parts; ///< before the queue, whose last answers may use them
    std::unique_ptr<OperationQueue> m_queue;
    QString m_whyReadOnly;
    FileInUse m_sources;
};

} // namespace core
