// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/EditSession.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace gpu {
class GpuEngine;
}

namespace app {

/// The engine of a command, with the session on it. If the graphics driver loses its context
/// (ContextLost) both are made again in the same state, which is reported on stderr, and the
/// interrupted work is repeated; after a few times that becomes an error.
class SteadySession {
public:
    using Session = std::unique_ptr<core::EditSession>;
    /// A function that opens the study on an engine where nothing is open, and the session at its
    /// position.
    using Open = std::function<core::Result<Session>(gpu::GpuEngine&)>;

    SteadySession();
    ~SteadySession();
    SteadySession(const SteadySession&) = delete;
    SteadySession& operator=(const SteadySession&) = delete;

    /// Starts the engine; call it once, before everything else. Errors: those of
    /// GpuEngine::create().
    core::Result<void> start();
    /// @param first called again if the context is lost meanwhile
    /// @param again opens the session in its present state, after it was closed because an engine
    /// was lost
    core::Result<void> open(const Open& first, Open again);
    /// Does @p work, which is repeated from its beginning if the context is lost meanwhile; it
    /// learns from session() how far it had come. Errors: those of the work, and those of @p again
    /// of open(); after an error possibly no session is open.
    core::Result<void> carryOut(const std::function<core::Result<void>()>& work);

    [[nodiscard]] bool isOpen() const { return m_session != nullptr; }
    /// The session; it may be another object after each carryOut().
    /// @pre isOpen()
    [[nodiscard]] core::EditSession& session() const { return *m_session; }
    [[nodiscard]] gpu::GpuEngine& engine() const { return *m_engine; } ///< @pre start()
    /// The number of rows in its history, now or when it was last open.
    [[nodiscard]] std::size_t rowCount() const;
    /// Closes the session; its file is complete afterwards.
    void close();

private:
    core::Result<void> openAnew(const Open& how);

    std::unique_ptr<gpu::GpuEngine> m_engine;
    Session m_session; ///< declared after the engine, which it uses
    Open m_again;
    std::size_t m_rows = 0; ///< number of rows when it was closed
};

} // namespace app
