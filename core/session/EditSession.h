// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FileInUse.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/sessionfile/records/SavedImages.h"

#include <QJsonObject>
#include <QString>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace core {

struct PenSample;

class ChunkMap;
class OperationQueue;
struct AuditReport;
class SessionFile;
struct Touch;

/// The controller (DESIGN §2): stroke → command → engine → history → session file.
///
/// Owns the document and the history of one open volume; the engine is lent. Nothing here waits for
/// the engine except settle(). One transaction is open at a time: apply(), undo(), redo() and
/// settle() first close a running growth burst at its generation; a stroke under the pen is ended
/// by whoever began it. All members belong to one thread.
class EditSession {
public:
    struct Options {
        QString file; ///< session file; empty: history in memory only
        /// Where the file cannot be made the session begins all the same, in memory (whyNoFile()).
        bool beginWithoutFile = false;
        /// Called on another thread whenever poll() has something to take in; the engine's wake-up
        /// is set to it.
        std::function<void()> wakeUp{};
    };

    /// Puts the volume on the engine and starts an empty history.
    /// Errors: FileExists, FileUnwritable, and the engine's.
    static Result<std::unique_ptr<EditSession>> create(
        EditEngine& engine, LoadedVolume volume, Options options);
    /// Continues a session file where it stopped; the volume is the one its references name.
    /// Rows whose delta did not reach the disk are executed again; if it is full still, they wait
    /// in memory (diskTrouble()). Errors: SessionDamaged, SessionMismatch (the volume is not the
    /// one the session was made on).
    static Result<std::unique_ptr<EditSession>> open(EditEngine& engine, LoadedVolume volume,
        const QString& file, std::function<void()> wakeUp = {});
    /// The same for looking only, without touching the file or its folder: it is open in another
    /// window, or cannot be written. Undo, redo and goTo() walk; edits are refused with
    /// SessionReadOnly and @p why, until saveAs().
    static Result<std::unique_ptr<EditSession>> view(EditEngine& engine, LoadedVolume volume,
        const QString& file, const QString& why, std::function<void()> wakeUp = {});
    /// Closes a running growth, waits for the disk and leaves one file.
    ~EditSession();

    [[nodiscard]] const Document& document() const;
    /// The document as it will be once the edits that wait for the engine are carried out (undo and
    /// redo that wait are not foreseen).
    [[nodiscard]] Document foreseenDocument() const;
    [[nodiscard]] const History& history() const;
    [[nodiscard]] EditEngine& engine();

    /// The session file; empty: history in memory only.
    [[nodiscard]] QString file() const;
    /// Why there is no file there (Options::beginWithoutFile): every step waits in memory until
    /// saveAs() gives it one. None: there is one, or none was asked for.
    [[nodiscard]] std::optional<Error> whyNoFile() const;
    /// The study's images are in the session file (SessionImages.h).
    [[nodiscard]] bool holdsImages() const;
    /// Why edits are refused; empty: they are not.
    [[nodiscard]] QString whyReadOnly() const;
    /// Goes on in a copy of the session file (SessionFile::saveAs()). Never waits; @p done is
    /// called on another thread, and may be called after the session is gone.
    void saveAs(const QString& target, bool replaceExisting,
        std::function<void(const Result<void>&)> done, SavedImages images = {});

    /// Gives the session file another name in the same folder, replacing a session that is there,
    /// and goes on there. Waits. On failure everything is as it was. Errors: FileUnwritable.
    Result<void> renameFile(const QString& target);

    /// A whole edit. Errors are told before anything changes. Its row follows once the engine is
    /// done.
    Result<void> apply(const Edit& edit);

    /// A stroke under the pen or a growth that runs: begin, then extend…, then end.
    /// DrillStroke or LaserStroke without samples; PaintStroke, BarrierStroke, BrushStroke or what
    /// has a SurfacePath, with the first point; PeelCut, GrowSteps, ResumeGrowth, ChangeInterval or
    /// ShrinkSteps; or GrowFromSeeds or ApplyTemplate, which shows what comes of it until end()
    /// decides.
    Result<void> begin(const Edit& edit);
    void extendDrill(const std::vector<PenSample>& samples);
    /// Of a PaintStroke, BarrierStroke or BrushStroke, or of what has a SurfacePath. @param lifted
    /// the path begins anew at the first of these (not of a surface's)
    void extendPath(const std::vector<glm::dvec3>& pointsLps, bool lifted = false);
    /// Of a PeelCut that was begun: deeper or less deep; out of range it stays as it is.
    void setPeelDepth(double depthMm);
    /// Of a ShrinkSteps that was begun: so many steps instead, more or less than before; as many as
    /// there are leave the accepted seeds.
    void setShrinkSteps(int steps);
    void extendGrowth(GrowAdvance advance);
    /// Of a ChangeInterval that was begun: it is as if it had been begun with these bounds, and
    /// extendGrowth() has to be told again. Bounds that cannot be are left alone.
    void setInterval(double lower, double upper);
    void pauseGrowth();
    void end(Ending ending);
    /// Takes a preview back, and with it what the engine would keep for the next one.
    void cancelPreview();
    [[nodiscard]] bool transactionOpen() const;
    /// What is open is a preview (GrowFromSeeds).
    [[nodiscard]] bool previewOpen() const;
    /// What is open is a template that is looked at (ApplyTemplate).
    [[nodiscard]] bool templateOpen() const;
    /// A growth that runs is committed at its generation, an open peel at its depth, a preview is
    /// taken back; a stroke is left alone. All that follows does it by itself.
    void closeGrowth();

    Result<void> undo();
    Result<void> redo();
    /// Walks to a row of the history (0: the beginning), undoing and redoing what lies between.
    Result<void> goTo(RowId row);

    /// The last step that stands and touched something (TouchSearch.h); 0: none. Answered by
    /// poll(), in order with the edits; dropped when the session closes.
    void findLastTouching(const Touch& touch, std::function<void(RowId)> answer);
    /// Later strokes that started on the surface that the last ReviseStroke changed: they stay
    /// where they are. Empty unless that edit is the position.
    [[nodiscard]] std::vector<RowId> strokesOnRevisedSurface() const;
    /// The chunks of what is divided (Document::chunks); null while they are worked out, which this
    /// begins, and where nothing is. DocumentChange::What::Chunks tells when they are there. Kept
    /// until another division is asked for.
    [[nodiscard]] std::shared_ptr<const ChunkMap> chunkMap();
    /// What the guard suspected of the growth that is the position; none of other steps, nor of a
    /// session that was opened.
    [[nodiscard]] std::optional<LeakAlarm> leakAlarm() const;
    /// What became of the places of the last SeedStroke that was carried out, whether it left a row
    /// or changed nothing; none since the session was opened: none.
    [[nodiscard]] const std::optional<SketchedSeeds>& sketchedSeeds() const;

    /// Ask the engine about voxels (ProbeVoxels or PickVoxels; read-only, no step of undo). The
    /// answer is given by poll(), in order with the edits; it is dropped when the session closes.
    using Answer = std::function<void(const EngineResult&)>;
    void ask(EngineCommand question, Answer answer);

    /// Take in what the engine has finished; call it when the engine wakes you.
    void poll();
    /// Nothing is under way or waits; a stroke under the pen or a growth that runs is under way.
    [[nodiscard]] bool idle() const;
    /// Wait until every command is carried out and on disk. The only member that waits.
    Result<void> settle();

    /// Why steps wait in memory instead of standing on disk (a full disk, say); none: they do not.
    /// A change is told as DocumentChange::What::Disk.
    [[nodiscard]] std::optional<Error> diskTrouble() const;
    /// Tries to write them now; every further step does so too. Never waits.
    void retryWriting();

    /// The incremental state hash (core/session/README.md), hex. Expects a settled session.
    [[nodiscard]] QByteArray stateHash() const;

    /// Labels of a plane, x fastest, as they are after settle(): for export and checks. Waits; who
    /// must not asks a LabelReader's questions.
    [[nodiscard]] Result<std::vector<std::uint8_t>> labels(std::uint8_t plane);
    /// A sculpt layer's coverage, likewise.
    [[nodiscard]] Result<std::vector<std::uint8_t>> coverage(std::uint8_t layer);

    /// How many bytes of memory the bricks of the steps that were used last may take, so that undo
    /// and redo over them need no disk; RecentSteps::usualBytes until it is set.
    void setStepMemory(std::size_t bytes);

    /// Asked whenever a row is made. Until it is set: presentOrigin(), without a name.
    void setOrigin(std::function<RowOrigin()> origin);

    /// A picture of what is seen at a row, as PNG; one per row, the last one stays. Kept in the
    /// session file, else nowhere. Never waits.
    void addKeyframe(RowId row, const QByteArray& png);
    /// Rows that have a picture, ascending.
    [[nodiscard]] std::vector<RowId> keyframes() const;
    /// Fetches the PNG of a row's picture (empty: it cannot be read). Never waits; @p take is
    /// called once, on another thread, before the session is gone.
    void fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take) const;

    /// The session's file read again and checked. Never waits; @p take is called once, on another
    /// thread, before the session is gone. A session without a file says so (InvalidField).
    void audit(std::function<void(const Result<AuditReport>&)> take) const;

    /// A copy of everything so far, without the study's images, in @p path, which must not exist;
    /// the session goes on where it is. Never waits; @p done is called once, on another thread,
    /// before the session is gone. Errors: those of saveAs().
    void copyTo(const QString& path, std::function<void(const Result<void>&)> done) const;

    /// The surface that is being refined; null: there is none, or something is under way. Until the
    /// next call that changes anything.
    [[nodiscard]] const SimplexMesh* surface() const;
    /// Told what is to be drawn anew of the surface: first, behind what waits, all that there is.
    /// Called on any thread, and must not wait for whoever draws. It lives as long as the session
    /// or until another one is told.
    void setSurfaceListener(std::function<void(SurfaceUpdate)> listener);

    /// Display state is no step of undo.
    void setSegmentVisible(int label, bool visible);
    /// How the window looked at it, kept for the next time it is opened: an object that means
    /// nothing here (ui/window/DisplayState). Empty: none was kept.
    [[nodiscard]] const QJsonObject& display() const;
    /// Goes to the file if it is another one; not for every movement of the mouse.
    void setDisplay(const QJsonObject& display);

    /// The listener lives as long as the session or until it is replaced by an empty one.
    void setListener(std::function<void(const DocumentChange&)> listener);
    /// Told by poll(): what failed after the call that asked for it had returned (engine, disk).
    /// settle() returns the first such failure since it was called last.
    void setErrorListener(std::function<void(const Error&)> listener);

private:
    explicit EditSession(std::unique_ptr<OperationQueue> queue);
    static Result<std::unique_ptr<EditSession>> continued(EditEngine& engine, LoadedVolume volume,
        std::unique_ptr<SessionFile> file, std::function<void()> wakeUp);
    [[nodiscard]] Result<void> mayEdit() const;

    std::unique_ptr<OperationQueue> m_queue;
    QString m_whyReadOnly;
    FileInUse m_sources;
};

} // namespace core
