// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/retrieve/DownloadFolder.h"

#include <QSet>
#include <QString>

#include <atomic>
#include <cstdint>
#include <optional>

struct T_DIMSE_C_StoreRQ;

namespace core {

class Association;

/// Takes the objects that a node stores at us, byte for byte, into a folder. What is not sound is
/// refused, and so is what nobody asked for. Only for sources of core/pacs.
class ObjectIntake {
public:
    /// @param awaited SOP instance UIDs; empty: whatever comes
    ObjectIntake(const DownloadFolder& folder, const QSet<QString>& awaited, int total,
        const Progress& progress);

    /// Receives the object of a C-STORE request and answers. An error ends the transfer: the
    /// connection's, and FileUnwritable.
    [[nodiscard]] Result<void> take(
        Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request);

    [[nodiscard]] int received() const { return m_received; }
    [[nodiscard]] const QSet<QString>& missing() const { return m_missing; }
    /// Why the first of those that are not sound was refused.
    [[nodiscard]] const std::optional<Error>& refusal() const { return m_refusal; }

private:
    [[nodiscard]] Result<std::uint16_t> write(
        Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request);

    const DownloadFolder& m_folder;
    bool m_takesAll;
    QSet<QString> m_missing;
    int m_total;
    std::atomic<int> m_received = 0; ///< looked at while a listener takes objects
    std::optional<Error> m_refusal;
    const Progress& m_progress;
};

} // namespace core
