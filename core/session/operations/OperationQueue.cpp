// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/OperationQueue.h"

#include "core/base/Guarded.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineCommands.h"
#include "core/session/operations/SurfaceOperation.h"

#include <utility>

namespace core {

namespace {

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
    [[nodiscard]] bool foreseePosition(const History&, ForeseenPosition&) const override
    {
        return true;
    }

private:
    std::function<void()> m_submit;
    bool m_done = false;
};

} // namespace

OperationQueue::OperationQueue(EditEngine& engine, Volume volume, std::unique_ptr<SessionFile> file,
    std::function<void()> wakeUp)
    : m_state(engine, std::move(volume))
    , m_wakeUp(std::move(wakeUp))
{
    m_state.file = std::move(file);
    m_state.worker = std::make_unique<CommitWorker>(
        BrickGrid{m_state.document.volumes.front().geometry.size}, m_state.file.get(), m_wakeUp);
    m_state.side = std::make_unique<SideThread>(m_wakeUp);
    m_state.chunks =
        std::make_unique<ChunkWorker>(engine, m_state.document.volumes.front().geometry, m_wakeUp);
    if (m_wakeUp)
        engine.setWakeUp(m_wakeUp);
    if (m_state.file && m_wakeUp)
        m_state.file->setTroubleListener(m_wakeUp);
}

OperationQueue::~OperationQueue()
{
    endUnheard();
    if (m_wakeUp)
        m_state.engine.setWakeUp({});
}

void OperationQueue::endUnheard()
{
    m_listener = {};
    m_errorListener = {};
    m_answers.clear();
    m_closing = true;
    guard([this] {
        if (OpenOperation* open = interactive())
            open->end(m_state, open->manner().usualEnding);
    });
    abortLongWork();
    static_cast<void>(settle());
}

/// A smoothing with a large ball may have minutes to go, and nobody could abort it any more.
void OperationQueue::abortLongWork()
{
    for (const std::unique_ptr<Operation>& operation : m_operations) {
        auto* work = dynamic_cast<AbortableWork*>(operation.get());
        if (work && !work->isAwaitedAtEnd())
            work->abort(m_state);
    }
}

Result<void> OperationQueue::endWork()
{
    closeOpen();
    m_ending = true;
    guard([this] { abortLongWork(); });
    const Result<void> settled = settle();
    m_ending = false;
    return settled;
}

void OperationQueue::submit(std::unique_ptr<Operation> operation)
{
    if (m_state.lost()) {
        m_state.fail(*m_state.lost());
        return notifyListeners();
    }
    m_operations.push_back(std::move(operation));
    guard([this] { advance(); });
    notifyListeners();
}

void OperationQueue::ask(EngineCommand question, Answer answer)
{
    auto submitQuestion = [this, question = std::move(question), answer = std::move(answer)] {
        const Result<void> asked =
            guarded([&] { m_answers.emplace(m_state.engine.submit(question), answer); });
        if (asked)
            return;
        m_state.answers.push_back(
            [answer, error = asked.error()] { answer(EngineResult{.error = error}); });
        if (m_wakeUp)
            m_wakeUp();
    };
    // Behind edits that have not reached the engine a question waits like they do.
    if (nothingAhead())
        return submitQuestion();
    m_operations.push_back(std::make_unique<Question>(std::move(submitQuestion)));
}

OpenOperation* OperationQueue::interactive() const
{
    for (const std::unique_ptr<Operation>& operation : m_operations) {
        auto* stroke = dynamic_cast<OpenOperation*>(operation.get());
        if (stroke && stroke->open())
            return stroke;
    }
    return nullptr;
}

SurfaceOperation* OperationQueue::runningSurface() const
{
    return m_started && !m_operations.empty()
        ? dynamic_cast<SurfaceOperation*>(m_operations.front().get())
        : nullptr;
}

AbortableWork* OperationQueue::runningAbortable() const
{
    return m_started && !m_operations.empty()
        ? dynamic_cast<AbortableWork*>(m_operations.front().get())
        : nullptr;
}

void OperationQueue::end(OpenOperation& stroke, Ending ending)
{
    guard([&] {
        stroke.end(m_state, ending);
        advance();
    });
    notifyListeners();
}

void OperationQueue::closeOpen()
{
    OpenOperation* open = interactive();
    if (!open || !open->manner().withoutPen)
        return;
    guard([&] {
        open->extend(m_state, PauseGrowth{}); // a growth stops where it is
        open->end(m_state, open->manner().usualEnding);
        advance();
    });
}

void OperationQueue::guard(const std::function<void()>& work)
{
    if (const Result<void> done = guarded(work); !done)
        takeBack(done.error());
}

void OperationQueue::takeBack(const Error& error)
{
    m_advancing = false;
    if (m_state.lost())
        return;
    bool taken = false;
    if (m_started && !m_operations.empty()) {
        const Result<void> tried =
            guarded([&] { taken = m_operations.front()->abandon(m_state, error); });
        taken = taken && tried;
    }
    if (!taken)
        m_state.lose(error);
    guard([this] { advance(); });
}

void OperationQueue::poll()
{
    if (m_polling)
        return;
    m_polling = true;
    do
        guard([this] { advance(); });
    while (collect());
    m_polling = false;
    noticeTrouble();
    notifyListeners();
}

void OperationQueue::waitForEngine()
{
    m_state.engine.finish();
    poll();
}

/// Told once when writing begins to fail; settle() tells whoever waits for the disk each time.
void OperationQueue::noticeTrouble()
{
    if (const std::optional<Error> moved = m_state.file ? m_state.file->takeMove() : std::nullopt) {
        m_state.errors.push_back(*moved);
        m_state.notify(DocumentChange::What::Disk);
    }
    const std::optional<Error> trouble = m_state.file ? m_state.file->trouble() : std::nullopt;
    if (trouble.has_value() == m_troubled)
        return;
    m_troubled = trouble.has_value();
    // Who began without a file was told so.
    if (trouble && !m_state.file->whyNoFile())
        m_state.errors.push_back({ErrorCode::SessionUnwritten, trouble->arguments});
    m_state.notify(DocumentChange::What::Disk);
}

bool OperationQueue::collect()
{
    std::vector<EngineResult> results = m_state.engine.collect();
    std::vector<CommitWorker::Report> reports = m_state.worker->collect();
    for (EngineResult& result : results) {
        guard([&] {
            take(std::move(result));
            advance();
        });
    }
    for (CommitWorker::Report& report : reports)
        guard([&] { take(std::move(report)); });
    const std::vector<SideThread::Sequel> sequels = m_state.side->collect();
    for (const SideThread::Sequel& sequel : sequels) {
        if (m_state.lost())
            break; // what they belong to is gone
        guard([&] {
            sequel(m_state);
            advance();
        });
    }
    const bool haveChunks = m_state.chunks->collect();
    if (haveChunks)
        guard([this] { takeChunks(); });
    return !results.empty() || !reports.empty() || !sequels.empty() || haveChunks;
}

void OperationQueue::takeChunks()
{
    m_state.notify(DocumentChange::What::Chunks);
    if (m_started)
        m_operations.front()->takeChunks(m_state);
    // Nobody waited for them, or nobody of the session's.
    if (const std::optional<Error> why = m_state.chunks->takeUnreported())
        m_state.fail(*why);
}

void OperationQueue::take(EngineResult&& result)
{
    if (m_state.noteResult(result) || result.ticket == 0)
        return; // 0: told by the engine, asked by nobody
    if (const auto asked = m_answers.find(result.ticket); asked != m_answers.end()) {
        const Answer answer = std::move(asked->second);
        m_answers.erase(asked);
        if (m_closing)
            return;
        const Ticket ticket = result.ticket;
        // Whoever asked hears of it, too, where it is his own answer that cannot be taken in.
        if (const Result<void> taken = guarded([&] { answer(std::move(result)); }); !taken)
            answer({.ticket = ticket, .error = taken.error()});
    } else if (!m_state.chunks->take(result) && m_started) {
        m_operations.front()->takeResult(m_state, std::move(result));
    }
}

void OperationQueue::take(CommitWorker::Report&& report)
{
    if (report.error)
        return m_state.lose(*report.error);
    if (report.differences) {
        if (m_started && m_operations.front()->awaitedRow() == report.row)
            m_operations.front()->takeDifferences(m_state, *std::move(report.differences));
        return;
    }
    HistoryRow& row = m_state.history.row(report.row);
    row.deltaBytes = report.deltaBytes;
    row.stateHash = std::move(report.stateHash);
    m_state.notify(DocumentChange::What::History);
}

void OperationQueue::advance()
{
    if (m_advancing)
        return;
    m_advancing = true;
    if (m_state.lost()) {
        m_operations.clear();
        m_started = false;
    }
    while (!m_operations.empty()) {
        if (!m_started && m_state.owes())
            break;
        if (!m_started) {
            m_started = true;
            m_operations.front()->start(m_state);
        }
        if (!m_operations.front()->done())
            break;
        m_operations.pop_front();
        m_started = false;
    }
    askBehindOpen();
    m_advancing = false;
}

bool OperationQueue::nothingAhead() const
{
    if (m_operations.empty())
        return true;
    // A stroke under the pen is ended by whoever began it.
    const OpenOperation* open = interactive();
    return open && m_started && open == m_operations.front().get();
}

/// What was asked while an edit that stands open was still waiting in line is asked as soon as the
/// engine has that edit; behind it, it would wait until the edit is ended.
void OperationQueue::askBehindOpen()
{
    while (m_operations.size() > 1 && m_started && m_operations.front().get() == interactive()
        && dynamic_cast<Question*>(m_operations[1].get())) {
        m_operations[1]->start(m_state);
        m_operations.erase(m_operations.begin() + 1);
    }
}

Result<void> OperationQueue::settle()
{
    return guarded([this] { return waitUntilSettled(); });
}

Result<void> OperationQueue::waitUntilSettled()
{
    closeOpen();
    m_state.engine.finish();
    poll();
    while (!settled()) {
        m_state.engine.finish();
        m_state.side->finish();
        if (m_started && !m_operations.empty() && m_operations.front()->awaitsChunks())
            m_state.chunks->finish();
        m_state.worker->finish();
        poll();
    }
    m_state.worker->finish();
    m_state.chunks->finishPreparing();
    poll();
    m_state.engine.finish(); // also what nobody waits for: layers that were muted on the way
    poll();
    Result<void> onDisk;
    if (m_state.file)
        onDisk = m_state.file->flush();
    noticeTrouble();
    notifyListeners();
    if (const std::optional<Error> error = std::exchange(m_state.firstError, std::nullopt))
        return tl::unexpected(*error);
    return onDisk;
}

void OperationQueue::finishWriting()
{
    // noticeTrouble() tells whatever fails here.
    if (m_state.file)
        static_cast<void>(guarded([this] { return m_state.file->flush(); }));
    noticeTrouble();
    notifyListeners();
}

Result<void> OperationQueue::check(const Edit& edit) const
{
    if (idle())
        return checkAgainst(m_state.document, edit);
    Document expected = m_state.document;
    for (const std::unique_ptr<Operation>& operation : m_operations) {
        if (!operation->foresee(expected))
            return {};
    }
    return checkAgainst(expected, edit);
}

Document OperationQueue::foreseen() const
{
    Document expected = m_state.document;
    for (const std::unique_ptr<Operation>& operation : m_operations)
        static_cast<void>(operation->foresee(expected));
    return expected;
}

std::optional<RowId> OperationQueue::foreseenPosition() const
{
    ForeseenPosition position{.row = m_state.history.position()};
    for (const std::unique_ptr<Operation>& operation : m_operations) {
        // Whatever is done next takes it back.
        const auto* open = dynamic_cast<const OpenOperation*>(operation.get());
        const bool isPreview = open && open->open() && open->manner().withoutPen
            && open->manner().usualEnding == Ending::Rollback;
        if (!isPreview && !operation->foreseePosition(m_state.history, position))
            return std::nullopt;
    }
    return position.row;
}

void OperationQueue::setListener(std::function<void(const DocumentChange&)> listener)
{
    m_listener = std::move(listener);
}

void OperationQueue::setErrorListener(std::function<void(const Error&)> listener)
{
    m_errorListener = std::move(listener);
}

void OperationQueue::notifyListeners()
{
    // Listeners may well ask for more, which makes more news.
    while (!m_state.news.empty() || !m_state.errors.empty() || !m_state.answers.empty()) {
        for (const DocumentChange& change : std::exchange(m_state.news, {})) {
            if (m_listener)
                m_listener(change);
        }
        for (const Error& error : std::exchange(m_state.errors, {})) {
            // Nobody asked for what a session that ends aborts.
            if (m_errorListener && !(m_ending && error.code == ErrorCode::Cancelled))
                m_errorListener(error);
        }
        for (const std::function<void()>& answer : std::exchange(m_state.answers, {})) {
            // Whoever cannot take his answer in keeps the others from none of theirs.
            if (m_closing)
                continue;
            if (const Result<void> taken = guarded(answer); !taken)
                m_state.errors.push_back(taken.error());
        }
    }
}

} // namespace core
