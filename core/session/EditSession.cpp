// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"

#include "core/base/Guarded.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/edits/kinds/sculpt/PenSample.h"
#include "core/edits/schema/EditQuantise.h"
#include "core/edits/schema/SchemaParts.h"
#include "core/session/operations/EditOperation.h"
#include "core/session/operations/OperationQueue.h"
#include "core/session/operations/ReadLabels.h"
#include "core/session/operations/SurfaceOperation.h"
#include "core/session/operations/WalkOperation.h"
#include "core/session/questions/TouchSearch.h"
#include "core/sessionfile/AuditReport.h"

#include <utility>

namespace core {

EditSession::EditSession(std::unique_ptr<OperationQueue> queue)
    : m_queue(std::move(queue))
{
}

EditSession::~EditSession() = default;

Document EditSession::foreseenDocument() const
{
    return m_queue->foreseen();
}

const Document& EditSession::document() const
{
    return m_queue->state().document;
}

const History& EditSession::history() const
{
    return m_queue->state().history;
}

EditEngine& EditSession::engine()
{
    return m_queue->state().engine;
}

QString EditSession::file() const
{
    const SessionState& state = m_queue->state();
    return state.file ? state.file->path() : QString();
}

std::optional<Error> EditSession::whyNoFile() const
{
    const SessionState& state = m_queue->state();
    return state.file ? state.file->whyNoFile() : std::nullopt;
}

bool EditSession::holdsImages() const
{
    const SessionState& state = m_queue->state();
    return state.file && state.file->holdsImages();
}

QString EditSession::whyReadOnly() const
{
    const SessionState& state = m_queue->state();
    return state.file && state.file->isPrivateCopy() ? m_whyReadOnly : QString();
}

Result<void> EditSession::mayEdit() const
{
    const QString why = whyReadOnly();
    if (why.isEmpty())
        return {};
    return failure(ErrorCode::SessionReadOnly, file(), why);
}

Result<void> EditSession::renameFile(const QString& target)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> settled = m_queue->settle(); !settled)
            return settled;
        SessionFile* file = m_queue->state().file.get();
        return file
            ? file->rename(target)
            : failure(ErrorCode::FileUnwritable, target, QStringLiteral("there is no file"));
    });
}

void EditSession::saveAs(const QString& target, bool replaceExisting,
    std::function<void(const Result<void>&)> done, SavedImages images)
{
    m_queue->closeGrowth();
    if (SessionFile* file = m_queue->state().file.get())
        file->saveAs(target, replaceExisting, std::move(done), std::move(images));
    else
        done(failure(ErrorCode::FileUnwritable, target,
            QStringLiteral("this session is kept in memory only")));
}

Result<void> EditSession::apply(const Edit& edit)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> may = mayEdit(); !may)
            return may;
        if (const Result<void> checked = checkFields(edit); !checked)
            return checked;
        const Edit rounded = quantised(edit);
        m_queue->closeGrowth();
        if (const Result<void> checked = m_queue->check(rounded); !checked)
            return checked;
        m_queue->submit(operationOf(rounded));
        return {};
    });
}

Result<void> EditSession::begin(const Edit& edit)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> may = mayEdit(); !may)
            return may;
        if (const Result<void> checked = checkFieldsAtBegin(edit); !checked)
            return checked;
        const Edit rounded = quantised(edit);
        if (!canStandOpen(rounded))
            return failure(ErrorCode::InvalidField, editName(rounded),
                QStringLiteral("it is carried out whole, there is nothing to begin"));
        m_queue->closeGrowth();
        if (m_queue->interactive())
            return failure(ErrorCode::InvalidField, editName(rounded),
                QStringLiteral("another stroke has not ended yet"));
        if (const Result<void> checked = m_queue->check(rounded); !checked)
            return checked;
        if (taskOf(rounded) == EditTask::Surface)
            m_queue->submit(
                std::make_unique<SurfaceOperation>(rounded, SurfaceOperation::Kind::Interactive));
        else
            m_queue->submit(
                std::make_unique<VoxelOperation>(rounded, VoxelOperation::Kind::Interactive));
        return {};
    });
}

void EditSession::extendDrill(const std::vector<PenSample>& samples)
{
    if (VoxelOperation* open = m_queue->interactiveVoxels())
        m_queue->guard([&] { open->extendDrill(m_queue->state(), quantised(samples)); });
}

void EditSession::extendPath(const std::vector<glm::dvec3>& pointsLps, bool lifted)
{
    if (OpenOperation* open = m_queue->interactive())
        m_queue->guard([&] { open->extendPath(m_queue->state(), quantised(pointsLps), lifted); });
}

void EditSession::setPeelDepth(double depthMm)
{
    const editFields::Number& field = editSchema::peelDepth;
    if (VoxelOperation* open = m_queue->interactiveVoxels(); open && field.check(depthMm).isEmpty())
        m_queue->guard([&] { open->setPeelDepth(m_queue->state(), field.rounded(depthMm)); });
}

void EditSession::setShrinkSteps(int steps)
{
    if (VoxelOperation* open = m_queue->interactiveVoxels(); open && steps >= 0)
        m_queue->guard([&] { open->setShrinkSteps(m_queue->state(), steps); });
}

void EditSession::extendGrowth(GrowAdvance advance)
{
    if (VoxelOperation* open = m_queue->interactiveVoxels())
        m_queue->guard([&] { open->extendGrowth(m_queue->state(), advance); });
}

void EditSession::setInterval(double lower, double upper)
{
    const editFields::Number& field = editSchema::modalityValue;
    VoxelOperation* open = m_queue->interactiveVoxels();
    if (open && lower <= upper && field.check(lower).isEmpty() && field.check(upper).isEmpty())
        m_queue->guard([&] {
            open->setInterval(m_queue->state(), field.rounded(lower), field.rounded(upper));
        });
}

void EditSession::pauseGrowth()
{
    if (VoxelOperation* open = m_queue->interactiveVoxels())
        m_queue->guard([&] { open->extendGrowth(m_queue->state(), GrowPause{}); });
}

void EditSession::end(Ending ending)
{
    if (OpenOperation* open = m_queue->interactive())
        m_queue->end(*open, ending);
}

void EditSession::cancelPreview()
{
    VoxelOperation* open = m_queue->interactiveVoxels();
    if (!open || !open->isPreview())
        return;
    m_queue->guard([&] { open->forgetPreview(m_queue->state()); });
    m_queue->end(*open, Ending::Rollback);
}

bool EditSession::transactionOpen() const
{
    return m_queue->interactive() != nullptr;
}

bool EditSession::templateOpen() const
{
    const auto* open = dynamic_cast<const SurfaceOperation*>(m_queue->interactive());
    return open && open->isTemplate();
}

bool EditSession::previewOpen() const
{
    const VoxelOperation* open = m_queue->interactiveVoxels();
    return open && open->isPreview();
}

void EditSession::closeGrowth()
{
    m_queue->closeGrowth();
}

Result<void> EditSession::undo()
{
    return guarded([&]() -> Result<void> {
        m_queue->closeGrowth();
        if (m_queue->idle() && !history().canUndo())
            return failure(ErrorCode::InvalidField, QStringLiteral("undo"),
                QStringLiteral("the history is at its beginning"));
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Undo));
        return {};
    });
}

Result<void> EditSession::redo()
{
    return guarded([&]() -> Result<void> {
        m_queue->closeGrowth();
        if (m_queue->idle() && !history().canRedo())
            return failure(ErrorCode::InvalidField, QStringLiteral("redo"),
                QStringLiteral("the history is at its end"));
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Redo));
        return {};
    });
}

Result<void> EditSession::goTo(RowId row)
{
    return guarded([&]() -> Result<void> {
        if (row < 0 || row > RowId(history().rows().size()))
            return failure(ErrorCode::InvalidField, QStringLiteral("goTo"),
                QStringLiteral("the history has no row %1").arg(row));
        m_queue->closeGrowth();
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row));
        return {};
    });
}

void EditSession::findLastTouching(const Touch& touch, std::function<void(RowId)> answer)
{
    m_queue->closeGrowth();
    m_queue->submit(std::make_unique<TouchSearch>(touch, std::move(answer)));
}

std::vector<RowId> EditSession::strokesOnRevisedSurface() const
{
    const SessionState::Revision& revision = m_queue->state().lastRevision;
    return revision.row == history().position() ? revision.begunInside : std::vector<RowId>();
}

std::shared_ptr<const ChunkMap> EditSession::chunkMap()
{
    SessionState& state = m_queue->state();
    state.wantChunks();
    return state.chunks->map(state.divisionRow());
}

std::optional<LeakAlarm> EditSession::leakAlarm() const
{
    const std::optional<SessionState::Alarm>& alarm = m_queue->state().lastAlarm;
    return alarm && alarm->row == history().position() ? std::optional(alarm->found) : std::nullopt;
}

const std::optional<SketchedSeeds>& EditSession::sketchedSeeds() const
{
    return m_queue->state().lastSketched;
}

void EditSession::ask(EngineCommand question, Answer answer)
{
    m_queue->ask(std::move(question), std::move(answer));
}

void EditSession::poll()
{
    m_queue->poll();
}

bool EditSession::idle() const
{
    return m_queue->idle();
}

Result<void> EditSession::settle()
{
    return m_queue->settle();
}

std::optional<Error> EditSession::diskTrouble() const
{
    const SessionState& state = m_queue->state();
    return state.file ? state.file->trouble() : std::nullopt;
}

void EditSession::retryWriting()
{
    if (SessionFile* file = m_queue->state().file.get())
        file->retry();
}

QByteArray EditSession::stateHash() const
{
    const SessionState& state = m_queue->state();
    return state.worker->stateHash(state.documentJson());
}

Result<std::vector<std::uint8_t>> EditSession::labels(std::uint8_t plane)
{
    return guarded([&] { return readLabels(*m_queue, plane); });
}

Result<std::vector<std::uint8_t>> EditSession::coverage(std::uint8_t layer)
{
    return guarded([&] { return readLabels(*m_queue, layer, Field::Coverage); });
}

void EditSession::setStepMemory(std::size_t bytes)
{
    m_queue->state().recent.setMostBytes(bytes);
}

void EditSession::setOrigin(std::function<RowOrigin()> origin)
{
    m_queue->state().origin = std::move(origin);
}

void EditSession::addKeyframe(RowId row, const QByteArray& png)
{
    SessionState& state = m_queue->state();
    if (!state.file)
        return;
    state.keyframes.insert(row);
    state.file->addKeyframe({.row = row, .at = state.origin().at, .png = png});
}

std::vector<RowId> EditSession::keyframes() const
{
    const std::set<RowId>& rows = m_queue->state().keyframes;
    return {rows.begin(), rows.end()};
}

void EditSession::fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take) const
{
    if (const auto& file = m_queue->state().file)
        file->fetchKeyframe(row, std::move(take));
    else
        take({});
}

void EditSession::audit(std::function<void(const Result<AuditReport>&)> take) const
{
    if (const auto& file = m_queue->state().file)
        file->audit(std::move(take));
    else
        take(failure(ErrorCode::InvalidField, QStringLiteral("session"),
            QStringLiteral("it is kept in no file")));
}

void EditSession::copyTo(const QString& path, std::function<void(const Result<void>&)> done) const
{
    if (const auto& file = m_queue->state().file)
        file->copyTo(path, std::move(done));
    else
        done(failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("this session is kept in memory only")));
}

void EditSession::setSegmentVisible(int label, bool visible)
{
    m_queue->state().setVisible(label, visible);
    m_queue->tellNews();
}

const QJsonObject& EditSession::display() const
{
    return m_queue->state().display;
}

void EditSession::setDisplay(const QJsonObject& display)
{
    m_queue->state().setDisplay(display);
}

void EditSession::setSurfaceListener(std::function<void(SurfaceUpdate)> listener)
{
    m_queue->submit(std::make_unique<ShowSurface>(std::move(listener)));
}

const SimplexMesh* EditSession::surface() const
{
    const SessionState& state = m_queue->state();
    return m_queue->idle() && state.document.surface ? &state.surface.mesh : nullptr;
}

void EditSession::setListener(std::function<void(const DocumentChange&)> listener)
{
    m_queue->setListener(std::move(listener));
}

void EditSession::setErrorListener(std::function<void(const Error&)> listener)
{
    m_queue->setErrorListener(std::move(listener));
}

} // namespace core
