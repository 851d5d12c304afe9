// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEditEngine.h"

#include "gpu/fields/BrickImages.h"
#include "gpu/gl/GlFailure.h"

#include "core/base/Log.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

namespace gpu {

namespace {

/// A look that finds nothing to do is not worth a line of a trace.
constexpr std::chrono::microseconds leastIdleWork{100};

} // namespace

GpuEditEngine::GpuEditEngine(const EditContext& context)
    : CommandQueue(context.thread)
    , m_thread(context.thread)
    , m_textures(context.textures)
    , m_work(context.work)
    , m_programs(context.shaders, context.work)
    , m_fieldPrograms(context.shaders)
    , m_idleWork(m_programs, m_fieldPrograms)
    , m_picks(context.shaders)
    , m_cutPreviewer(context.textures)
    , m_growthMarks(context.textures)
{
}

GpuEditEngine::~GpuEditEngine() = default;

double GpuEditEngine::millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

core::Result<void> GpuEditEngine::openVolume(
    const glm::ivec3& size, std::span<const std::uint16_t> codes)
{
    return open(size, codes.size(), [&] { return m_textures.open(size, codes); });
}

core::Result<void> GpuEditEngine::takeVolume(
    const glm::ivec3& size, std::vector<std::uint16_t> codes)
{
    return open(size, codes.size(), [&] { return m_textures.take(size, std::move(codes)); });
}

core::Result<void> GpuEditEngine::open(
    const glm::ivec3& size, std::size_t codes, const std::function<core::Result<void>()>& fill)
{
    const bool voxels = size.x > 0 && size.y > 0 && size.z > 0;
    if (!voxels || codes != std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
        return core::failure(core::ErrorCode::InvalidGeometry, QStringLiteral("volume"),
            core::Clause::saying("its size and the number of its codes do not agree"));
    finish();
    m_expectsRanges = false;
    core::Result<void> opened;
    m_thread.run([&] {
        if (contextLost()) {
            opened = tl::unexpected(*m_lost);
            return;
        }
        const core::TraceSpan span("engine", "open volume");
        close();
        m_lost.reset();
        try {
            opened = fill();
            if (!opened)
                return;
            m_fields = std::make_unique<VoxelFields>(m_fieldPrograms, m_textures, m_work);
            m_fields->setShownLabels(m_shownLabels, m_translucentLabels);
            m_fields->setPieces(m_shownPieces);
            m_fields->showGrowth(m_growthPlane);
            m_fields->showAtTolerance(m_atTolerance);
            requireNoError();
        } catch (const std::exception&) {
            opened = tl::unexpected(errorBeingHandled());
            close();
            m_textures.close();
            if (opened.error().code == core::ErrorCode::ContextLost)
                lose(opened.error());
        }
        publishProgress();
    });
    return opened;
}

void GpuEditEngine::close()
{
    m_transaction.reset();
    m_trace.reset();
    m_cutPreviewer.forget();
    m_growthMarks.forget();
    m_fields.reset();
    m_followUpsFailed = 0;
    m_followUpsFrom = {};
}

/// What the GPU holds is not what the session says: nothing more is read from it or written.
void GpuEditEngine::lose(const core::Error& why)
{
    if (contextLost())
        return;
    qCCritical(core::log, "What was open is lost on the graphics processor: %s",
        qUtf8Printable(why.arguments.join(QStringLiteral(": "))));
    close();
    m_lost = core::Error{core::ErrorCode::EngineLost, why.arguments};
    if (why.code == core::ErrorCode::OutOfMemory)
        m_lost->arguments = {core::Clause::saying("not enough memory: %1", why.arguments.value(0))};
    if (why.code != core::ErrorCode::ContextLost)
        return;
    m_idleWork.stop();
    m_lost = why;
    deliver({.error = why}); // nobody may be asking
}

void GpuEditEngine::showSegments(
    const std::bitset<256>& labels, const std::bitset<256>& translucent)
{
    m_shownLabels = labels;
    m_translucentLabels = translucent;
    if (m_fields)
        m_fields->setShownLabels(labels, translucent);
}

void GpuEditEngine::showPieces(const std::vector<PieceSource>& sources)
{
    m_shownPieces = sources;
    if (m_fields)
        m_fields->setPieces(sources);
}

void GpuEditEngine::showGrowth(std::uint8_t plane)
{
    m_growthPlane = plane;
    if (m_fields)
        m_fields->showGrowth(plane);
}

void GpuEditEngine::showAtTolerance(const std::optional<ToleranceDisplay>& shown)
{
    m_atTolerance = shown;
    if (m_fields)
        m_fields->showAtTolerance(shown);
}

void GpuEditEngine::warmUp()
{
    if (m_fields)
        m_idleWork.warmUp(m_fields->grid().volumeSize);
}

void GpuEditEngine::expectEditableRanges()
{
    m_expectsRanges = true;
    m_thread.wake();
}

std::size_t GpuEditEngine::brickBytes() const
{
    return m_fields ? m_fields->bytes() + m_cutPreviewer.bytes() + m_growthMarks.bytes() : 0;
}

/// What is thrown in spite of all that is caught below: of nothing is it known how far it came.
bool GpuEditEngine::work()
{
    try {
        return workUnguarded();
    } catch (const std::exception&) {
        lose(errorBeingHandled());
        publishProgress();
        return false;
    }
}

bool GpuEditEngine::workUnguarded()
{
    Waiting next;
    if (takeNext(next, m_transaction.get())) {
        carryOut(next);
        publishProgress();
        return true;
    }
    if (growthIsDue()) {
        const core::TraceSpan span("engine", "growth");
        try {
            growOneSlice();
            requireNoError();
        } catch (const std::exception&) {
            abandon(errorBeingHandled());
        }
        publishProgress();
        return true;
    }
    if (readingIsDue()) {
        const core::TraceSpan span("engine", "reading changes");
        try {
            readOneSlice();
            requireNoError();
        } catch (const std::exception&) {
            abandon(errorBeingHandled());
        }
        publishProgress();
        return true;
    }
    try {
        if (Clock::now() < m_followUpsFrom) {
            m_thread.wakeAt(m_followUpsFrom);
            requireContext();
            return false;
        }
        if (m_fields && m_expectsRanges)
            m_idleWork.warmUp(m_fields->grid().volumeSize, KernelWarmUp::Of::EditableRanges);
        const core::TraceSpan span("engine", "between edits", {.least = leastIdleWork});
        const bool more = m_idleWork.doSome(m_fields.get(), m_transaction != nullptr);
        requireNoError();
        m_followUpsFailed = 0;
        return more;
    } catch (const std::exception&) {
        followUpLater(errorBeingHandled());
        return false;
    }
}

/// Memory may be there again in a moment; what is shown meanwhile is what was.
void GpuEditEngine::followUpLater(const core::Error& why)
{
    constexpr int patience = 20;
    constexpr std::chrono::milliseconds pause{100};
    const bool forGood = why.code == core::ErrorCode::ContextLost;
    if (!m_fields && !forGood)
        return;
    if (forGood || ++m_followUpsFailed > patience) {
        m_followUpsFailed = 0;
        lose(why);
        publishProgress();
        return;
    }
    m_fields->deriveAnew();
    // Pictures and edits that go on meanwhile do not use the patience up.
    m_followUpsFrom = Clock::now() + pause;
    m_thread.wakeAt(m_followUpsFrom);
}

void GpuEditEngine::abandon(const core::Error& why)
{
    try {
        m_transaction->abandon(why);
    } catch (const ContextLost& lost) {
        lose(lost.error());
    } catch (const FieldsLost&) {
        lose(why);
    }
}

bool GpuEditEngine::growthIsDue()
{
    if (!m_transaction || !m_transaction->hasStepsLeft())
        return false;
    if (m_transaction->generationsPerSecond() <= 0.0)
        return true;
    return isDue(m_nextGeneration);
}

/// An edit that has changed much is read in parts before it is committed: whoever gives it up
/// meanwhile waits for one of them, and pictures are drawn in between.
bool GpuEditEngine::readingIsDue() const
{
    return m_transaction && !m_transaction->hasStepsLeft() && m_transaction->hasChangesToRead()
        && commitIsNext();
}

void GpuEditEngine::readOneSlice()
{
    const Clock::time_point start = Clock::now();
    m_transaction->readSomeChanges();
    m_editMilliseconds += millisecondsSince(start);
}

void GpuEditEngine::growOneSlice()
{
    const double pace = m_transaction->generationsPerSecond();
    const bool paced = pace > 0.0 && !inHurry();
    const Clock::time_point start = Clock::now();
    m_transaction->advance(paced ? 1 : m_ringsPerSlice);
    const double milliseconds = millisecondsSince(start);
    m_editMilliseconds += milliseconds;
    if (paced) {
        m_nextGeneration = start
            + std::chrono::duration_cast<Clock::duration>(
                std::chrono::duration<double>(1.0 / pace));
        return;
    }
    if (milliseconds > 2.0 * sliceMilliseconds)
        m_ringsPerSlice = std::max(m_ringsPerSlice / 2, 2);
    else if (milliseconds < sliceMilliseconds / 2.0)
        m_ringsPerSlice = std::min(m_ringsPerSlice * 2, GrowthKernel::ringsPerBatch);
}

void GpuEditEngine::publishProgress()
{
    publish(m_transaction ? m_transaction->progress() : core::GrowthProgress{});
}

void GpuEditEngine::carryOut(Waiting& next)
{
    const core::TraceSpan span = traced(next);
    const Clock::time_point start = Clock::now();
    Outcome outcome = attempt(next.command);
    const double milliseconds = millisecondsSince(start);
    if (outcome && !*outcome) {
        m_editMilliseconds += milliseconds;
        return;
    }
    core::EngineResult result = outcome ? std::move(**outcome) : core::EngineResult{};
    if (!outcome)
        result.error = outcome.error();
    result.ticket = next.ticket;
    result.statistics.milliseconds += milliseconds;
    deliver(std::move(result));
}

/// A command that throws has changed nothing, and an open edit that it belongs to is taken back.
GpuEditEngine::Outcome GpuEditEngine::attempt(core::EngineCommand& command)
{
    if (m_lost)
        return tl::unexpected(*m_lost);
    if (!m_fields)
        return refusal("volume", core::Clause::saying("none is open"));
    try {
        Outcome outcome = std::visit([this](auto& known) { return carryOut(known); }, command);
        requireNoError();
        return outcome;
    } catch (const FieldsLost& lost) {
        lose(lost.error());
        return tl::unexpected(*m_lost);
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        std::visit([&](const auto& known) { clearAfter(known, error); }, command);
        return tl::unexpected(m_lost.value_or(error));
    }
}

void GpuEditEngine::clearAfter(const core::ExtendEdit&, const core::Error& why)
{
    if (m_transaction)
        abandon(why);
}

void GpuEditEngine::clearAfter(const core::EndEdit&, const core::Error& why)
{
    if (m_transaction)
        abandon(why);
    if (!m_lost)
        m_transaction.reset();
}

void GpuEditEngine::clearAfter(const core::TraceTolerance&, const core::Error&)
{
    if (m_lost)
        return;
    m_trace.reset();
    m_fields->dropTolerance();
}

void GpuEditEngine::clearAfter(const core::PreviewCut&, const core::Error&)
{
    if (!m_lost)
        m_cutPreviewer.forget();
}

void GpuEditEngine::clearAfter(const core::CompareGrowth&, const core::Error&)
{
    if (!m_lost)
        m_growthMarks.forget();
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::BeginEdit& command)
{
    if (m_transaction)
        return refusal("transaction", core::Clause::saying("another edit is open"));
    hideTolerance();
    m_cutPreviewer.forget();
    const auto* growth = std::get_if<core::GrowBurst>(&command.edit);
    m_growthMarks.begin(growth ? std::optional(growth->plane) : std::nullopt);
    m_editMilliseconds = 0.0;
    auto transaction = EditTransaction::begin(m_programs, *m_fields, command.edit);
    if (!transaction)
        return tl::unexpected(transaction.error());
    m_transaction = std::move(*transaction);
    m_ringsPerSlice = GrowthKernel::ringsPerBatch;
    return std::nullopt;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ExtendEdit& command)
{
    if (!m_transaction)
        return refusal("transaction", core::Clause::saying("no edit is open"));
    if (m_transaction->abandoned())
        return std::nullopt; // told once, or when it ends
    const core::Result<void> extended = m_transaction->extend(command.extension);
    if (!extended)
        return tl::unexpected(extended.error());
    return std::nullopt;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::EndEdit& command)
{
    if (!m_transaction)
        return refusal("transaction", core::Clause::saying("no edit is open"));
    m_growthMarks.hide();
    if (const std::optional<core::Error> why = m_transaction->abandoned()) {
        m_transaction.reset();
        m_growthMarks.forget();
        return tl::unexpected(*why);
    }
    core::EngineResult result;
    if (command.ending == core::Ending::Commit)
        m_transaction->commit(result);
    else
        m_transaction->rollBack(result);
    requireNoError();
    result.statistics.milliseconds = m_editMilliseconds;
    const std::optional<std::uint8_t> growing = m_transaction->growingPlane();
    m_transaction.reset();
    endMarks(command.ending, growing, result.changes);
    return result;
}

/// The edit is worth more than its marks: where there is no memory for them there are none.
void GpuEditEngine::endMarks(core::Ending ending, std::optional<std::uint8_t> growing,
    std::span<const core::BrickChange> changes)
{
    try {
        if (ending == core::Ending::Rollback)
            m_growthMarks.restore(*m_fields);
        else if (growing && m_growthMarks.keeps())
            m_growthMarks.keep(*m_fields, compareGrowth(*m_fields, *growing, changes).bricks);
        else
            m_growthMarks.forget();
        requireNoError();
    } catch (const FieldsLost&) {
        throw;
    } catch (const std::exception&) {
        m_growthMarks.forget();
    }
}

void GpuEditEngine::hideTolerance()
{
    m_trace.reset();
    m_fields->hideTolerance();
}

} // namespace gpu
