// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/RobotLog.h"

#include <ctime>

namespace reenact {

RobotLog::RobotLog(RefinementBench& bench, const Truth& truth)
    : m_bench(bench)
    , m_truth(truth)
    , m_seen(bench.seen())
    , m_error(truth.errorOf(m_seen))
    , m_plainError(truth.plainErrorOf(m_seen))
{
}

QString RobotLog::timed(const core::Edit& edit)
{
    const std::clock_t start = std::clock();
    QString why = m_bench.tried(edit);
    m_run.seconds += double(std::clock() - start) / double(CLOCKS_PER_SEC);
    return why;
}

void RobotLog::note(const QString& what)
{
    m_run.log
        << QStringLiteral("%1 %2: %3 %").arg(m_run.actions, 3).arg(what).arg(m_error, 0, 'f', 2);
    if (m_run.actionsToCommon == 0 && m_error <= commonError)
        m_run.actionsToCommon = m_run.actions;
}

bool RobotLog::act(const core::Edit& edit, const QString& what)
{
    ++m_run.actions;
    if (const QString why = timed(edit); !why.isEmpty()) {
        note(what + QStringLiteral(" refused, ") + why);
        return false;
    }
    const Mask before = m_seen;
    m_seen = m_bench.seen();
    const double error = m_truth.errorOf(m_seen);
    const double plainError = m_truth.plainErrorOf(m_seen);
    if (plainError > m_plainError) {
        const bool isChanged = differing(before, m_seen) > 0;
        note(what + QStringLiteral(" (%1 %, taken back)").arg(error, 0, 'f', 2));
        if (isChanged && m_bench.undone().isEmpty())
            ++m_run.actions;
        m_seen = before;
        return false;
    }
    m_error = error;
    m_plainError = plainError;
    note(what);
    return differing(before, m_seen) > 0;
}

bool RobotLog::prepare(const core::Edit& edit, const QString& what)
{
    ++m_run.actions;
    if (const QString why = timed(edit); !why.isEmpty()) {
        note(what + QStringLiteral(" refused, ") + why);
        return false;
    }
    m_seen = m_bench.seen();
    m_error = m_truth.errorOf(m_seen);
    m_plainError = m_truth.plainErrorOf(m_seen);
    note(what);
    return true;
}

void RobotLog::countOne(const QString& what)
{
    ++m_run.actions;
    note(what);
}

RobotRun RobotLog::finished()
{
    m_run.mask = m_bench.segment();
    return m_run;
}

} // namespace reenact
