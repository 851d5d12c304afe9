// SPDX-License-Identifier: Apache-2.0
#include "core/fence/FencedDecoder.h"

#include "core/base/Log.h"

#include <mutex>
#include <thread>
#include <vector>

namespace core {

namespace {

using std::chrono::milliseconds;

/// Of a processor: more than a frame of any scanner takes; what takes longer hangs.
constexpr milliseconds usualPatience{9000};
constexpr milliseconds startPatience{60000};
/// What a decoder may keep while it waits.
constexpr std::size_t keptBytes = std::size_t(64) << 20;

Clause textOf(WorkerProcess::Outcome outcome)
{
    switch (outcome) {
    case WorkerProcess::Outcome::TooSlow:
        return Clause::saying("the decoder took too long and was stopped");
    case WorkerProcess::Outcome::Nonsense:
        return Clause::saying("the decoder answered nonsense and was stopped");
    case WorkerProcess::Outcome::NoMemory:
        return Clause::saying("no memory for its pixel data");
    case WorkerProcess::Outcome::Stopped:
    case WorkerProcess::Outcome::Killed:
    case WorkerProcess::Outcome::Done:
    case WorkerProcess::Outcome::Refused:
        break;
    }
    return Clause::saying("the decoder stopped");
}

} // namespace

struct FencedDecoder::State {
    mutable std::mutex mutex;
    WorkerProgram program;
    FencedWork inside = nullptr;
    milliseconds patience = usualPatience;
    std::vector<std::unique_ptr<WorkerProcess>> idle;
    bool saidUnfiltered = false;
};

FencedDecoder& FencedDecoder::instance()
{
    static FencedDecoder decoder;
    return decoder;
}

FencedDecoder::FencedDecoder()
    : m_state(std::make_unique<State>())
{
}

FencedDecoder::~FencedDecoder() = default;

void FencedDecoder::setProgram(const WorkerProgram& program)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->program = program;
    m_state->inside = nullptr;
    m_state->idle.clear();
}

void FencedDecoder::decodeInside(FencedWork work)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->inside = work;
    m_state->idle.clear();
}

void FencedDecoder::setPatience(milliseconds patience)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->patience = patience;
}

std::vector<pid_t> FencedDecoder::idle() const
{
    const std::lock_guard lock(m_state->mutex);
    std::vector<pid_t> all;
    for (const std::unique_ptr<WorkerProcess>& worker : m_state->idle)
        all.push_back(worker->id());
    return all;
}

std::unique_ptr<WorkerProcess> FencedDecoder::borrow(Clause& why)
{
    WorkerProgram program;
    {
        const std::lock_guard lock(m_state->mutex);
        while (!m_state->idle.empty()) {
            std::unique_ptr<WorkerProcess> worker = std::move(m_state->idle.back());
            m_state->idle.pop_back();
            if (worker->isWaiting())
                return worker;
        }
        program = m_state->program;
    }
    if (program.path.isEmpty()) {
        why = Clause::saying("the decoder cannot be started: nothing says which program it is");
        return nullptr;
    }
    std::unique_ptr<WorkerProcess> worker = WorkerProcess::start(program, startPatience, why);
    if (!worker) {
        why = Clause::saying("the decoder cannot be started: %1", why);
        return nullptr;
    }
    const std::lock_guard lock(m_state->mutex);
    if (!worker->isFiltered() && !m_state->saidUnfiltered) {
        m_state->saidUnfiltered = true;
        qCWarning(log,
            "This system cannot filter the system calls of decoders; they are bounded "
            "in memory, time and files only");
    }
    return worker;
}

void FencedDecoder::giveBack(std::unique_ptr<WorkerProcess> worker)
{
    if (worker->sharedBytes() > keptBytes)
        return;
    const std::lock_guard lock(m_state->mutex);
    const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
    if (m_state->idle.size() < most)
        m_state->idle.push_back(std::move(worker));
}

Clause FencedDecoder::decode(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> input, std::size_t outputBytes,
    const std::function<void(std::span<const std::uint8_t> output)>& take)
{
    FencedWork inside = nullptr;
    milliseconds patience{};
    {
        const std::lock_guard lock(m_state->mutex);
        inside = m_state->inside;
        patience = m_state->patience;
    }
    if (inside) {
        std::vector<std::uint8_t> output(outputBytes);
        const Clause wrong = inside(parameters, input, output);
        if (wrong.isEmpty())
            take(output);
        return wrong;
    }
    // A decoder that somebody else ended, as the kernel does when memory is short, says nothing
    // about the bytes: they get another one.
    constexpr int attempts = 2;
    for (int attempt = 1;; ++attempt) {
        Clause why;
        std::unique_ptr<WorkerProcess> worker = borrow(why);
        if (!worker)
            return why;
        const WorkerProcess::Answer answer = worker->ask(parameters, input, outputBytes, patience);
        using Outcome = WorkerProcess::Outcome;
        if (answer.outcome == Outcome::Done)
            take(answer.output);
        if (answer.outcome == Outcome::Done || answer.outcome == Outcome::Refused) {
            giveBack(std::move(worker));
            return answer.sentence;
        }
        if (answer.outcome != Outcome::Killed || attempt == attempts)
            return textOf(answer.outcome);
    }
}

} // namespace core
