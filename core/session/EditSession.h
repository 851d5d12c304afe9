// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FileInUse.h"
#include "core/delta/Ending.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/growth/GrowthProgress.h"
#include "core/history/History.h"

#include <QString>

#include <functional>
#include <memory>

namespace core {

struct PenSample;

class EditEngine;
class OperationQueue;
class SessionChunks;
class SessionDisplay;
class SessionFile;
class SessionKeyframes;
class SessionStorage;
class SessionSurface;
class StepFindings;
class VoxelQuestions;

/// The controller (DESIGN §2): stroke → command → engine → history → session file.
///
/// Owns the document and the history of one open volume; the engine is lent. One stroke is open at
/// a time; one under the pen is ended by whoever began it. Only settle() waits. All members, and
/// those of its parts, belong to one thread.
class EditSession {
public:
    struct Options {
        QString file; ///< session file; empty: history in memory only
        /// Where the file cannot be made the session begins in memory (SessionStorage).
        bool beginWithoutFile = false;
        std::function<void()> wakeUp{}; ///< on another thread, whenever poll() has something
    };

    /// An empty history on a volume. Errors: FileExists, FileUnwritable, and the engine's.
    static Result<std::unique_ptr<EditSession>> create(
        EditEngine& engine, LoadedVolume volume, Options options);
    /// Continues a session file where it stopped; the volume is the one its references name.
    /// Rows whose delta did not reach the disk are executed again; if it is full still, they wait
    /// in memory. Errors: SessionDamaged, SessionMismatch (it was made on another volume).
    static Result<std::unique_ptr<EditSession>> open(EditEngine& engine, LoadedVolume volume,
        const QString& file, std::function<void()> wakeUp = {});
    /// The same for looking only, without touching the file or its folder. Undo, redo and goTo()
    /// walk; edits are refused with SessionReadOnly and @p why, until SessionStorage::saveAs().
    static Result<std::unique_ptr<EditSession>> view(EditEngine& engine, LoadedVolume volume,
        const QString& file, const QString& why, std::function<void()> wakeUp = {});
    /// Closes a running growth, waits for the disk and leaves one file.
    ~EditSession();

    [[nodiscard]] const Document& document() const;
    /// As it will be once the edits that wait are carried out (undo and redo are not foreseen).
    [[nodiscard]] Document foreseenDocument() const;
    [[nodiscard]] const History& history() const;
    [[nodiscard]] GrowthProgress growthProgress() const;
    [[nodiscard]] QString file() const; ///< empty: history in memory only
    [[nodiscard]] QString whyReadOnly() const; ///< why edits are refused; empty: they are not

    /// A whole edit. Errors are told before anything changes; its row follows once it is done.
    Result<void> apply(const Edit& edit);

    /// What is told while it is under way (canStandOpen() in core/edits/EditTask.h): begin, then
    /// extend…, then end. A stroke begins without drill samples and with the first point of its
    /// path. What the open one has no use for, or what is out of range, is left alone.
    Result<void> begin(const Edit& edit);
    void extendDrill(const std::vector<PenSample>& samples);
    /// @param lifted the path begins anew at the first of these (not of a surface's)
    void extendPath(const std::vector<glm::dvec3>& pointsLps, bool lifted = false);
    void setPeelDepth(double depthMm);
    void setShrinkSteps(int steps); ///< instead of those before; more than there are: to the seeds
    void extendGrowth(GrowAdvance advance);
    void setInterval(double lower, double upper); ///< as if begun so; extendGrowth() anew
    void pauseGrowth();
    void end(Ending ending);
    void cancelPreview(); ///< and what the engine would keep for the next one
    [[nodiscard]] bool transactionOpen() const;
    [[nodiscard]] bool previewOpen() const; ///< a GrowFromSeeds is
    [[nodiscard]] bool templateOpen() const; ///< an ApplyTemplate that is looked at is
    /// A growth that runs is committed at its generation, an open peel at its depth, a preview is
    /// taken back; a stroke is left alone. apply(), begin(), undo() and so on do it by themselves.
    void closeGrowth();

    Result<void> undo();
    Result<void> redo();
    Result<void> goTo(RowId row); ///< of the history; 0: the beginning

    void poll(); ///< takes in what the engine has finished; call it when that wakes you
    [[nodiscard]] bool idle() const; ///< nothing waits or is under way, no stroke either
    Result<void> settle(); ///< waits until every command is carried out and on disk
    [[nodiscard]] QByteArray stateHash() const; ///< README.md; hex, of a settled session

    // Parts, each told of in its own header; they live as long as the session.
    [[nodiscard]] VoxelQuestions& questions();
    [[nodiscard]] SessionChunks& chunks();
    [[nodiscard]] const StepFindings& findings() const;
    [[nodiscard]] SessionSurface& surface();
    [[nodiscard]] SessionDisplay& display();
    [[nodiscard]] SessionKeyframes& keyframes();
    [[nodiscard]] SessionStorage& storage();

    /// Listeners live as long as the session or until they are replaced by empty ones.
    void setListener(std::function<void(const DocumentChange&)> listener);
    /// Told by poll(): what failed after the call that asked for it had returned (engine, disk).
    /// settle() returns the first such failure since it was called last.
    void setErrorListener(std::function<void(const Error&)> listener);
    /// Asked whenever a row is made. Until it is set: presentOrigin(), without a name.
    void setOrigin(std::function<RowOrigin()> origin);

private:
    struct Parts;
    explicit EditSession(std::unique_ptr<OperationQueue> queue);
    static Result<std::unique_ptr<EditSession>> continued(EditEngine& engine, LoadedVolume volume,
        std::unique_ptr<SessionFile> file, std::function<void()> wakeUp);
    [[nodiscard]] Result<void> mayEdit() const;

    std::unique_ptr<Parts> m_parts; ///< before the queue, whose last answers may ask them
    std::unique_ptr<OperationQueue> m_queue;
    QString m_whyReadOnly;
    FileInUse m_sources;
};

} // namespace core
