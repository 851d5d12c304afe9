// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionWrites.h"

#include "core/base/Guarded.h"
#include "core/sessionfile/records/SessionTables.h"

#include <algorithm>

namespace core {

std::optional<Error> SessionWrites::carryOut(SessionTables& tables, const QString& path)
{
    while (!m_waiting.empty()) {
        Result<void> written = guarded([&] { return m_waiting.front().carryOut(tables); });
        // It waits like what the disk does not take.
        if (!written && written.error().code != ErrorCode::FileUnwritable)
            written.error() = {
                ErrorCode::FileUnwritable, {path, written.error().arguments.value(0)}};
        if (!written)
            return written.error();
        m_waiting.pop_front();
    }
    return std::nullopt;
}

Result<void> SessionWrites::carryOutIn(SessionTables& copy) const
{
    for (const SessionWrite& write : m_waiting) {
        if (const Result<void> written = write.carryOut(copy); !written)
            return written;
    }
    return {};
}

bool SessionWrites::holdStep() const
{
    return std::any_of(
        m_waiting.begin(), m_waiting.end(), [](const SessionWrite& write) { return write.isStep; });
}

const QByteArray* SessionWrites::pictureOf(RowId row) const
{
    const auto waits = std::find_if(m_waiting.rbegin(), m_waiting.rend(),
        [row](const SessionWrite& write) { return !write.picture.isEmpty() && write.row == row; });
    return waits == m_waiting.rend() ? nullptr : &waits->picture;
}

const BrickDelta* SessionWrites::deltaOf(RowId row) const
{
    const auto waits = std::find_if(m_waiting.begin(), m_waiting.end(),
        [row](const SessionWrite& write) { return write.delta && write.row == row; });
    return waits == m_waiting.end() ? nullptr : waits->delta.get();
}

} // namespace core
