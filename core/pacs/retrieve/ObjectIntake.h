// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/retrieve/DownloadFolder.h"

#include <QSet>
#include <QString>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

struct T_DIMSE_C_StoreRQ;

namespace core {

class Association;

/// Stores the objects that a node sends (C-STORE), byte by byte, in a folder. Objects that are
/// damaged or were not requested are refused. Only for sources of core/pacs.
class ObjectIntake {
public:
    /// @param awaited SOP instance UIDs
    /// @param takesAll whether other objects are taken too, since not all of them are known
    ObjectIntake(const DownloadFolder& folder, const QSet<QString>& awaited, bool takesAll,
        const Progress& progress);

    /// Receives the object of a C-STORE request and answers. An error ends the transfer: those of
    /// the connection, and FileUnwritable.
    [[nodiscard]] Result<void> take(
        Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request);

    /// Sets a function that is called on the receiving thread for each piece of a requested object.
    /// Call this while nothing is being received.
    void setOnPiece(std::function<void()> onPiece) { m_onPiece = std::move(onPiece); }
    /// How many pieces of requested objects have come.
    [[nodiscard]] std::int64_t pieces() const { return m_pieces; }
    [[nodiscard]] int received() const { return m_received; }
    [[nodiscard]] const QSet<QString>& missing() const { return m_missing; }
    /// Why the first damaged object was refused.
    [[nodiscard]] const std::optional<Error>& refusal() const { return m_refusal; }

private:
    [[nodiscard]] Result<std::uint16_t> write(
        Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request);

    const DownloadFolder& m_folder;
    bool m_takesAll;
    QSet<QString> m_missing;
    int m_total; ///< 0: unknown
    std::atomic<int> m_received = 0; ///< read while a listener receives objects
    std::atomic<std::int64_t> m_pieces = 0; ///< likewise
    std::function<void()> m_onPiece;
    std::optional<Error> m_refusal;
    const Progress& m_progress;
};

} // namespace core
