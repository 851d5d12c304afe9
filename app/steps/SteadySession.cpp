// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SteadySession.h"

#include "gpu/engine/GpuEngine.h"

#include <cstdio>
#include <utility>

namespace app {

namespace {

using core::Result;

/// In one piece of work. A processor that is reset each time it is asked for this is reset by it.
constexpr int mostLosses = 3;

template <class Value> bool isLoss(const Result<Value>& done)
{
    return !done && done.error().code == core::ErrorCode::ContextLost;
}

void reportLoss(const core::Error& error)
{
    std::fprintf(stderr,
        "burin: the graphics driver broke off its work (%s); it is begun anew, where the session "
        "stands\n",
        qUtf8Printable(error.arguments.value(0)));
}

} // namespace

SteadySession::SteadySession() = default;
SteadySession::~SteadySession() = default;

Result<void> SteadySession::start()
{
    auto engine = gpu::GpuEngine::create();
    for (int losses = 0; isLoss(engine) && losses < mostLosses; ++losses)
        engine = gpu::GpuEngine::create();
    if (!engine)
        return tl::unexpected(engine.error());
    m_engine = *std::move(engine);
    return {};
}

Result<void> SteadySession::open(const Open& first, Open again)
{
    m_again = first;
    bool isOpening = true;
    const Result<void> opened = carryOut([&] {
        // After a loss it has been opened by then.
        return std::exchange(isOpening, false) ? openAnew(first) : Result<void>();
    });
    m_again = std::move(again);
    return opened;
}

/// @pre none is open
Result<void> SteadySession::openAnew(const Open& how)
{
    Result<Session> opened = how(*m_engine);
    if (!opened)
        return tl::unexpected(opened.error());
    m_session = *std::move(opened);
    return {};
}

Result<void> SteadySession::carryOut(const std::function<Result<void>()>& work)
{
    Result<void> done = work();
    for (int losses = 0; isLoss(done) && losses < mostLosses; ++losses) {
        reportLoss(done.error());
        close();
        done = m_engine->renew();
        if (done)
            done = openAnew(m_again);
        if (done)
            done = work();
    }
    return done;
}

std::size_t SteadySession::rowCount() const
{
    return m_session ? m_session->history().rows().size() : m_rows;
}

void SteadySession::close()
{
    m_rows = rowCount();
    m_session.reset();
}

} // namespace app
