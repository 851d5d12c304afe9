// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"

#include "core/edits/DocumentEdits.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/session/VoxelOperation.h"
#include "core/session/WalkOperation.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <thread>
#include <utility>

namespace core {

namespace {

/// The bricks that are not empty at a row: all differences on the way there, one over the other.
Result<std::vector<BrickImage>> bricksAt(SessionFile& file, const History& history, RowId row)
{
    std::map<BrickKey, BrickImage> bricks;
    for (const RowId id : history.pathTo(row)) {
        const Result<BrickDelta> delta = file.readDelta(id);
        if (!delta)
            return tl::unexpected(delta.error());
        Result<std::vector<BrickImage>> differences = expandDelta(*delta);
        if (!differences)
            return failure(ErrorCode::SessionDamaged, file.path(),
                QStringLiteral("row %1: %2").arg(id).arg(differences.error().arguments.value(0)));
        for (BrickImage& difference : *differences) {
            BrickImage& brick = bricks[difference.key];
            brick.key = difference.key;
            brick = exclusiveOr(brick, difference);
        }
    }
    std::vector<BrickImage> images;
    for (auto& [key, brick] : bricks) {
        if (!brick.bytes.empty())
            images.push_back(std::move(brick));
    }
    return images;
}

/// The farthest row on the way to @p row that has its second half, as all before it have.
RowId lastComplete(const History& history, RowId row)
{
    RowId complete = 0;
    for (const RowId id : history.pathTo(row)) {
        if (history.row(id).stateHash.isEmpty())
            break;
        complete = id;
    }
    return complete;
}

Result<void> fitsGrid(
    const std::vector<BrickImage>& images, const Volume& volume, const QString& path)
{
    const BrickGrid grid{volume.geometry.size};
    for (const BrickImage& image : images) {
        if (image.key.brick >= std::uint32_t(grid.brickCount()))
            return failure(ErrorCode::SessionDamaged, path,
                QStringLiteral("it names a brick that the volume does not have"));
    }
    return {};
}

/// A question to the engine in its place in line.
class Question final : public Operation {
public:
    explicit Question(std::function<void()> submit)
        : m_submit(std::move(submit))
    {
    }
    void start(SessionState&) override
    {
        m_submit();
        m_done = true;
    }
    [[nodiscard]] bool done() const override { return m_done; }

private:
    std::function<void()> m_submit;
    bool m_done = false;
};

} // namespace

class EditSession::Implementation {
public:
    Implementation(EditEngine& engine, Volume volume, std::function<void()> wakeUp)
        : m_state(engine, std::move(volume))
        , m_wakeUp(std::move(wakeUp))
    {
        if (m_wakeUp)
            engine.setWakeUp(m_wakeUp);
    }
    ~Implementation()
    {
        m_listener = {};
        m_errorListener = {};
        m_answers.clear();
        if (VoxelOperation* open = interactive())
            open->end(m_state, open->isGrowth() ? Ending::Commit : Ending::Rollback);
        static_cast<void>(settle());
        if (m_wakeUp)
            m_state.engine.setWakeUp({});
    }

    void keepIn(std::unique_ptr<SessionFile> file)
    {
        m_state.file = std::move(file);
        m_state.worker = std::make_unique<CommitWorker>(m_state.file.get(), m_wakeUp);
    }
    Result<void> restore();

    void submit(std::unique_ptr<Operation> operation)
    {
        m_queue.push_back(std::move(operation));
        advance();
        tellNews();
    }
    [[nodiscard]] std::optional<Document> foreseen() const;
    [[nodiscard]] Document foreseenAsFarAsKnown() const;
    Result<void> check(const Edit& edit) const;
    [[nodiscard]] VoxelOperation* interactive() const;
    void closeGrowth();
    void endStroke(VoxelOperation& stroke, Ending ending)
    {
        stroke.end(m_state, ending);
        advance();
        tellNews();
    }
    void ask(EngineCommand question, Answer answer);
    void poll();
    Result<void> settle();
    Result<std::vector<std::uint8_t>> labels(std::uint8_t plane);

    SessionState& state() { return m_state; }
    const SessionState& state() const { return m_state; }
    bool idle() const { return m_queue.empty(); }
    void setListener(std::function<void(const DocumentChange&)> listener)
    {
        m_listener = std::move(listener);
    }
    void setErrorListener(std::function<void(const Error&)> listener)
    {
        m_errorListener = std::move(listener);
    }
    void tellNews();

private:
    bool collect();
    void take(EngineResult&& result);
    void take(CommitWorker::Report&& report);
    void advance();
    [[nodiscard]] bool nothingAhead() const;
    [[nodiscard]] bool settled() const { return nothingAhead() && m_answers.empty(); }

    SessionState m_state;
    std::function<void()> m_wakeUp;
    std::function<void(const DocumentChange&)> m_listener;
    std::function<void(const Error&)> m_errorListener;
    std::deque<std::unique_ptr<Operation>> m_queue; ///< the first one is under way
    bool m_started = false; ///< the first one is
    bool m_advancing = false;
    bool m_polling = false;
    std::map<Ticket, Answer> m_answers;
};

/// Puts the voxels of the file's position on the engine; carries out rows without second half.
Result<void> EditSession::Implementation::restore()
{
    SessionFile& file = *m_state.file;
    const SessionContents& contents = file.contents();
    const Volume& volume = m_state.document.volumes.front();
    m_state.history = History::restored(contents.rows, contents.visited, contents.position);
    const RowId base = lastComplete(m_state.history, contents.position);
    Result<std::vector<BrickImage>> images = bricksAt(file, m_state.history, base);
    if (!images)
        return tl::unexpected(images.error());
    if (const Result<void> fits = fitsGrid(*images, volume, file.path()); !fits)
        return fits;
    if (!images->empty()) {
        m_state.engine.submit(SwapBricks{*images});
        m_state.engine.finish();
    }
    m_state.history.moveTo(base);
    m_state.hide(contents.hiddenSegments);
    m_state.begin(*std::move(images));
    if (base != 0
        && m_state.worker->stateHash(m_state.documentJson()) != m_state.history.row(base).stateHash)
        return failure(ErrorCode::SessionDamaged, file.path(),
            QStringLiteral("row %1: its voxels do not have its hash").arg(base));

    bool carriedOut = false;
    for (const HistoryRow& row : contents.rows) {
        if (!row.stateHash.isEmpty())
            continue;
        carriedOut = true;
        m_queue.push_back(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row.parent));
        if (changesDocumentOnly(row.edit))
            m_queue.push_back(std::make_unique<DocumentOperation>(row.edit, row.id));
        else
            m_queue.push_back(
                std::make_unique<VoxelOperation>(row.edit, VoxelOperation::Kind::Whole, row.id));
    }
    if (carriedOut || contents.position != base)
        m_queue.push_back(
            std::make_unique<WalkOperation>(WalkOperation::Aim::Row, contents.position));
    advance();
    return settle();
}

/// The document after what waits in line; none if that cannot be told.
std::optional<Document> EditSession::Implementation::foreseen() const
{
    Document expected = m_state.document;
    for (const std::unique_ptr<Operation>& operation : m_queue) {
        if (!operation->foresee(expected))
            return std::nullopt;
    }
    return expected;
}

Document EditSession::Implementation::foreseenAsFarAsKnown() const
{
    Document expected = m_state.document;
    for (const std::unique_ptr<Operation>& operation : m_queue)
        static_cast<void>(operation->foresee(expected));
    return expected;
}

/// Whether an edit can be carried out after what waits in line; what cannot be told is let through.
Result<void> EditSession::Implementation::check(const Edit& edit) const
{
    if (m_queue.empty())
        return checkAgainst(m_state.document, edit);
    const std::optional<Document> expected = foreseen();
    return expected ? checkAgainst(*expected, edit) : Result<void>();
}

VoxelOperation* EditSession::Implementation::interactive() const
{
    for (const std::unique_ptr<Operation>& operation : m_queue) {
        auto* stroke = dynamic_cast<VoxelOperation*>(operation.get());
        if (stroke && stroke->open())
            return stroke;
    }
    return nullptr;
}

void EditSession::Implementation::closeGrowth()
{
    VoxelOperation* open = interactive();
    if (!open || !open->isGrowth())
        return;
    open->extendGrowth(m_state, GrowPause{});
    open->end(m_state, Ending::Commit);
    advance();
}

void EditSession::Implementation::ask(EngineCommand question, Answer answer)
{
    auto submitQuestion = [this, question = std::move(question), answer = std::move(answer)] {
        m_answers.emplace(m_state.engine.submit(question), answer);
    };
    // Behind edits that have not reached the engine a question waits like they do.
    if (nothingAhead())
        return submitQuestion();
    m_queue.push_back(std::make_unique<Question>(std::move(submitQuestion)));
}

void EditSession::Implementation::poll()
{
    if (m_polling)
        return;
    m_polling = true;
    do
        advance();
    while (collect());
    m_polling = false;
    tellNews();
}

bool EditSession::Implementation::collect()
{
    std::vector<EngineResult> results = m_state.engine.collect();
    std::vector<CommitWorker::Report> reports = m_state.worker->collect();
    for (EngineResult& result : results) {
        take(std::move(result));
        advance();
    }
    for (CommitWorker::Report& report : reports)
        take(std::move(report));
    return !results.empty() || !reports.empty();
}

void EditSession::Implementation::take(EngineResult&& result)
{
    if (const auto asked = m_answers.find(result.ticket); asked != m_answers.end()) {
        const Answer answer = std::move(asked->second);
        m_answers.erase(asked);
        answer(result);
    } else if (m_started) {
        m_queue.front()->takeResult(m_state, std::move(result));
    }
}

void EditSession::Implementation::take(CommitWorker::Report&& report)
{
    if (report.differences) {
        if (m_started)
            m_queue.front()->takeDifferences(m_state, *std::move(report.differences));
        return;
    }
    HistoryRow& row = m_state.history.row(report.row);
    row.deltaBytes = report.deltaBytes;
    row.stateHash = std::move(report.stateHash);
    m_state.tell(DocumentChange::What::History);
}

void EditSession::Implementation::advance()
{
    if (m_advancing)
        return;
    m_advancing = true;
    while (!m_queue.empty()) {
        if (!m_started) {
            m_started = true;
            m_queue.front()->start(m_state);
        }
        if (!m_queue.front()->done())
            break;
        m_queue.pop_front();
        m_started = false;
    }
    m_advancing = false;
}

void EditSession::Implementation::tellNews()
{
    // Listeners may well ask for more, which makes more news.
    while (!m_state.news.empty() || !m_state.errors.empty()) {
        for (const DocumentChange& change : std::exchange(m_state.news, {})) {
            if (m_listener)
                m_listener(change);
        }
        for (const Error& error : std::exchange(m_state.errors, {})) {
            if (m_errorListener)
                m_errorListener(error);
        }
    }
}

bool EditSession::Implementation::nothingAhead() const
{
    if (m_queue.empty())
        return true;
    // A stroke under the pen is ended by whoever began it.
    const VoxelOperation* open = interactive();
    return open && open == m_queue.front().get();
}

Result<void> EditSession::Implementation::settle()
{
    closeGrowth();
    m_state.engine.finish();
    poll();
    while (!settled()) {
        m_state.engine.finish();
        m_state.worker->finish();
        poll();
        if (!settled())
            std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    m_state.worker->finish();
    poll();
    if (m_state.file) {
        if (const Result<void> flushed = m_state.file->flush(); !flushed && !m_state.firstError)
            m_state.fail(flushed.error());
    }
    tellNews();
    if (const std::optional<Error> error = std::exchange(m_state.firstError, std::nullopt))
        return tl::unexpected(*error);
    return {};
}

Result<std::vector<std::uint8_t>> EditSession::Implementation::labels(std::uint8_t plane)
{
    const glm::ivec3 size = m_state.document.volumes.front().geometry.size;
    const BrickGrid grid{size};
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    const auto place = [&](const BrickChange& brick) {
        const VoxelBox box = grid.boxOf(int(brick.key.brick));
        const int width = box.maximum.x - box.minimum.x;
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                const std::size_t from =
                    std::size_t(BrickGrid::offsetInBrick({box.minimum.x, y, z}));
                const std::size_t to = std::size_t(box.minimum.x)
                    + std::size_t(size.x) * (std::size_t(y) + std::size_t(size.y) * std::size_t(z));
                std::copy_n(&brick.after[from], width, &labels[to]);
            }
        }
    };
    // In portions, so that a large volume is not there twice.
    constexpr int portion = 1024;
    std::optional<Error> error;
    for (int first = 0; first < grid.brickCount(); first += portion) {
        ReadBricks read;
        for (int brick = first; brick < std::min(first + portion, grid.brickCount()); ++brick)
            read.keys.push_back({Field::Labels, plane, std::uint32_t(brick)});
        bool answered = false;
        ask(std::move(read), [&](const EngineResult& result) {
            answered = true;
            if (result.error)
                error = result.error;
            for (const BrickChange& brick : result.changes) {
                if (!brick.after.empty())
                    place(brick);
            }
        });
        while (!answered) {
            m_state.engine.finish();
            poll();
        }
    }
    if (error)
        return tl::unexpected(*error);
    return labels;
}

// --- EditSession ---------------------------------------------------------------------------------

EditSession::EditSession(std::unique_ptr<Implementation> implementation)
    : m_implementation(std::move(implementation))
{
}

EditSession::~EditSession() = default;

Result<std::unique_ptr<EditSession>> EditSession::create(
    EditEngine& engine, LoadedVolume volume, Options options)
{
    if (const Result<void> put = engine.openVolume(volume.volume.geometry.size, volume.codes); !put)
        return tl::unexpected(put.error());
    std::unique_ptr<SessionFile> file;
    if (!options.file.isEmpty()) {
        Result<std::unique_ptr<SessionFile>> created = SessionFile::create(
            options.file, SessionSource::of(volume.volume), options.replaceExisting);
        if (!created)
            return tl::unexpected(created.error());
        file = *std::move(created);
    }
    auto implementation = std::make_unique<Implementation>(
        engine, std::move(volume.volume), std::move(options.wakeUp));
    implementation->keepIn(std::move(file));
    return std::unique_ptr<EditSession>(new EditSession(std::move(implementation)));
}

Result<std::unique_ptr<EditSession>> EditSession::open(
    EditEngine& engine, LoadedVolume volume, const QString& file, std::function<void()> wakeUp)
{
    Result<std::unique_ptr<SessionFile>> opened =
        SessionFile::open(file, SessionFile::Access::ReadWrite);
    if (!opened)
        return tl::unexpected(opened.error());
    const QString difference = (*opened)->contents().source.differenceFrom(volume.volume);
    if (!difference.isEmpty())
        return failure(ErrorCode::SessionMismatch, file, difference);
    if (const Result<void> put = engine.openVolume(volume.volume.geometry.size, volume.codes); !put)
        return tl::unexpected(put.error());
    volume.codes = {};
    auto implementation =
        std::make_unique<Implementation>(engine, std::move(volume.volume), std::move(wakeUp));
    implementation->keepIn(*std::move(opened));
    if (const Result<void> restored = implementation->restore(); !restored)
        return tl::unexpected(restored.error());
    return std::unique_ptr<EditSession>(new EditSession(std::move(implementation)));
}

Document EditSession::foreseenDocument() const
{
    return m_implementation->foreseenAsFarAsKnown();
}

const Document& EditSession::document() const
{
    return m_implementation->state().document;
}

const History& EditSession::history() const
{
    return m_implementation->state().history;
}

EditEngine& EditSession::engine()
{
    return m_implementation->state().engine;
}

Result<void> EditSession::apply(const Edit& edit)
{
    if (const Result<void> checked = checkFields(edit); !checked)
        return checked;
    const Edit rounded = quantised(edit);
    m_implementation->closeGrowth();
    if (const Result<void> checked = m_implementation->check(rounded); !checked)
        return checked;
    if (changesDocumentOnly(rounded))
        m_implementation->submit(std::make_unique<DocumentOperation>(rounded));
    else
        m_implementation->submit(
            std::make_unique<VoxelOperation>(rounded, VoxelOperation::Kind::Whole));
    return {};
}

Result<void> EditSession::begin(const Edit& edit)
{
    if (const Result<void> checked = checkFieldsAtBegin(edit); !checked)
        return checked;
    const Edit rounded = quantised(edit);
    const bool isDrill = std::holds_alternative<DrillStroke>(rounded);
    if (!isDrill && !std::holds_alternative<GrowSteps>(rounded))
        return failure(ErrorCode::InvalidField, editName(rounded),
            QStringLiteral("it is carried out whole, there is nothing to begin"));
    m_implementation->closeGrowth();
    if (m_implementation->interactive())
        return failure(ErrorCode::InvalidField, editName(rounded),
            QStringLiteral("another stroke has not ended yet"));
    if (const Result<void> checked = m_implementation->check(rounded); !checked)
        return checked;
    m_implementation->submit(
        std::make_unique<VoxelOperation>(rounded, VoxelOperation::Kind::Interactive));
    return {};
}

void EditSession::extendDrill(const std::vector<PenSample>& samples)
{
    if (VoxelOperation* open = m_implementation->interactive())
        open->extendDrill(m_implementation->state(), quantised(samples));
}

void EditSession::extendGrowth(GrowAdvance advance)
{
    if (VoxelOperation* open = m_implementation->interactive())
        open->extendGrowth(m_implementation->state(), advance);
}

void EditSession::pauseGrowth()
{
    if (VoxelOperation* open = m_implementation->interactive())
        open->extendGrowth(m_implementation->state(), GrowPause{});
}

void EditSession::end(Ending ending)
{
    if (VoxelOperation* open = m_implementation->interactive())
        m_implementation->endStroke(*open, ending);
}

bool EditSession::transactionOpen() const
{
    return m_implementation->interactive() != nullptr;
}

Result<void> EditSession::undo()
{
    m_implementation->closeGrowth();
    if (m_implementation->idle() && !history().canUndo())
        return failure(ErrorCode::InvalidField, QStringLiteral("undo"),
            QStringLiteral("the history is at its beginning"));
    m_implementation->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Undo));
    return {};
}

Result<void> EditSession::redo()
{
    m_implementation->closeGrowth();
    if (m_implementation->idle() && !history().canRedo())
        return failure(ErrorCode::InvalidField, QStringLiteral("redo"),
            QStringLiteral("the history is at its end"));
    m_implementation->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Redo));
    return {};
}

Result<void> EditSession::goTo(RowId row)
{
    if (row < 0 || row > RowId(history().rows().size()))
        return failure(ErrorCode::InvalidField, QStringLiteral("row"),
            QStringLiteral("the history has no row %1").arg(row));
    m_implementation->closeGrowth();
    m_implementation->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row));
    return {};
}

void EditSession::ask(EngineCommand question, Answer answer)
{
    m_implementation->ask(std::move(question), std::move(answer));
}

void EditSession::poll()
{
    m_implementation->poll();
}

Result<void> EditSession::settle()
{
    return m_implementation->settle();
}

QByteArray EditSession::stateHash() const
{
    const SessionState& state = m_implementation->state();
    return state.worker->stateHash(state.documentJson());
}

Result<std::vector<std::uint8_t>> EditSession::labels(std::uint8_t plane)
{
    return m_implementation->labels(plane);
}

void EditSession::setSegmentVisible(int label, bool visible)
{
    m_implementation->state().setVisible(label, visible);
    m_implementation->tellNews();
}

void EditSession::setListener(std::function<void(const DocumentChange&)> listener)
{
    m_implementation->setListener(std::move(listener));
}

void EditSession::setErrorListener(std::function<void(const Error&)> listener)
{
    m_implementation->setErrorListener(std::move(listener));
}

} // namespace core
