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

/// The engine of a command, and the session on it. Where the graphics driver loses its context
/// (ContextLost) both are made anew as they stood, which is told on stderr, and what was under way
/// is done again; a few times, then that is the error.
class SteadySession {
public:
    using Session = std::unique_ptr<core::EditSession>;
    /// Puts the study on an engine where nothing is open, and the session at its position.
    using Open = std::function<core::Result<Session>(gpu::GpuEngine&)>;

    SteadySession();
    ~SteadySession();
    SteadySession(const SteadySession&) = delete;
    SteadySession& operator=(const SteadySession&) = delete;

    /// Starts the engine. Once, before all else. Errors: those of GpuEngine::create().
    core::Result<void> start();
    /// @param first called once more where the context is lost meanwhile
    /// @param again the session as it stands: after it has been closed on an engine that was lost
    core::Result<void> open(const Open& first, Open again);
    /// Does @p work, which is done from its beginning where the context is lost meanwhile; it finds
    /// out by session() how far it had come. Errors: its own, and those of @p again of open(); then
    /// no session may be open.
    core::Result<void> carryOut(const std::function<core::Result<void>()>& work);

    [[nodiscard]] bool isOpen() const { return m_session != nullptr; }
    /// Another one after each carryOut(). @pre isOpen()
    [[nodiscard]] core::EditSession& session() const { return *m_session; }
    [[nodiscard]] gpu::GpuEngine& engine() const { return *m_engine; } ///< @pre start()
    /// How many rows its history has, or had when it was last open.
    [[nodiscard]] std::size_t rowCount() const;
    /// The session's file is whole after it.
    void close();

private:
    core::Result<void> openAnew(const Open& how);

    std::unique_ptr<gpu::GpuEngine> m_engine;
    Session m_session; ///< after the engine, which it borrows
    Open m_again;
    std::size_t m_rows = 0; ///< when it was closed
};

} // namespace app
