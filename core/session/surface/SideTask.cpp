// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SideTask.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace core {

SideWatch::SideWatch()
    : progress([this](ProgressStep, int done, int total) {
        constexpr std::int64_t percents = 100;
        percent = int(percents * done / std::max(1, total));
    })
{
}

void SideTask::post(SideThread& side, SideThread::Work work, SideThread::Failed failed)
{
    side.post(
        [this, work = std::move(work)] {
            return SideThread::Sequel([this, then = work()](SessionState& known) {
                if (comeBack())
                    then(known);
            });
        },
        [this, failed = std::move(failed)](SessionState& known, const Error& error) {
            if (comeBack())
                failed(known, error);
        });
    m_isAway = true;
}

void SideTask::giveUp(std::function<void()> instead)
{
    if (m_isAway)
        m_instead = std::move(instead);
    else
        instead();
}

bool SideTask::comeBack()
{
    m_isAway = false;
    if (!m_instead)
        return true;
    std::exchange(m_instead, nullptr)();
    return false;
}

} // namespace core
